// The greatest stack used, found by painting the unused part and looking for the deepest word that changed.
// Start-up paints the whole stack, so that without another call the figure is that of the program so far. A
// word that is reserved but never written, or written with the pattern itself, is not seen.
#pragma once

#include <stddef.h>
#include <stdint.h>

namespace nearfield::mps2 {

// Paints everything below the caller's stack pointer.
void paint_unused_stack();

// Bytes between the caller's stack pointer and the deepest word written since paint_unused_stack(), when both
// are called from the same function: what the calls between them used.
size_t stack_bytes_below_caller();

// Bytes between the top of the stack and the deepest word written since paint_unused_stack().
size_t greatest_stack_bytes();

// Bytes of the whole stack.
size_t stack_size_bytes();

}  // namespace nearfield::mps2
