// The greatest stack used, found by painting the unused part and looking for the deepest word that changed.
// Start-up paints the whole stack, so that without another call the figure is that of the program so far. A
// word that is reserved but never written, or written with the pattern itself, is not seen.
#pragma once

#include <stddef.h>
#include <stdint.h>

namespace nearfield::board {

// Paints everything below the stack that is in use.
void paint_unused_stack();

// Bytes between the top of the stack and the deepest word written since paint_unused_stack().
size_t greatest_stack_bytes();

// Bytes of the whole stack.
size_t stack_size_bytes();

}  // namespace nearfield::board
