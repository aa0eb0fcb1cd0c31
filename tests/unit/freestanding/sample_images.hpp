// Images to damage in tests. Freestanding.
#pragma once

#include <golden/query_stream.hpp>

#include <gtest/gtest.h>

namespace nearfield::test {

// What programs may have: everything; on a target the operations of the stream and two scalars, which take a fifth of
// the time to compile.
#ifdef NEARFIELD_CORE
using Operations = golden::StreamOperations;
using ImageScalars = testing::Types<Fixed<27>, float>;
#else
using Operations = AllOperations;
using ImageScalars = testing::Types<Fixed<27>, Fixed<16>, float>;
#endif
template <class S, uint32_t capacity>
using Builder = ImageBuilder<S, capacity, Operations>;

// Words without a heap: at most 640.
class Image {
 public:
  Image() = default;
  Image(const uint32_t* words, size_t size) {
    for (size_t i = 0; i < size; ++i) push_back(words[i]);
  }
  void push_back(uint32_t word) {
    if (size_ < capacity) words_[size_++] = word;
  }
  void resize(size_t size, uint32_t word) {
    while (size_ < size) push_back(word);
  }
  uint32_t& operator[](size_t i) { return words_[i]; }
  uint32_t operator[](size_t i) const { return words_[i]; }
  uint32_t* data() { return words_; }
  const uint32_t* data() const { return words_; }
  size_t size() const { return size_; }

 private:
  static constexpr size_t capacity = 640;

  uint32_t words_[capacity];
  size_t size_ = 0;
};

template <class AnyBuilder>
Image words_of(const AnyBuilder& builder) {
  return Image(builder.words(), builder.size());
}
inline void repair_crc(Image& image) {
  image[image_format::crc_word] = image_crc(image.data(), static_cast<uint32_t>(image.size()));
}
template <class S>
Program<S, Operations> load_bytes(const void* bytes, size_t count) {
  return load<S, Operations>(bytes, count);
}
template <class S>
Program<S, Operations> load_image(const Image& image) {
  return load_bytes<S>(image.data(), image.size() * 4);
}
template <class S>
LoadStatus status_of(const Image& image) {
  return load_image<S>(image).status();
}
template <class S>
LoadStatus status_with_good_crc(Image image) {
  repair_crc(image);
  return status_of<S>(image);
}

template <class S>
S metres(double real) {
  if constexpr (ScalarTraits<S>::is_fixed)
    return S(real);
  else
    return static_cast<float>(real);
}

// Header, one table of 8 segments, a soft sum of two points.
template <class S>
Image small_soft_image() {
  Builder<S, 200> builder;
  const uint32_t table = builder.table(golden::Scene<S>::potential);
  const Influence<S> influence(metres<S>(0.5), metres<S>(0.75));
  builder.operation(SoftPoint<S>{{metres<S>(0.25), {}, {}}, influence}, table);
  builder.operation(SoftPoint<S>{{{}, metres<S>(-0.25), {}}, influence}, table);
  builder.operation(SoftSum<S>{});
  builder.finish();
  return words_of(builder);
}
// A blend of a ball and a box, one of them in a frame and one in a slot.
template <class S>
Image small_distance_image() {
  Builder<S, 300> builder;
  const uint32_t table = builder.table(golden::Scene<S>::kernel);
  builder.enter(Pose<S>{{}, {metres<S>(0.125), {}, {}}});
  builder.operation(Sphere<S>{{metres<S>(0.25), {}, {}}, metres<S>(0.5)});
  builder.leave();
  builder.enter_slot(0);
  builder.operation(Box<S>{{}, {metres<S>(0.25), metres<S>(0.25), metres<S>(0.5)}});
  builder.leave();
  AdditiveUnion<S> blend;
  blend.scale = ArgumentScale<S>::of(metres<S>(0.25));
  builder.operation(blend, table);
  builder.finish();
  return words_of(builder);
}
template <class S, class Node>
Image image_of(const Node& node) {
  golden::Writer<S> writer;
  golden::program_of(writer, node);
  return words_of(writer.builder());
}

inline uint32_t program_first(const Image& image) {
  return image_format::header_words + image[image_format::table_words];
}
// The word of the first operation with this code; 0 if there is none.
inline uint32_t find_operation(const Image& image, Operation operation) {
  for (uint32_t at = program_first(image); at < image.size(); at += 1 + (image[at] >> 8)) {
    if ((image[at] & 0xffu) == static_cast<uint32_t>(operation)) return at;
  }
  return 0;
}

}  // namespace nearfield::test
