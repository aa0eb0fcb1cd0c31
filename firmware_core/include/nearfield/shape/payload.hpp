// Payloads of operations as the words of an image.
#pragma once

#include <nearfield/number/vector.hpp>

namespace nearfield::detail {

// Words as a value: a copy that compilers turn into loads of what is used, where they know that words are aligned.
template <class T>
T words_as(const uint32_t* words) {
  T value;
  if constexpr (!__is_empty(T)) {
    const void* const aligned = __builtin_assume_aligned(words, alignof(uint32_t));
    __builtin_memcpy(static_cast<void*>(&value), aligned, sizeof(T));
  }
  return value;
}
template <class T>
Vector3<T> vector_as(const uint32_t* words) {
  return {words_as<T>(words), words_as<T>(words + 1), words_as<T>(words + 2)};
}

}  // namespace nearfield::detail
