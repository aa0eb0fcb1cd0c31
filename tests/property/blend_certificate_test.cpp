/// Certificates of random compositions of each blend of two operands by itself, judged by the reference, and
/// how near to its bounds each comes.

#include "property/blend_bounds.hpp"
#include "property/random_field.hpp"

namespace nearfield::property {
namespace {

using reference::Random;

constexpr int fields_per_family = 41700;
constexpr int points_per_field = 2;

template <class S>
void judge_family(BlendFamily family, Random& random) {
  BlendBounds bounds;
  for (int i = 0; i < fields_per_family; ++i) {
    FieldTaste taste;
    taste.greatest_depth = 6;
    taste.family = family;
    taste.slots = false;
    taste.size = real(ScalarTraits<S>::domain()) * random.uniform(0.05L, 0.6L);
    const RandomField<S> field = random_field<S>(random, taste);
    ASSERT_TRUE(field.program.valid()) << static_cast<int>(field.program.status());
    for (int k = 0; k < points_per_field; ++k) bounds.judge(field.program, field.node, taste.size, random);
  }
  bounds.conclude(family_name(family));
}

template <class S>
void judge_all_families(const char* test, std::uint64_t seed) {
  Random random(reference::announced_seed(test, seed));
  std::printf("%s: greatest observed of what is certified\n", ScalarName<S>::text().c_str());
  for (int family = 0; family < static_cast<int>(BlendFamily::count); ++family) {
    judge_family<S>(static_cast<BlendFamily>(family), random);
  }
}

TEST(BlendCertificate, OfEachBlendInFixed27) { judge_all_families<Fixed<27>>("OfEachBlendInFixed27", 111); }
TEST(BlendCertificate, OfEachBlendInFixed16) { judge_all_families<Fixed<16>>("OfEachBlendInFixed16", 112); }
TEST(BlendCertificate, OfEachBlendInFloat) { judge_all_families<float>("OfEachBlendInFloat", 113); }

}  // namespace
}  // namespace nearfield::property
