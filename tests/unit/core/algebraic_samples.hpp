// Operands of algebraic blends for tests: constants with gradients, and fields of a few quadrics.
#pragma once

#include <nearfield/field/compose.hpp>
#include <reference/random.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <limits>
#include <vector>

namespace nearfield::test {

using reference::Random;
using reference::Real;
using reference::Vec3;

using AllScalars = testing::Types<Fixed<27>, Fixed<24>, Fixed<16>, float>;

template <class S>
S number(Real real) {
  if constexpr (ScalarTraits<S>::is_fixed)
    return S(static_cast<double>(real));
  else
    return static_cast<float>(real);
}
template <class S>
Real real(S x) {
  return static_cast<Real>(ScalarTraits<S>::to_double(x));
}
template <class S>
Vec3 real(const Vector3<S>& v) {
  return {real(v.x), real(v.y), real(v.z)};
}
template <class S>
Vector3<S> vector(const Vec3& v) {
  return {number<S>(v.x), number<S>(v.y), number<S>(v.z)};
}
// One unit in the last place; of float at this size.
template <class S>
Real unit(Real size) {
  if constexpr (ScalarTraits<S>::is_fixed)
    return real(S::unit_in_last_place());
  else
    return std::max(std::fabs(size), Real{1e-30L}) * std::ldexp(Real{1}, -23);
}

template <class S>
Sample<S> sample(Random& random, Real greatest, Real greatest_slope) {
  return {number<S>(random.uniform(-greatest, greatest)),
          vector<S>(random.vector(-greatest_slope, greatest_slope))};
}

// sum of partials[i] * gradient of operands[i].
template <class S>
Vec3 chained(const std::vector<Sample<S>>& operands, const std::vector<Real>& partials) {
  Vec3 sum{};
  for (size_t i = 0; i < operands.size(); ++i) sum = sum + partials[i] * real(operands[i].gradient);
  return sum;
}
inline Real greatest_component(const Vec3& v) {
  return std::max({std::fabs(v.x), std::fabs(v.y), std::fabs(v.z)});
}

template <class S>
bool same(const Sample<S>& a, const Sample<S>& b) {
  return a.value == b.value && a.gradient == b.gradient;
}

// The greatest of what was seen in units of what is allowed.
class Ratio {
 public:
  void see(Real seen, Real allowed) { greatest_ = std::max(greatest_, seen / allowed); }
  Real greatest() const { return greatest_; }

 private:
  Real greatest_ = 0;
};

inline Vec3 in_ball(Random& random, Real radius) {
  const Real distance = random.uniform(0, radius * 0.999L);
  return distance * random.unit_vector();
}

// Whether a certificate holds for a field and the exact function that it stands for, at random points and
// pairs.
struct CertificateCheck {
  Ratio error, magnitude, rate;

  template <class S, class Field, class Exact>
  void look(const Certificate<S>& certificate, const Field& field, const Exact& exact, Random& random,
            Real reach, int count) {
    ASSERT_TRUE(certificate.valid);
    ASSERT_LT(certificate.magnitude, algebraic_limit<S>());
    for (int i = 0; i < count; ++i) {
      const Vector3<S> at = vector<S>(in_ball(random, reach));
      const Vec3 p = real(at),
                 q = random.chance(0.5L) ? p + 0.01L * random.unit_vector() : in_ball(random, reach);
      const Real evaluated = real(field(at));
      error.see(std::fabs(evaluated - exact(p)), real(certificate.error));
      magnitude.see(std::max(std::fabs(evaluated), std::fabs(exact(p))), real(certificate.magnitude));
      if (certificate.lipschitz == kNoRateBound || norm(q) > reach) continue;
      const Real rise = std::fabs(exact(p) - exact(q));
      rate.see(rise, static_cast<Real>(certificate.lipschitz.to_double()) * 16 * distance(p, q));
    }
  }
  void expect_bounds(const char* name) const {
    std::printf("%s: greatest ratio to the bound: error %.3Lf, magnitude %.3Lf, lipschitz %.3Lf\n", name,
                error.greatest(), magnitude.greatest(), rate.greatest());
    EXPECT_LE(error.greatest(), 1);
    EXPECT_LE(magnitude.greatest(), 1);
    EXPECT_LE(rate.greatest(), 1);
    EXPECT_GT(error.greatest(), 0);
  }
};

// The same of a composition with this exact function, over a reach in metres.
template <class S, class Node, class Exact>
void look_at_node(CertificateCheck& check, const Node& node, const Exact& exact, Random& random, Real reach) {
  using Traits = nearfield::detail::NodeTraits<Node>;
  check.look<S>(
      Traits::certificate(node, Reach<S>{number<S>(reach)}),
      [&](const Vector3<S>& p) { return Traits::template evaluate<Value<S>>(node, p, nullptr).value; }, exact,
      random, reach, 40);
}

// Leaves with real parameters, and the exact functions that they are rounded from.
struct RealPlane {
  Vec3 normal;
  Real offset;

  template <class S>
  AlgebraicPlane<S> as() const {
    return {vector<S>(normal), number<S>(offset)};
  }
  Real value(const Vec3& p) const { return dot(normal, p) - offset; }
  Vec3 gradient(const Vec3&) const { return normal / 16; }
};
struct ExactQuadric {
  Vec3 diagonal, off_diagonal, linear;
  Real constant;

  template <class S>
  Quadric<S> as() const {
    return {vector<S>(diagonal), vector<S>(off_diagonal), vector<S>(linear), number<S>(constant)};
  }
  Vec3 times(const Vec3& p) const {
    const auto &d = diagonal, &o = off_diagonal;
    return {d.x * p.x + o.z * p.y + o.y * p.z, o.z * p.x + d.y * p.y + o.x * p.z,
            o.y * p.x + o.x * p.y + d.z * p.z};
  }
  Real value(const Vec3& p) const { return dot(p, times(p)) + dot(linear, p) + constant; }
  Vec3 gradient(const Vec3& p) const { return (2 * times(p) + linear) / 16; }
};
inline RealPlane random_plane(Random& random) { return {random.vector(-1, 1), random.uniform(-1, 1)}; }
inline ExactQuadric random_quadric(Random& random) {
  return {random.vector(-1, 1), random.vector(-1, 1), random.vector(-1, 1), random.uniform(-1, 1)};
}

}  // namespace nearfield::test
