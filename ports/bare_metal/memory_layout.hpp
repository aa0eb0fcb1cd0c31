// Where the linker script (sections.ld) puts what start-up prepares.
#pragma once

#include <stdint.h>

extern "C" {
extern uintptr_t stack_bottom[];  // the lowest address of RAM
extern uintptr_t stack_top[];
extern uint32_t data_start[];
extern uint32_t data_end[];
extern const uint32_t data_initial_values[];
extern uint32_t bss_start[];
extern uint32_t bss_end[];
}
