// From reset to main(): FPU if the image uses it, memory, write protection of the code if the core has a
// memory protection unit; and what faults do.
#include <bare_metal/memory_layout.hpp>
#include <bare_metal/startup.hpp>
#include <board/console.hpp>

extern "C" {
void reset_handler();
void fault_handler();
void protect_code();
[[noreturn]] void report_fault(const uint32_t* frame, uint32_t exception_number);
}

namespace {

using nearfield::board::exit_with_status;
using nearfield::board::kFaultExitStatus;
using nearfield::board::write;
using nearfield::board::write_hexadecimal;

// Armv7-M and Armv8-M have what Armv6-M lacks: registers that say what a fault was, and a memory protection unit on
// all boards here. Without that a stack that grows out of RAM meets no memory, which is a fault as well.
constexpr bool kHasFaultRegisters = __ARM_ARCH >= 7;
constexpr bool kHasMemoryProtection = __ARM_ARCH >= 7;

constexpr uintptr_t kConfigurableFaultStatus = 0xE000ED28;
constexpr uintptr_t kMemoryFaultAddress = 0xE000ED34;
constexpr uintptr_t kBusFaultAddress = 0xE000ED38;
constexpr uintptr_t kMpuControl = 0xE000ED94;
constexpr uintptr_t kMpuRegionNumber = 0xE000ED98;
constexpr uintptr_t kMpuRegionBase = 0xE000ED9C;
constexpr uintptr_t kMpuRegionAttributes = 0xE000EDA0;  // of Armv8-M the last address
constexpr uintptr_t kMpuMemoryTypes = 0xE000EDC0;

uint32_t read_register(uintptr_t address) { return *reinterpret_cast<const volatile uint32_t*>(address); }

void write_register(uintptr_t address, uint32_t value) {
  *reinterpret_cast<volatile uint32_t*>(address) = value;
}

void write_field(const char* name, uint32_t value) {
  write(name);
  write_hexadecimal(value, 8);
}

using Handler = void (*)();

struct VectorTable {
  uintptr_t* initial_stack_pointer;
  Handler handlers[15];
};

// No interrupt is ever enabled, so the table ends with the system exceptions.
[[gnu::section(".reset"), gnu::used]] const VectorTable kVectorTable = {
    stack_top,
    {reset_handler, fault_handler, fault_handler, fault_handler, fault_handler, fault_handler, fault_handler,
     fault_handler, fault_handler, fault_handler, fault_handler, fault_handler, fault_handler, fault_handler,
     fault_handler}};

}  // namespace

[[gnu::naked]] void reset_handler() {
  asm volatile(
#ifdef __ARM_FP
      "ldr r0, =0xE000ED88   \n"  // CPACR: full access to the FPU, coprocessors 10 and 11
      "ldr r1, [r0]          \n"
      "orr r1, r1, #0xF00000 \n"
      "str r1, [r0]          \n"
      "dsb                   \n"
      "isb                   \n"
#endif
      "bl initialise_memory  \n"
      "bl protect_code       \n"
      "bl main               \n"
      "bl exit_after_main    \n");
}

// The lowest 512 MiB become read-only: the code, address zero, and what a stack grows into that is too large, unless
// there is no memory anyway.
void protect_code() {
  if constexpr (!kHasMemoryProtection) return;
  constexpr uint32_t kEnable = 1;
  constexpr uint32_t kDefaultMapElsewhere = 1u << 2;
  write_register(kMpuRegionNumber, 0);
  if constexpr (__ARM_ARCH == 7) {
    constexpr uint32_t kReadOnly = 6u << 24;
    constexpr uint32_t kSize512MiB = 28u << 1;
    write_register(kMpuRegionBase, 0);
    write_register(kMpuRegionAttributes, kReadOnly | kSize512MiB | kEnable);
  } else {
    constexpr uint32_t kReadOnly = 2u << 1;
    constexpr uint32_t kNormalMemory = 0x44;
    write_register(kMpuMemoryTypes, kNormalMemory);
    write_register(kMpuRegionBase, kReadOnly);
    write_register(kMpuRegionAttributes, 0x1FFFFFE0 | kEnable);
  }
  write_register(kMpuControl, kDefaultMapElsewhere | kEnable);
  asm volatile("dsb\n isb" ::: "memory");
}

// After a stack overflow the registers were not stacked and nothing can be called, so the report then runs on
// a fresh stack and gets no frame.
[[gnu::naked]] void fault_handler() {
  asm volatile(
      "mrs r1, ipsr           \n"
      "mov r0, sp             \n"
      "ldr r3, =stack_bottom  \n"
      "cmp r0, r3             \n"
      "bhs 1f                 \n"
      "movs r0, #0            \n"
      "ldr r2, =stack_top     \n"
      "mov sp, r2             \n"
      "1: bl report_fault     \n");
}

void report_fault(const uint32_t* frame, uint32_t exception_number) {
  write_field("fault: exception ", exception_number);
  if (frame != nullptr) {
    write_field(", pc ", frame[6]);
    write_field(", lr ", frame[5]);
  } else {
    write(", stack overflow");
  }
  if constexpr (kHasFaultRegisters) {
    write_field(", CFSR ", read_register(kConfigurableFaultStatus));
    write_field(", MMFAR ", read_register(kMemoryFaultAddress));
    write_field(", BFAR ", read_register(kBusFaultAddress));
  }
  write("\n");
  exit_with_status(kFaultExitStatus);
}
