// Writes program images, on the host or in a constant expression.
#pragma once

#include <nearfield/field/image.hpp>

namespace nearfield {

// Collects tables first, then operations in postfix order, then finish(). Capacity in 32-bit words.
// Nothing is reported before finish(), whose status is that of the image as a loader will see it; a full builder
// gives wrong_size. Operations: those that it can check (OnlyOperations<...>); others are unknown to it.
template <class S, uint32_t Capacity, class Operations = AllOperations> class ImageBuilder {
 public:
  // Returns the table's reference for shape() and blend(). Precondition: no operation was added yet.
  template <int segments> constexpr uint32_t table(const Table<S, segments>& table) {
    static_assert(segments == 1 << index_bits_for(segments), "tables of images have a power of two of segments");
    const uint32_t reference = size_;
    append(static_cast<uint32_t>(table.index_bits));
    append(static_cast<uint32_t>(table.slope_headroom));
    append(static_cast<uint32_t>(table.facts.error));
    append(static_cast<uint32_t>(table.facts.slope_error));
    append(static_cast<uint32_t>(table.facts.least_value));
    append(static_cast<uint32_t>(table.facts.greatest_value));
    append(static_cast<uint32_t>(table.facts.least_slope));
    append(static_cast<uint32_t>(table.facts.greatest_slope));
    for (const uint32_t coefficient : table.coefficients) append(coefficient);
    words_[image_format::table_words] = size_ - image_format::header_words;
    return reference;
  }

  // A shape or blend; those with a table take its reference.
  template <class T> constexpr ImageBuilder& operation(const T& payload) {
    static_assert(!detail::uses_table<T>, "this operation needs a table's reference");
    append(static_cast<uint32_t>(OperationOf<T>::value) | payload_words<T> << 8);
    append_payload(payload);
    return *this;
  }
  template <class T> constexpr ImageBuilder& operation(const T& payload, uint32_t table_reference) {
    static_assert(detail::uses_table<T>, "this operation has no table");
    append(static_cast<uint32_t>(OperationOf<T>::value) | (payload_words<T> + 1) << 8);
    append_payload(payload);
    append(table_reference);
    return *this;
  }
  constexpr ImageBuilder& enter(const Pose<S>& pose) {
    append(static_cast<uint32_t>(Operation::enter_pose) | payload_words<Pose<S>> << 8);
    append_payload(pose);
    return *this;
  }
  constexpr ImageBuilder& enter_slot(uint32_t slot) {
    append(static_cast<uint32_t>(Operation::enter_slot) | 1u << 8);
    append(slot);
    return *this;
  }
  constexpr ImageBuilder& enter_box(const Vector3<S>& half_extents) {
    append(static_cast<uint32_t>(Operation::enter_box) | payload_words<Vector3<S>> << 8);
    append_payload(half_extents);
    return *this;
  }
  // The same half extents again, with the field's Lipschitz constant over the box.
  constexpr ImageBuilder& leave_box(const DeclaredBox<S>& box) {
    append(static_cast<uint32_t>(Operation::leave_box) | payload_words<DeclaredBox<S>> << 8);
    append_payload(box);
    return *this;
  }
  // Of a field of that kind.
  constexpr ImageBuilder& enter_scale(const UniformScale<S>& scale, Kind kind) {
    append(static_cast<uint32_t>(Operation::enter_scale) | (payload_words<UniformScale<S>> + 1) << 8);
    append_payload(scale);
    append(static_cast<uint32_t>(kind));
    return *this;
  }
  constexpr ImageBuilder& leave_scale() {
    append(static_cast<uint32_t>(Operation::leave_scale));
    return *this;
  }
  constexpr ImageBuilder& leave() {
    append(static_cast<uint32_t>(Operation::leave));
    return *this;
  }

  // Writes header and checksum. With any status but ok the image will not load, and says the same.
  constexpr Inspection<S> finish() {
    using namespace image_format;
    Inspection<S> found;
    if (overflowed_) {
      found.status = LoadStatus::wrong_size;
      return found;
    }
    found = detail::inspect_operations<S, Operations>(words_, header_words + words_[table_words], size_);
    detail::write_header(words_, words_[table_words], size_, found);
    return found.status == LoadStatus::ok ? inspect_image<S, Operations>(words_, size_) : found;
  }

  constexpr const uint32_t* words() const { return words_; }
  constexpr uint32_t size() const { return size_; }

 private:
  constexpr void append(uint32_t word) {
    if (size_ < Capacity) words_[size_++] = word;
    else overflowed_ = true;
  }
  template <class T> constexpr void append_payload(const T& payload) {
    if constexpr (payload_words<T> != 0) {
      const auto words = bits_as<detail::Words<payload_words<T>>>(payload);
      for (const uint32_t word : words.word) append(word);
    }
  }

  uint32_t words_[Capacity] = {};
  uint32_t size_ = image_format::header_words;
  bool overflowed_ = false;
};

}  // namespace nearfield
