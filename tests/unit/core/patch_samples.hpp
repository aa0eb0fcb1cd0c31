// Patches with any number of sides for tests, from samples of their operands, and what they may be off by.
#pragma once

#include "algebraic_samples.hpp"

#include <reference/implicit_patches.hpp>

namespace nearfield::test {

// A patch's parameters, its operands by meaning, and both patches in their order of operands.
template <class S>
struct RandomPatch {
  reference::PatchCoefficients weights;
  std::vector<Sample<S>> primaries, bounds;

  std::vector<Real> primary_values() const { return values(primaries); }
  std::vector<Real> bound_values() const { return values(bounds); }
  template <class Patch>
  Patch as() const {
    Patch patch;
    patch.side_count = static_cast<uint32_t>(bounds.size());
    patch.exponent = static_cast<uint32_t>(weights.exponent);
    for (size_t i = 0; i < bounds.size(); ++i) patch.side_weight[i] = number<S>(weights.side[i]);
    patch.centre_weight = number<S>(weights.bound);
    return patch;
  }
  template <class Out>
  Out ribbon() const {
    std::vector<Out> of;
    for (size_t i = 0; i < bounds.size(); ++i) {
      of.push_back(part<Out>(primaries[i]));
      of.push_back(part<Out>(bounds[i]));
    }
    return as<RibbonPatch<S>>().template combine_all<Out>(of.data());
  }
  template <class Out>
  Out corner() const {
    std::vector<Out> of;
    for (const auto& primary : primaries) of.push_back(part<Out>(primary));
    for (const auto& bound : bounds) of.push_back(part<Out>(bound));
    return as<CornerPatch<S>>().template combine_all<Out>(of.data());
  }

 private:
  static std::vector<Real> values(const std::vector<Sample<S>>& samples) {
    std::vector<Real> reals;
    for (const auto& one : samples) reals.push_back(real(one.value));
    return reals;
  }
  template <class Out>
  static Out part(const Sample<S>& whole) {
    if constexpr (Out::has_gradient)
      return whole;
    else
      return {whole.value};
  }
};

// Bounds of all sizes and zeros among them; weights are numbers of S.
template <class S>
RandomPatch<S> random_patch(Random& random, int64_t fewest_sides, Real zero_share) {
  RandomPatch<S> patch;
  const int64_t sides = random.integer(fewest_sides, 8);
  patch.weights.exponent = static_cast<int>(random.integer(2, 3));
  patch.weights.bound = real(number<S>(random.uniform(-1, 1)));
  for (int64_t i = 0; i < sides; ++i) {
    patch.weights.side.push_back(real(number<S>(random.chance(0.3L) ? Real{1} : random.uniform(-1, 1))));
    patch.primaries.push_back(sample<S>(random, 1.5L, 0.125L));
    Sample<S> bound = sample<S>(random, 1.5L, 0.125L);
    if (random.chance(0.3L)) {
      const int halvings = static_cast<int>(random.integer(3, 12));
      bound.value = number<S>(std::ldexp(random.uniform(-1, 1), -halvings));
    }
    if (random.chance(zero_share)) bound.value = S{};
    patch.bounds.push_back(bound);
  }
  return patch;
}

// What the value may be off by: units for the means and the weights, and those of a float's terms.
template <class S>
Real value_tolerance() {
  return ScalarTraits<S>::is_fixed ? 3 * unit<S>(1) : 6 * unit<S>(1);
}

struct PatchRatios {
  Ratio value, gradient;
  int gradients = 0;

  template <class S>
  void look(const Sample<S>& got, const RandomPatch<S>& patch, const reference::PatchPoint& expected) {
    value.see(std::fabs(real(got.value) - expected.value), value_tolerance<S>());
    // Slopes by bounds carry the value's rounding divided by the bound, and all of it is relative to what
    // cancels.
    const Vec3 exact =
        chained(patch.primaries, expected.by_primaries) + chained(patch.bounds, expected.by_bounds);
    Real allowed = 3 * unit<S>(1), size = 0;
    for (size_t i = 0; i < patch.bounds.size(); ++i) {
      const Real bound = std::fabs(real(patch.bounds[i].value));
      const Real slope = greatest_component(real(patch.bounds[i].gradient));
      if (bound > 0) allowed += 4 * unit<S>(1) * slope / bound;
      size += slope * std::fabs(expected.by_bounds[i]);
    }
    allowed += size * std::ldexp(Real{1}, ScalarTraits<S>::is_fixed ? -28 : -21);
    if (greatest_component(exact) > 0.9L * real(algebraic_limit<S>())) return;
    gradient.see(greatest_component(real(got.gradient) - exact), allowed);
    ++gradients;
  }
  void expect_bounds(const char* name) const {
    std::printf("%s: value %.3Lf, gradient %.3Lf of what is allowed\n", name, value.greatest(),
                gradient.greatest());
    EXPECT_LE(value.greatest(), 1);
    EXPECT_LE(gradient.greatest(), 1);
    EXPECT_GT(gradients, 1000);
  }
};

}  // namespace nearfield::test
