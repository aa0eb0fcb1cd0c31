#include "startup.hpp"

#include <bare_metal/memory_layout.hpp>
#include <board/console.hpp>
#include <board/stack_watermark.hpp>

void initialise_memory() {
  const uint32_t* initial_value = data_initial_values;
  for (uint32_t* word = data_start; word != data_end; ++word) *word = *initial_value++;
  for (uint32_t* word = bss_start; word != bss_end; ++word) *word = 0;
  nearfield::board::paint_unused_stack();
}

void exit_after_main(int status) { nearfield::board::exit_with_status(status); }
