/// Certificates of random compositions of log-sum-exp of 2 to 8 operands, judged by the reference, and how
/// near to its bounds each number of operands comes.

#include <nearfield/field/builder.hpp>

#include "property/blend_bounds.hpp"
#include "reference/additive_blends.hpp"

#include <memory>
#include <utility>
#include <vector>

namespace nearfield::property {
namespace {

using reference::Node;
using reference::Random;

using Operations =
    OnlyOperations<Operation::sphere, Operation::capsule, Operation::box, Operation::sharp_union,
                   Operation::sharp_intersection, Operation::log_sum_exp_union,
                   Operation::log_sum_exp_intersection, Operation::log_sum_exp_subtraction>;

/// A field of blends of `operands` operands each (0: of 2 to 8, each its own number), as an image and as a
/// tree.
template <class S>
class ManyOperandField {
 public:
  ManyOperandField(Random& random, int operands, Real size)
      : random_(random), operands_(operands), size_(size) {
    node_ = node(random.chance(0.4L) ? 1 : static_cast<int>(random.integer(1, 6)));
    const Inspection<S> built = image_->finish();
    if (built.status == LoadStatus::ok) {
      program_ = load<S, Operations>(image_->words(), image_->size() * sizeof(uint32_t));
    }
  }
  const Program<S, Operations>& program() const { return program_; }
  const Node& tree() const { return node_; }

 private:
  // The deepest operand comes first, so that few results wait for each other.
  Node node(int depth) {
    if (depth == 0) return leaf(random_.vector(-size_, size_) * 0.55L, size_ * random_.uniform(0.02L, 0.4L));
    if (random_.chance(0.15L)) return sharp(depth);
    const int count = operands_ > 0 ? operands_ : static_cast<int>(random_.integer(2, 8));
    const Real range = size_ * random_.uniform(0.01L, 0.4L);
    // Operands that nearly tie, so that each adds its share; otherwise few come near each other.
    const bool alike = depth == 1 && random_.chance(0.8L);
    const reference::Vec3 center = random_.vector(-size_, size_) * 0.55L;
    const Real radius = size_ * random_.uniform(0.02L, 0.4L);
    std::vector<Node> operands;
    for (int i = 0; i < count; ++i) {
      if (alike) {
        operands.push_back(ball(center + random_.vector(-1, 1) * (range * 1e-4L), radius));
      } else {
        operands.push_back(node(i == 0 ? depth - 1 : depth > 1 && random_.chance(0.25L) ? 1 : 0));
      }
    }
    return blended(static_cast<int>(random_.integer(0, alike ? 1 : 2)), static_cast<uint32_t>(count), range,
                   std::move(operands));
  }

  Node blended(int operation, uint32_t count, Real range, std::vector<Node> operands) {
    const S limit = rounded<S>(range);
    const ArgumentScale<S> scale = ArgumentScale<S>::of(limit);
    const Real sharpness = 32 * std::log(Real{2}) / real(limit);
    const reference::Blend blend = reference::custom_blend(
        [sharpness](Real x, Real y) { return reference::log_sum_exp_point(sharpness, x, y); });
    if (operation == 0) image_->operation(LogSumExpUnion<S>{scale, count});
    if (operation == 1) image_->operation(LogSumExpIntersection<S>{scale, count});
    if (operation == 2) image_->operation(LogSumExpSubtraction<S>{scale, count});
    // The tree blends one after the other: log-sum-exp is associative.
    if (operation == 0) return reference::unite(blend, std::move(operands));
    if (operation == 1) return reference::intersect(blend, std::move(operands));
    return reference::subtract(blend, std::move(operands));
  }

  Node sharp(int depth) {
    std::vector<Node> operands;
    operands.push_back(node(depth - 1));
    operands.push_back(node(0));
    if (random_.chance(0.7L)) {
      image_->operation(SharpUnion<S>{});
      return reference::unite(reference::hard_blend(), std::move(operands));
    }
    image_->operation(SharpIntersection<S>{});
    return reference::intersect(reference::hard_blend(), std::move(operands));
  }

  Node leaf(const reference::Vec3& center, Real part) {
    switch (random_.integer(0, 2)) {
      case 0:
        return ball(center, part);
      case 1: {
        const reference::Vec3 end = center + random_.vector(-size_, size_) * 0.3L;
        image_->operation(Capsule<S>(rounded<S>(center), rounded<S>(end), rounded<S>(part / 3)));
        return reference::capsule(center, end, part / 3);
      }
      default: {
        const reference::Vec3 half_edges = random_.vector(0.1L, 1) * part;
        image_->operation(Box<S>{rounded<S>(center), rounded<S>(half_edges)});
        return reference::box(center, half_edges);
      }
    }
  }
  Node ball(const reference::Vec3& center, Real radius) {
    image_->operation(Sphere<S>{rounded<S>(center), rounded<S>(radius)});
    return reference::sphere(center, radius);
  }

  Random& random_;
  int operands_;
  Real size_;
  std::unique_ptr<ImageBuilder<S, 4096, Operations>> image_ =
      std::make_unique<ImageBuilder<S, 4096, Operations>>();
  Program<S, Operations> program_;
  Node node_;
};

template <class S>
void judge_all_counts(const char* test, std::uint64_t seed) {
  constexpr int fields = 70, points_per_field = 20;
  Random random(reference::announced_seed(test, seed));
  std::printf("%s: log-sum-exp of any number, greatest observed of what is certified\n",
              ScalarName<S>::text().c_str());
  for (const int operands : {2, 3, 4, 5, 6, 7, 8, 0}) {
    BlendBounds bounds;
    for (int i = 0; i < fields; ++i) {
      const Real size = real(ScalarTraits<S>::domain()) * random.uniform(0.05L, 0.4L);
      const ManyOperandField<S> field(random, operands, size);
      ASSERT_TRUE(field.program().valid()) << static_cast<int>(field.program().status());
      for (int k = 0; k < points_per_field; ++k) bounds.judge(field.program(), field.tree(), size, random);
    }
    bounds.conclude(operands == 0 ? "of 2 to 8 operands" : "of " + std::to_string(operands) + " operands");
    EXPECT_GT(bounds.erosion_share(), 0.9L) << "of " << operands;
    EXPECT_GT(bounds.inflation_share(), 0.9L) << "of " << operands;
  }
}

TEST(ManyOperandCertificate, OfLogSumExpInFixed27) {
  judge_all_counts<Fixed<27>>("OfLogSumExpInFixed27", 121);
}
TEST(ManyOperandCertificate, OfLogSumExpInFixed16) {
  judge_all_counts<Fixed<16>>("OfLogSumExpInFixed16", 122);
}
TEST(ManyOperandCertificate, OfLogSumExpInFloat) { judge_all_counts<float>("OfLogSumExpInFloat", 123); }

}  // namespace
}  // namespace nearfield::property
