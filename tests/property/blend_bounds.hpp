#pragma once
/// What a certificate of a distance field states, against the reference, and how near to it random points
/// come: a bound that is merely loose shows.

#include <nearfield/field/program.hpp>

#include "property/bound.hpp"
#include "reference/field.hpp"
#include "reference/random.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <string>

namespace nearfield::property {

class BlendBounds {
 public:
  /// A random point of a program and its tree, within `size` metres of the origin, and another one for the
  /// rate.
  template <class S, class Operations>
  void judge(const Program<S, Operations>& program, const reference::Node& node, Real size,
             reference::Random& random) {
    using reference::Vec3;
    const Certificate<S>& certificate = program.certificate();
    const S limit = ScalarTraits<S>::domain();
    const Vector3<S> anywhere = rounded<S>(random.vector(-size, size));
    const Vector3<S> p = {clamp(anywhere.x, -limit, limit), clamp(anywhere.y, -limit, limit),
                          clamp(anywhere.z, -limit, limit)};
    const Vec3 at = real(p);
    const Real truth = reference::value(node, at), sharp = reference::sharp_value(node, at);

    const Real error = std::fabs(real(program.template evaluate<Value<S>>(p, nullptr).value) - truth);
    error_.note(error, real(certificate.error));
    const Real slack = 1e-17L * (1 + size);
    erosion_.note(truth - sharp - slack, real(certificate.erosion));
    inflation_.note(sharp - truth - slack, real(certificate.inflation));
    const Vec3 other = at + size * std::pow(Real{10}, random.uniform(-6, 0)) * random.unit_vector();
    const Real rate =
        (std::fabs(reference::value(node, other) - truth) - slack) / reference::distance(at, other);
    rate_.note(rate, real(certificate.lipschitz));
    ++points_;
  }

  void conclude(const std::string& name) const {
    std::printf("  %-26s %6lld: error %.3Lf, rate %.6Lf, erosion %.3Lf, inflation %.3Lf of the certified\n",
                name.c_str(), points_, error_.share, rate_.share, erosion_.share, inflation_.share);
    error_.failures.expect_none(name + ": |evaluated - f(p)| <= error");
    rate_.failures.expect_none(name + ": |f(p) - f(q)| <= lipschitz |p - q|");
    erosion_.failures.expect_none(name + ": blended <= sharp + erosion");
    inflation_.failures.expect_none(name + ": blended >= sharp - inflation");
    EXPECT_GT(rate_.share, 0.95L) << name;
  }
  Real erosion_share() const { return erosion_.share; }
  Real inflation_share() const { return inflation_.share; }

 private:
  Bound error_, rate_, erosion_, inflation_;
  long long points_ = 0;
};

}  // namespace nearfield::property
