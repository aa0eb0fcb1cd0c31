#include <board/stack_watermark.hpp>

#include <core.hpp>

#include <bare_metal/memory_layout.hpp>

namespace nearfield::board {
namespace {

constexpr uintptr_t kPattern = 0xA5C3963C;

// The deepest word that is not as painted.
const volatile uintptr_t* deepest_changed_word() {
  const volatile uintptr_t* word = stack_bottom;
  while (word != stack_top && *word == kPattern) ++word;
  return word;
}

size_t bytes_between(const volatile uintptr_t* low, uintptr_t high) {
  return high - reinterpret_cast<uintptr_t>(low);
}

}  // namespace

// Paints no word of its own frame: that lies above the stack pointer.
[[gnu::noinline]] void paint_unused_stack() {
  auto* const end = reinterpret_cast<volatile uintptr_t*>(stack_pointer());
  for (volatile uintptr_t* word = stack_bottom; word < end; ++word) *word = kPattern;
}

size_t greatest_stack_bytes() {
  return bytes_between(deepest_changed_word(), reinterpret_cast<uintptr_t>(stack_top));
}

size_t stack_size_bytes() { return bytes_between(stack_bottom, reinterpret_cast<uintptr_t>(stack_top)); }

}  // namespace nearfield::board
