// Images to damage in tests.
#pragma once

#include <golden/query_stream.hpp>

#include <cstdint>
#include <vector>

namespace nearfield::test {

using Image = std::vector<uint32_t>;

template <class Builder>
Image words_of(const Builder& builder) {
  return Image(builder.words(), builder.words() + builder.size());
}
inline void repair_crc(Image& image) {
  image[image_format::crc_word] = image_crc(image.data(), static_cast<uint32_t>(image.size()));
}
template <class S>
Program<S> load_image(const Image& image) {
  return load<S>(image.data(), image.size() * 4);
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
  ImageBuilder<S, 200> builder;
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
  ImageBuilder<S, 300> builder;
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
