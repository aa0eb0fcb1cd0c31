// Mutated images with a correct checksum: refused, or safe to evaluate. Meant to be run under sanitizers as
// well.
#include <unit/freestanding/sample_images.hpp>

#include <reference/random.hpp>

#include <gtest/gtest.h>

#include <cstdint>
#include <cstdio>
#include <vector>

namespace {

using namespace nearfield;
using namespace nearfield::test;
using reference::Random;
namespace format = nearfield::image_format;

constexpr int kMutations = 200000;
constexpr int kPoints = 20;

uint32_t below(Random& random, size_t count) { return static_cast<uint32_t>(random.next() % count); }

uint32_t strange_word(Random& random) {
  static constexpr uint32_t words[] = {
      0,           1,           2,           3,           0x7fffffffu, 0x80000000u, 0x80000001u, 0xffffffffu,
      0x40000000u, 0xc0000000u, 0x20000000u, 0x20000001u, 0x3f800000u, 0xbf800000u, 0x7f800000u, 0xff800000u,
      0x7fc00000u, 0x7f7fffffu, 0x00000001u, 0x41800000u, 0x3fffffffu, 0x08000000u};
  return words[below(random, sizeof words / sizeof words[0])];
}

// Nothing behind them, so that a sanitizer sees what reads there.
std::vector<uint32_t> words_alone(const Image& image) { return {image.data(), image.data() + image.size()}; }

// Changes one to four words.
void mutate(Image& image, Random& random) {
  for (uint32_t count = 1 + below(random, 4); count > 0; --count) {
    // Half of the changes beyond the tables, where the program is.
    const uint32_t first = random.chance(0.5L) ? program_first(image) : 0;
    const auto size = static_cast<uint32_t>(image.size());
    const uint32_t word = first < size ? first + below(random, size - first) : below(random, size);
    switch (below(random, 6)) {
      case 0:
        image[word] ^= 1u << below(random, 32);
        break;
      case 1:
        image[word] = static_cast<uint32_t>(random.next());
        break;
      case 2:
        image[word] = strange_word(random);
        break;
      case 3:
        image[word] += below(random, 9) - 4u;
        break;
      case 4:
        image[word] = image[below(random, size)];
        break;
      default:
        image[word] = static_cast<uint32_t>(random.integer(-64, 64)) * 0x01000000u;
        break;
    }
  }
}

// Writes what the image's contents really have into its header. Precondition: everything before that check
// passes.
template <class S>
void agree_with_contents(Image& image) {
  const auto size = static_cast<uint32_t>(image.size());
  const Inspection<S> found =
      nearfield::detail::inspect_operations<S, AllOperations>(image.data(), program_first(image), size);
  if (found.status != LoadStatus::ok) return;
  image[format::kind_word] = static_cast<uint32_t>(found.kind);
  image[format::stack_depth_word] = static_cast<uint32_t>(found.stack_depth);
  image[format::frame_depth_word] = static_cast<uint32_t>(found.frame_depth);
  image[format::slot_count_word] = found.slot_count;
  image[format::lipschitz_word] = static_cast<uint32_t>(found.certificate.lipschitz.raw());
  image[format::erosion_word] = ScalarTraits<S>::word(found.certificate.erosion);
  image[format::inflation_word] = ScalarTraits<S>::word(found.certificate.inflation);
  image[format::error_word] = ScalarTraits<S>::word(found.certificate.error);
  repair_crc(image);
}

template <class S>
bool is_number(S x) {
  if constexpr (ScalarTraits<S>::is_fixed)
    return true;
  else
    return x > -1e6f && x < 1e6f;
}

template <class S>
Vector3<S> point_in_domain(golden::Stream& stream) {
  for (;;) {
    const Vector3<S> p = golden::point_from<S>(stream);
    if (coordinates_in_domain(p)) return p;
  }
}
template <class S>
Pose<S> valid_pose_from(golden::Stream& stream) {
  for (;;) {
    const Pose<S> pose = golden::pose_from<S>(stream);
    if (valid_pose(pose)) return pose;
  }
}

template <class S>
void evaluate_everywhere(const Program<S>& program, golden::Stream& stream) {
  std::vector<Pose<S>> slots(program.slot_count());
  for (Pose<S>& slot : slots) slot = valid_pose_from<S>(stream);
  for (int i = 0; i < kPoints; ++i) {
    const Vector3<S> p = point_in_domain<S>(stream);
    const Sample<S> sample = program.template evaluate<Sample<S>>(p, slots.data());
    ASSERT_TRUE(is_number(sample.value) && is_number(sample.gradient.x) && is_number(sample.gradient.y) &&
                is_number(sample.gradient.z));
    ASSERT_EQ(ScalarTraits<S>::word(program.template evaluate<Value<S>>(p, slots.data()).value),
              ScalarTraits<S>::word(sample.value));
    const Clearance<S> answer = clearance(program, p, slots.data(), program.slot_count());
    ASSERT_EQ(answer.status == ClearanceStatus::invalid, program.kind() == Kind::intensity);
    ASSERT_EQ(answer.status == ClearanceStatus::clear, answer.distance > S{});
  }
}

// Most of whose words follow from others.
template <class S>
Image image_of_patch() {
  Vector3<S> control[16] = {};
  for (int i = 0; i < 16; ++i)
    control[i] = {metres<S>(0.25 * (i / 4)), metres<S>(0.125 * (i % 4)), metres<S>(0.0625 * (i * i % 7))};
  ImageBuilder<S, 512> builder;
  builder.operation(BicubicPatch<S>(control, metres<S>(0.125)));
  builder.finish();
  return words_of(builder);
}

template <class S>
void fuzz(const char* name, uint64_t usual_seed, int mutations) {
  const uint64_t seed = reference::announced_seed(name, usual_seed);
  Random random(seed);
  golden::Stream stream(seed);
  using Fields = golden::Scene<S>;
  const std::vector<Image> good = {small_soft_image<S>(), small_distance_image<S>(),
                                   image_of<S>(Fields::sharp), image_of<S>(unite(Fields::arm, Fields::post)),
                                   image_of_patch<S>()};
  for (const Image& image : good) ASSERT_EQ(status_of<S>(image), LoadStatus::ok);
  int loaded = 0, refused = 0;
  for (int i = 0; i < mutations; ++i) {
    // The largest images take longest to check: they get their share, not more.
    Image image = good[below(random, 8) < 6 ? below(random, 2) : 2 + below(random, 3)];
    mutate(image, random);
    repair_crc(image);
    std::vector<uint32_t> words = words_alone(image);
    Program<S> program = load<S>(words.data(), words.size() * 4);
    if (program.status() == LoadStatus::certificate_mismatch) {
      agree_with_contents<S>(image);
      words = words_alone(image);
      program = load<S>(words.data(), words.size() * 4);
    }
    if (program.status() != LoadStatus::ok) {
      ++refused;
      ASSERT_EQ(clearance(program, Vector3<S>{}).status, ClearanceStatus::invalid);
      continue;
    }
    ++loaded;
    evaluate_everywhere(program, stream);
    if (testing::Test::HasFatalFailure()) FAIL() << "mutation " << i;
  }
  std::printf("%s: %d loaded, %d refused\n", name, loaded, refused);
  EXPECT_GT(loaded, mutations / 50);
  EXPECT_GT(refused, mutations / 50);
}

template <class S>
void expect_truncations_refused() {
  const Image good = small_distance_image<S>();
  for (size_t bytes = 0; bytes < good.size() * 4; ++bytes) {
    const std::vector<uint32_t> part(good.data(), good.data() + (bytes + 3) / 4);
    const LoadStatus status = load<S>(part.data(), bytes).status();
    EXPECT_EQ(status, bytes < 4 * format::header_words ? LoadStatus::no_image : LoadStatus::wrong_size) << bytes;
  }
}

TEST(ImageTruncation, IsRefused) {
  expect_truncations_refused<Fixed<27>>();
  expect_truncations_refused<Fixed<16>>();
  expect_truncations_refused<float>();
}

TEST(ImageFuzz, Fixed27) { fuzz<Fixed<27>>("ImageFuzz.Fixed27", 31, kMutations * 2 / 5); }
TEST(ImageFuzz, Fixed16) { fuzz<Fixed<16>>("ImageFuzz.Fixed16", 32, kMutations / 5); }
TEST(ImageFuzz, Float) { fuzz<float>("ImageFuzz.Float", 33, kMutations * 2 / 5); }

}  // namespace
