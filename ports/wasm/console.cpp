#include <board/console.hpp>

// Freestanding, so a function like others.
int main();

extern "C" {
// Given by toolchains/wasm.mjs.
[[clang::import_module("console"), clang::import_name("write")]] void write_bytes(const char* bytes, size_t size);
[[noreturn, clang::import_module("console"), clang::import_name("exit")]] void exit_process(int status);

[[clang::export_name("_start")]] void start() { nearfield::board::exit_with_status(main()); }
}

namespace nearfield::board {

void write(const char* bytes, size_t size) { write_bytes(bytes, size); }

void exit_with_status(int status) { exit_process(status & 0xff); }

}  // namespace nearfield::board
