// The four functions that GCC calls on its own even when freestanding. This file is compiled with
// -fno-tree-loop-distribute-patterns, or the loops here would be turned into calls of themselves.
#include <stddef.h>
#include <stdint.h>

extern "C" {
void* memcpy(void* destination, const void* source, size_t size);
void* memmove(void* destination, const void* source, size_t size);
void* memset(void* destination, int value, size_t size);
int memcmp(const void* left, const void* right, size_t size);
}

namespace {

using Byte = unsigned char;
using Word [[gnu::may_alias]] = uint32_t;

bool is_word_aligned(const void* address) { return (reinterpret_cast<uintptr_t>(address) & 3) == 0; }

}  // namespace

void* memcpy(void* destination, const void* source, size_t size) {
  auto* to = static_cast<Byte*>(destination);
  const auto* from = static_cast<const Byte*>(source);
  if (is_word_aligned(to) && is_word_aligned(from)) {
    for (; size >= 4; size -= 4, to += 4, from += 4) {
      *reinterpret_cast<Word*>(to) = *reinterpret_cast<const Word*>(from);
    }
  }
  while (size-- != 0) *to++ = *from++;
  return destination;
}

void* memmove(void* destination, const void* source, size_t size) {
  auto* to = static_cast<Byte*>(destination);
  const auto* from = static_cast<const Byte*>(source);
  // Ascending copies are safe unless the destination begins inside the source.
  if (reinterpret_cast<uintptr_t>(to) - reinterpret_cast<uintptr_t>(from) >= size) {
    return memcpy(destination, source, size);
  }
  while (size-- != 0) to[size] = from[size];
  return destination;
}

void* memset(void* destination, int value, size_t size) {
  auto* to = static_cast<Byte*>(destination);
  const auto byte = static_cast<Byte>(value);
  if (is_word_aligned(to)) {
    const uint32_t word = 0x01010101u * byte;
    for (; size >= 4; size -= 4, to += 4) *reinterpret_cast<Word*>(to) = word;
  }
  while (size-- != 0) *to++ = byte;
  return destination;
}

int memcmp(const void* left, const void* right, size_t size) {
  const auto* a = static_cast<const Byte*>(left);
  const auto* b = static_cast<const Byte*>(right);
  for (; size-- != 0; ++a, ++b) {
    if (*a != *b) return *a < *b ? -1 : 1;
  }
  return 0;
}
