// Program images: good ones load, damaged ones are refused for the reason that is theirs.
#include "sample_images.hpp"

#include <gtest/gtest.h>

namespace {

using namespace nearfield;
using namespace nearfield::test;
namespace format = nearfield::image_format;

template <class S>
class ImageOf : public testing::Test {};
TYPED_TEST_SUITE(ImageOf, ImageScalars, );

TYPED_TEST(ImageOf, GoodImagesLoadWithWhatTheyContain) {
  using S = TypeParam;
  const Image soft = small_soft_image<S>();
  const Program<S, Operations> soft_program = load_image<S>(soft);
  EXPECT_EQ(soft_program.status(), LoadStatus::ok);
  EXPECT_EQ(soft_program.kind(), Kind::intensity);
  EXPECT_EQ(soft_program.slot_count(), 0u);

  const Image distance = small_distance_image<S>();
  const Program<S, Operations> program = load_image<S>(distance);
  EXPECT_EQ(program.status(), LoadStatus::ok);
  EXPECT_EQ(program.kind(), Kind::distance);
  EXPECT_EQ(program.slot_count(), 1u);
  EXPECT_GE(program.certificate().lipschitz, kUnitRate);
  EXPECT_GT(program.certificate().error, S{});
  // Measured of Fixed<27> alone.
  EXPECT_EQ(program.budget().gradient > program.budget().value, (ScalarTraits<S>::tag == ScalarTraits<Fixed<27>>::tag));
  EXPECT_EQ(distance[format::stack_depth_word], 2u);
  EXPECT_EQ(distance[format::frame_depth_word], 1u);

  // What follows the image in memory does not matter.
  Image longer = distance;
  longer.resize(longer.size() + 100, 0xdeadbeefu);
  EXPECT_EQ(status_of<S>(longer), LoadStatus::ok);
  EXPECT_EQ(load_bytes<S>(distance.data(), distance.size() * 4 + 3).status(), LoadStatus::ok);
}

TYPED_TEST(ImageOf, EverySingleBitFlipIsRefused) {
  using S = TypeParam;
  for (const Image& good : {small_soft_image<S>(), small_distance_image<S>()}) {
    ASSERT_EQ(status_of<S>(good), LoadStatus::ok);
    for (size_t word = 0; word < good.size(); ++word) {
      for (int bit = 0; bit < 32; ++bit) {
        Image damaged = good;
        damaged[word] ^= 1u << bit;
        EXPECT_NE(status_of<S>(damaged), LoadStatus::ok) << "bit " << bit << " of word " << word;
      }
    }
  }
}

TYPED_TEST(ImageOf, NoImage) {
  using S = TypeParam;
  EXPECT_EQ(load_bytes<S>(nullptr, 1000).status(), LoadStatus::no_image);
  EXPECT_EQ(load_bytes<S>(nullptr, 0).status(), LoadStatus::no_image);
  Image image = small_soft_image<S>();
  image.push_back(0);
  const auto* bytes = reinterpret_cast<const unsigned char*>(image.data());
  for (size_t offset = 1; offset < 4; ++offset) {
    EXPECT_EQ(load_bytes<S>(bytes + offset, image.size() * 4 - 4).status(), LoadStatus::no_image);
  }
  EXPECT_EQ((inspect_image<S, Operations>(nullptr, 1000).status), LoadStatus::no_image);
  EXPECT_EQ((inspect_image<S, Operations>(image.data(), format::header_words - 1).status), LoadStatus::no_image);
}

TYPED_TEST(ImageOf, DamagedHeaders) {
  using S = TypeParam;
  const Image good = small_distance_image<S>();
  const auto with = [&good](uint32_t word, uint32_t value) {
    Image image = good;
    image[word] = value;
    return status_with_good_crc<S>(image);
  };
  EXPECT_EQ(with(format::magic_word, 0), LoadStatus::wrong_magic);
  EXPECT_EQ(with(format::magic_word, 0x4e464931u), LoadStatus::wrong_magic) << "the other byte order";
  EXPECT_EQ(with(format::version_word, 0), LoadStatus::wrong_version);
  EXPECT_EQ(with(format::version_word, format::version + 1), LoadStatus::wrong_version);
  const auto size = static_cast<uint32_t>(good.size());
  const uint32_t wrong_sizes[] = {0, format::header_words - 1, size - 1, size + 1, 0x40000000, 0xffffffff};
  for (const uint32_t wrong : wrong_sizes) {
    EXPECT_EQ(with(format::size_word, wrong), LoadStatus::wrong_size) << wrong;
  }
  const uint32_t wrong_table_sizes[] = {size, 0xffffffff, 0x80000000, good[format::table_words] + 1};
  for (const uint32_t wrong : wrong_table_sizes) {
    EXPECT_EQ(with(format::table_words, wrong), LoadStatus::wrong_size) << wrong;
  }
  const uint32_t wrong_program_sizes[] = {0, 0xffffffff, good[format::program_words] + 1};
  for (const uint32_t wrong : wrong_program_sizes) {
    EXPECT_EQ(with(format::program_words, wrong), LoadStatus::wrong_size) << wrong;
  }
  EXPECT_EQ(with(format::scalar_word, good[format::scalar_word] ^ 1u), LoadStatus::wrong_scalar);
  Image wrong_crc = good;
  wrong_crc[format::crc_word] ^= 1u;
  EXPECT_EQ(status_of<S>(wrong_crc), LoadStatus::crc_mismatch);
}

TEST(ImageScalars, AreNotInterchangeable) {
  EXPECT_EQ(status_of<Fixed<16>>(small_soft_image<Fixed<27>>()), LoadStatus::wrong_scalar);
  EXPECT_EQ(status_of<float>(small_soft_image<Fixed<27>>()), LoadStatus::wrong_scalar);
  EXPECT_EQ(status_of<Fixed<27>>(small_soft_image<float>()), LoadStatus::wrong_scalar);
  EXPECT_EQ(status_of<Fixed<24>>(small_soft_image<Fixed<16>>()), LoadStatus::wrong_scalar);
}

TYPED_TEST(ImageOf, BadTables) {
  using S = TypeParam;
  const Image good = small_soft_image<S>();
  constexpr uint32_t table = format::header_words, first = table + format::table_header_words;
  const auto with = [&good](uint32_t word, uint32_t value) {
    Image image = good;
    image[word] = value;
    return status_with_good_crc<S>(image);
  };
  for (const uint32_t segments : {9u, 31u, 32u, 0xffffffffu}) {
    EXPECT_EQ(with(table, segments), LoadStatus::bad_table) << segments;
  }
  EXPECT_EQ(with(table, 4), LoadStatus::bad_table) << "more segments than the section holds";
  for (const uint32_t headroom : {4u, 5u, 32u, 0x80000000u}) {
    EXPECT_EQ(with(table + 1, headroom), LoadStatus::bad_table) << headroom;
  }
  EXPECT_EQ(with(table + 2, 0xffffffffu), LoadStatus::bad_table) << "negative error";
  EXPECT_EQ(with(table + 3, 0xffffffffu), LoadStatus::bad_table) << "negative error of the slope";
  EXPECT_EQ(with(table + 4, 0x7fffffffu), LoadStatus::bad_table) << "least value above the greatest";
  EXPECT_EQ(with(table + 7, 0x80000000u), LoadStatus::bad_table) << "greatest slope below the least";
  constexpr uint32_t overflowing_fixed[] = {0x7fffffffu, 0x80000000u},
                     overflowing_float[] = {0x42800000u, 0xc2800000u, 0x7f800000u, 0xff800000u, 0x7fc00000u, 0xffffffffu};
  const auto expect_bad = [&](uint32_t coefficient) {
    for (uint32_t segment = 0; segment < 2; ++segment) {
      for (uint32_t j = 0; j < 4; ++j) {
        EXPECT_EQ(with(first + 4 * segment + j, coefficient), LoadStatus::bad_table) << segment << ", " << j;
      }
    }
  };
  if constexpr (ScalarTraits<S>::is_fixed) {
    for (const uint32_t coefficient : overflowing_fixed) expect_bad(coefficient);
  } else {
    for (const uint32_t coefficient : overflowing_float) expect_bad(coefficient);
  }
  // A section that ends within a table's header.
  Image cut(good.data(), program_first(good));
  for (int i = 0; i < 5; ++i) cut.push_back(3);
  for (size_t word = program_first(good); word < good.size(); ++word) cut.push_back(good[word]);
  cut[format::size_word] += 5;
  cut[format::table_words] += 5;
  EXPECT_EQ(status_with_good_crc<S>(cut), LoadStatus::bad_table);
}

// Builds a program without tables from operations and says why the builder refuses it; load() must agree.
template <class S, class Write>
LoadStatus status_of_program(const Write& write) {
  Builder<S, 400> builder;
  write(builder);
  const LoadStatus status = builder.finish().status;
  EXPECT_EQ(status_of<S>(words_of(builder)), status);
  return status;
}

template <class S>
Sphere<S> ball() {
  return {{}, metres<S>(0.5)};
}

bool is_known_operation(uint32_t code) {
  switch (static_cast<Operation>(code)) {
#define NEARFIELD_CASE(number, name, ...) case Operation::name:
    NEARFIELD_OPERATIONS(NEARFIELD_CASE)
#undef NEARFIELD_CASE
#define NEARFIELD_CASE(number, name) case Operation::name:
    NEARFIELD_FRAME_OPERATIONS(NEARFIELD_CASE)
#undef NEARFIELD_CASE
    return true;
  }
  return false;
}

TYPED_TEST(ImageOf, UnknownAndTruncatedOperations) {
  using S = TypeParam;
  const Image good = small_distance_image<S>();
  const uint32_t ball_at = find_operation(good, Operation::sphere);
  ASSERT_NE(ball_at, 0u);
  const auto with = [&good](uint32_t word, uint32_t value) {
    Image image = good;
    image[word] = value;
    return status_with_good_crc<S>(image);
  };
  int unknown = 0;
  for (uint32_t code = 0; code < 256; ++code) {
    if (is_known_operation(code)) continue;
    ++unknown;
    EXPECT_EQ(with(ball_at, (good[ball_at] & ~0xffu) | code), LoadStatus::unknown_operation) << code;
  }
  EXPECT_GT(unknown, 100);
  const auto with_payload = [&](uint32_t at, uint32_t words) {
    return with(at, (good[at] & 0xffu) | words << 8);
  };
  const uint32_t wrong_counts[] = {0, 3, 5, 0xffffff, static_cast<uint32_t>(good.size())};
  for (const uint32_t words : wrong_counts) {
    EXPECT_EQ(with_payload(ball_at, words), LoadStatus::truncated_operation) << words;
  }
  const uint32_t blend_at = find_operation(good, Operation::additive_union);
  EXPECT_EQ(with_payload(blend_at, (good[blend_at] >> 8) + 1), LoadStatus::truncated_operation);
  EXPECT_EQ(with_payload(find_operation(good, Operation::enter_slot), 0), LoadStatus::truncated_operation);
  EXPECT_EQ(with_payload(find_operation(good, Operation::enter_pose), 1), LoadStatus::truncated_operation);
}

TYPED_TEST(ImageOf, BadTableReferences) {
  using S = TypeParam;
  for (const Image& good : {small_soft_image<S>(), small_distance_image<S>()}) {
    const uint32_t found = find_operation(good, Operation::soft_point);
    const uint32_t at = found != 0 ? found : find_operation(good, Operation::additive_union);
    const uint32_t reference = at + (good[at] >> 8);
    ASSERT_EQ(good[reference], format::header_words);
    const auto size = static_cast<uint32_t>(good.size());
    const uint32_t wrong_places[] = {
        0, format::header_words - 1, format::header_words + 1, program_first(good), size - 1, size, 0x80000000, 0xffffffff};
    for (const uint32_t wrong : wrong_places) {
      Image image = good;
      image[reference] = wrong;
      EXPECT_EQ(status_with_good_crc<S>(image), LoadStatus::bad_table_reference) << wrong;
    }
  }
  EXPECT_EQ(
      status_of_program<S>([](auto& builder) {
        builder.operation(SoftPoint<S>{{}, Influence<S>(metres<S>(0.5), metres<S>(1))}, format::header_words);
      }),
      LoadStatus::bad_table_reference)
      << "an image without tables";
}

TYPED_TEST(ImageOf, KindsAndCountsOfOperands) {
  using S = TypeParam;
  EXPECT_EQ(status_of_program<S>([](auto&) {}), LoadStatus::kind_mismatch) << "no result";
  EXPECT_EQ(status_of_program<S>([](auto& b) { b.operation(ball<S>()); }), LoadStatus::ok);
  EXPECT_EQ(status_of_program<S>([](auto& b) { b.operation(ball<S>()).operation(ball<S>()); }),
            LoadStatus::kind_mismatch)
      << "two results";
  EXPECT_EQ(status_of_program<S>([](auto& b) { b.operation(SharpUnion<S>{}); }), LoadStatus::kind_mismatch);
  EXPECT_EQ(status_of_program<S>([](auto& b) { b.operation(ball<S>()).operation(SharpUnion<S>{}); }),
            LoadStatus::kind_mismatch)
      << "one operand";
  EXPECT_EQ(status_of_program<S>(
                [](auto& b) { b.operation(ball<S>()).operation(ball<S>()).operation(SoftSum<S>{}); }),
            LoadStatus::kind_mismatch)
      << "a sum of distances";
  EXPECT_EQ(status_of_program<S>([](auto& b) {
              const uint32_t table = b.table(golden::Scene<S>::potential);
              b.operation(ball<S>());
              b.operation(SoftPoint<S>{{}, Influence<S>(metres<S>(0.5), metres<S>(1))}, table);
              b.operation(SharpUnion<S>{});
            }),
            LoadStatus::kind_mismatch)
      << "a distance with an intensity";
}

TYPED_TEST(ImageOf, DepthOfTheStack) {
  using S = TypeParam;
  const auto stacked = [](int count) {
    return status_of_program<S>([count](auto& b) {
      for (int i = 0; i < count; ++i) b.operation(ball<S>());
      for (int i = 1; i < count; ++i) b.operation(SharpUnion<S>{});
    });
  };
  EXPECT_EQ(stacked(kStackDepth), LoadStatus::ok);
  EXPECT_EQ(stacked(kStackDepth + 1), LoadStatus::stack_too_deep);
}

TYPED_TEST(ImageOf, Frames) {
  using S = TypeParam;
  const auto nested = [](int count) {
    return status_of_program<S>([count](auto& b) {
      for (int i = 0; i < count; ++i) b.enter(Pose<S>{});
      b.operation(ball<S>());
      for (int i = 0; i < count; ++i) b.leave();
    });
  };
  EXPECT_EQ(nested(kFrameDepth), LoadStatus::ok);
  EXPECT_EQ(nested(kFrameDepth + 1), LoadStatus::frames_too_deep);
  const LoadStatus unbalanced = LoadStatus::frames_unbalanced;
  EXPECT_EQ(status_of_program<S>([](auto& b) { b.enter(Pose<S>{}).operation(ball<S>()); }), unbalanced);
  EXPECT_EQ(status_of_program<S>([](auto& b) { b.operation(ball<S>()).leave(); }), unbalanced);
  EXPECT_EQ(status_of_program<S>([](auto& b) { b.operation(ball<S>()).enter(Pose<S>{}).leave(); }),
            unbalanced);
  EXPECT_EQ(status_of_program<S>(
                [](auto& b) { b.enter_slot(0).operation(ball<S>()).operation(ball<S>()).leave(); }),
            unbalanced)
      << "two results in a frame";
  EXPECT_EQ(status_of_program<S>([](auto& b) {
              b.operation(ball<S>()).enter(Pose<S>{}).operation(ball<S>()).operation(SharpUnion<S>{}).leave();
            }),
            LoadStatus::kind_mismatch)
      << "an operand from outside the frame";
  Image payload = small_distance_image<S>();
  payload[find_operation(payload, Operation::leave)] |= 1u << 8;
  EXPECT_EQ(status_with_good_crc<S>(payload), LoadStatus::truncated_operation) << "`leave` with a payload";
}

TYPED_TEST(ImageOf, Sizes) {
  using S = TypeParam;
  const UniformScale<S> twice(metres<S>(2));
  const auto status = [](auto build) { return status_of_program<S>(build); };
  EXPECT_EQ(status([&](auto& b) { b.enter_scale(twice, Kind::distance).operation(ball<S>()).leave_scale(); }), LoadStatus::ok);
  EXPECT_EQ(status([&](auto& b) { b.enter_scale(twice, Kind::ray).operation(ball<S>()).leave_scale(); }), LoadStatus::kind_mismatch);
  EXPECT_EQ(status([&](auto& b) { b.enter_scale(twice, static_cast<Kind>(9)).operation(ball<S>()).leave_scale(); }),
            LoadStatus::kind_mismatch);
  const LoadStatus unbalanced = LoadStatus::frames_unbalanced;
  EXPECT_EQ(status([&](auto& b) { b.enter_scale(twice, Kind::distance).operation(ball<S>()); }), unbalanced);
  EXPECT_EQ(status([&](auto& b) { b.enter_scale(twice, Kind::distance).operation(ball<S>()).leave(); }), unbalanced);
  EXPECT_EQ(status([&](auto& b) { b.enter(Pose<S>{}).operation(ball<S>()).leave_scale(); }), unbalanced);
  EXPECT_EQ(status([&](auto& b) { b.enter_scale(twice, Kind::distance).leave_scale(); }), unbalanced);
  EXPECT_EQ(status([&](auto& b) { b.operation(ball<S>()).leave_scale(); }), unbalanced);
  const auto refused = [&](const char* what, const UniformScale<S>& scale) {
    EXPECT_EQ(status([&](auto& b) { b.enter_scale(scale, Kind::distance).operation(ball<S>()).leave_scale(); }),
              LoadStatus::parameter_out_of_range)
        << what;
  };
  UniformScale<S> wrong = twice;
  wrong.inverse = metres<S>(0.25);
  refused("not its inverse", wrong);
  refused("zero", UniformScale<S>(S{}));
  refused("negative", UniformScale<S>(-metres<S>(2)));
  refused("below 1/8", UniformScale<S>(metres<S>(0.12)));
  refused("above 8", UniformScale<S>(metres<S>(8) + metres<S>(0.01)));
  const auto nested = [&](int count) {
    return status([&](auto& b) {
      for (int i = 0; i < count; ++i) b.enter_scale(UniformScale<S>(metres<S>(1)), Kind::distance);
      b.operation(ball<S>());
      for (int i = 0; i < count; ++i) b.leave_scale();
    });
  };
  EXPECT_EQ(nested(kFrameDepth), LoadStatus::ok);
  EXPECT_EQ(nested(kFrameDepth + 1), LoadStatus::frames_too_deep);
}

TYPED_TEST(ImageOf, ParametersOutOfRange) {
  using S = TypeParam;
  const S half = metres<S>(0.5), limit = ScalarTraits<S>::domain();
  const auto expect_refused = [](const char* what, const auto& shape) {
    EXPECT_EQ(status_of_program<S>([&shape](auto& b) { b.operation(shape); }),
              LoadStatus::parameter_out_of_range)
        << what;
  };
  expect_refused("negative radius", Sphere<S>{{}, -half});
  expect_refused("far", Sphere<S>{{limit + half, {}, {}}, half});
  expect_refused("box", Box<S>{{}, {half, half, -half}});
  expect_refused("cylinder", Cylinder<S>{{}, half, S{}});
  expect_refused("axis too short", Capsule<S>({}, {metres<Unit<S>>(0.99), {}, {}}, half, half));
  expect_refused("axis too long", Capsule<S>({}, {metres<Unit<S>>(1.01), {}, {}}, half, half));
  expect_refused("axis of two ones",
                 Capsule<S>({}, {metres<Unit<S>>(1), metres<Unit<S>>(1), {}}, half, half));
  EXPECT_EQ(status_of_program<S>([](auto& b) { b.enter_slot(kSlotLimit).operation(ball<S>()).leave(); }),
            LoadStatus::parameter_out_of_range);
  EXPECT_EQ(status_of_program<S>([](auto& b) { b.enter_slot(kSlotLimit - 1).operation(ball<S>()).leave(); }),
            LoadStatus::ok);

  const auto expect_pose_refused = [](const char* what, const Pose<S>& pose) {
    EXPECT_EQ(status_of_program<S>([&pose](auto& b) { b.enter(pose).operation(ball<S>()).leave(); }),
              LoadStatus::parameter_out_of_range)
        << what;
  };
  Pose<S> mirror, skew, far;
  mirror.rotation.row[0] = -mirror.rotation.row[0];
  skew.rotation.row[0].y = metres<Unit<S>>(0.01);
  far.translation.z = limit + half;
  expect_pose_refused("mirror", mirror);
  expect_pose_refused("skew", skew);
  expect_pose_refused("far", far);
  if constexpr (!ScalarTraits<S>::is_fixed) {
    const float infinity = __builtin_inff(), nan = __builtin_nanf("");
    for (const float strange : {nan, -nan, infinity, -infinity}) {
      expect_refused("radius", Sphere<S>{{}, strange});
      expect_refused("centre", Sphere<S>{{0.0f, strange, 0.0f}, half});
      expect_refused("edge", Box<S>{{}, {half, half, strange}});
      expect_refused("axis", Capsule<S>({}, Vector3<float>{strange, 0.0f, 0.0f}, half, half));
      expect_refused("length", Capsule<S>({}, Vector3<float>{1.0f, 0.0f, 0.0f}, strange, half));
      Pose<S> pose;
      pose.rotation.row[1].x = strange;
      expect_pose_refused("rotation", pose);
      pose = {};
      pose.translation.x = strange;
      expect_pose_refused("translation", pose);
    }
  }
}

// The blend's and the influence's own numbers must fit each other.
TYPED_TEST(ImageOf, ScalesThatDoNotFit) {
  using S = TypeParam;
  for (const Image& good : {small_soft_image<S>(), small_distance_image<S>()}) {
    const uint32_t found = find_operation(good, Operation::soft_point);
    const uint32_t at = found != 0 ? found : find_operation(good, Operation::additive_union);
    const uint32_t first = found != 0 ? at + 4 : at + 1;  // behind the centre of a soft point
    for (uint32_t word = first; word < at + (good[at] >> 8); ++word) {
      const bool is_weight = found != 0 && word == at + 5;
      if (is_weight) continue;
      Image image = good;
      image[word] ^= 1u << 20;
      EXPECT_EQ(status_with_good_crc<S>(image), LoadStatus::parameter_out_of_range) << word - at;
    }
  }
}

TYPED_TEST(ImageOf, ClaimsThatAreNotTrue) {
  using S = TypeParam;
  const Image good = small_distance_image<S>();
  for (uint32_t word = format::kind_word; word < format::header_words; ++word) {
    if (word == format::table_words || word == format::program_words) continue;
    for (const uint32_t change : {1u, 0xffffffffu}) {
      Image image = good;
      image[word] += change;
      EXPECT_EQ(status_with_good_crc<S>(image), LoadStatus::certificate_mismatch) << word << ", " << change;
    }
  }
  Image error_free = good;
  error_free[format::error_word] = 0;
  EXPECT_EQ(status_with_good_crc<S>(error_free), LoadStatus::certificate_mismatch);
}

// Ranges in a table's facts that are narrower than what its coefficients give, with claims that agree with
// them.
TYPED_TEST(ImageOf, FactsNarrowerThanTheCoefficients) {
  using S = TypeParam;
  const auto status_with = [](const auto& narrow_down) {
    Table<S, 32> table = golden::Scene<S>::kernel;
    narrow_down(table.facts);
    AdditiveIntersection<S> blend;
    blend.scale = ArgumentScale<S>::of(metres<S>(0.25));
    return status_of_program<S>([&](auto& b) {
      const uint32_t reference = b.table(table);
      b.operation(ball<S>()).operation(ball<S>()).operation(blend, reference);
    });
  };
  EXPECT_EQ(status_with([](TableFacts&) {}), LoadStatus::ok);
  EXPECT_NE(status_with([](TableFacts& facts) { facts.greatest_value = 0; }), LoadStatus::ok);
  EXPECT_NE(status_with([](TableFacts& facts) { facts.least_value = facts.greatest_value; }), LoadStatus::ok);
  EXPECT_NE(status_with([](TableFacts& facts) { facts.greatest_slope = facts.least_slope; }), LoadStatus::ok);
  EXPECT_NE(status_with([](TableFacts& facts) { facts.least_slope = facts.greatest_slope; }), LoadStatus::ok);
}

TYPED_TEST(ImageOf, BuilderThatIsFull) {
  using S = TypeParam;
  Builder<S, 24> builder;
  builder.operation(ball<S>()).operation(ball<S>()).operation(SharpUnion<S>{});
  EXPECT_EQ(builder.finish().status, LoadStatus::wrong_size);
  EXPECT_NE(load_bytes<S>(builder.words(), 24 * 4).status(), LoadStatus::ok);
}

TEST(ImageCrc, IsThatOfTheStandard) {
  // CRC-32 of the eight bytes "12345678"; the fourth word, the checksum's own place, is left out.
  const uint32_t words[] = {0x34333231u, 0x38373635u};
  EXPECT_EQ(image_crc(words, 2), 0x9ae0daafu);
  const uint32_t before[] = {1, 2, 3, 4, 5}, after[] = {1, 2, 3, 99, 5};
  EXPECT_EQ(image_crc(before, 5), image_crc(after, 5));
}

static_assert(
    [] {
      ImageBuilder<Fixed<27>, 40> builder;
      builder.operation(Sphere<Fixed<27>>{{}, 0.5});
      return builder.finish().status == LoadStatus::ok;
    }(),
    "images can be written by the compiler");

}  // namespace
