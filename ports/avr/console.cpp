#include <board/console.hpp>

// Freestanding, so a function like others; avr-libc's start-up calls the one of the next line.
int main();
extern "C" void call_main() asm("main");
void call_main() { nearfield::board::exit_with_status(main()); }

namespace nearfield::board {
namespace {

// USART 0.
volatile uint8_t& register_at(uintptr_t address) { return *reinterpret_cast<volatile uint8_t*>(address); }
constexpr uintptr_t kStatus = 0xC0, kControl = 0xC1, kData = 0xC6;
constexpr uint8_t kEmpty = 1 << 5, kTransmit = 1 << 3;

}  // namespace

void write(const char* bytes, size_t size) {
  register_at(kControl) = kTransmit;
  for (; size != 0; --size) {
    while ((register_at(kStatus) & kEmpty) == 0) {
    }
    register_at(kData) = static_cast<uint8_t>(*bytes++);
  }
}

// The emulator ends when the core sleeps without interrupts. It knows no status, so that is the last line.
void exit_with_status(int status) {
  write("exit status ");
  write_decimal(static_cast<uint64_t>(status & 0xff));
  write("\n");
  for (;;) asm volatile("cli\n sleep");
}

}  // namespace nearfield::board
