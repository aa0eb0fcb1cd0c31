#include "render/scene_field.hpp"

#include <algorithm>
#include <cmath>

#include <nearfield/query/soft_clearance.hpp>
#include <nearfield/shape/algebraic_bounds.hpp>

#include "simulate/field_at_rest.hpp"

namespace nearfield::host {
namespace {

constexpr double careful_factor = 1.0 - 1e-9;  // covers the roundings of double

template <class S>
double real(S value) {
  return ScalarTraits<S>::to_double(value);
}

template <class S>
class SceneFieldIn final : public SceneField {
 public:
  SceneFieldIn(const SceneDescription& scene, const std::vector<double>& parameters,
               std::optional<double> level)
      : field_(scene, parameters),
        kind_(field_.program.kind()),
        level_(level.value_or(surface_level(kind_))),
        sign_(kind_ == Kind::intensity ? -1.0 : 1.0),
        metres_per_gradient_(kind_ == Kind::distance ? 1.0 : detail::power_of_two(kGradientLengthLog2)),
        domain_(real(ScalarTraits<S>::domain())),
        saturation_((1.0 - 1e-6) * real(algebraic_limit<S>())),
        doubtful_(kind_ == Kind::algebraic ? 0.125 * saturation_ : saturation_),
        rounding_(1.8 * real(ScalarTraits<S>::rounding_unit(ScalarTraits<S>::domain()))) {
    const Certificate<S>& certificate = field_.program.certificate();
    if (certificate.lipschitz != kNoRateBound && !certificate.partial) {
      // A rate of 0 is that of a constant.
      proof_.rate = std::max(certificate.lipschitz.to_double() / metres_per_gradient_, 1e-6);
    }
    proof_.error = real(certificate.error);
    // What is found in a ball is found of intensities within their range alone.
    highest_ = field_.program.has_highest() && proof_.error < 0.5 && level_ > proof_.error;
  }

  Kind kind() const override { return kind_; }
  double level() const override { return level_; }
  double domain() const override { return domain_; }
  const FieldProof& proof() const override { return proof_; }
  bool certified() const override { return proof_.rate.has_value() || highest_; }

  double value(const Vector3d& p) const override {
    return real(field_.program.template evaluate<Value<S>>(quantise<S>(p), field_.slots).value);
  }
  double outward(const Vector3d& p) const override { return sign_ * (value(p) - level_); }
  FieldAnswer at(const Vector3d& p) const override {
    const Sample<S> sample = field_.at(quantise<S>(p));
    // A gradient says nothing of a value that ends there.
    const double factor = std::abs(real(sample.value)) < saturation_ ? sign_ / metres_per_gradient_ : 0.0;
    const Vector3d gradient{real(sample.gradient.x), real(sample.gradient.y), real(sample.gradient.z)};
    const double largest = std::max({std::abs(gradient.x), std::abs(gradient.y), std::abs(gradient.z)});
    return {sign_ * (real(sample.value) - level_), factor * gradient, largest >= doubtful_};
  }

  double free_radius(const Vector3d& p, double guess) const override {
    if (!certified()) return 0.0;
    const double f = outward(p), by_rate = free_radius_where(f);
    if (!highest_ || f <= proof_.error) return by_rate;
    return std::max(by_rate, careful(radius_below_level(p, std::max(guess, by_rate), by_rate)));
  }
  bool is_free(const Vector3d& p, double radius) const override {
    if (!certified()) return false;
    const double f = outward(p);
    if (free_radius_where(f) >= radius) return true;
    const double needed = (radius + rounding_) / careful_factor;
    return highest_ && f > proof_.error && needed <= domain_ && proved(quantise<S>(p), needed);
  }
  double free_radius_where(double outward) const override {
    return proof_.rate ? careful((std::abs(outward) - proof_.error) / *proof_.rate) : 0.0;
  }

 private:
  // By the field's greatest value in a ball.
  bool proved(const nearfield::Vector3<S>& centre, double radius) const {
    return real(field_.program.highest(centre, quantise<S>(radius), field_.slots).value) + proof_.error <
           level_;
  }
  double careful(double radius) const { return std::max(0.0, careful_factor * radius - rounding_); }

  // Of the radii guess 2^k, the greatest of a few that highest() proves; 0 when none is. `known`: a radius
  // known to be free, with which a search that finds nothing soon contents itself.
  double radius_below_level(const Vector3d& p, double guess, double known) const {
    const nearfield::Vector3<S> centre = quantise<S>(p);
    const auto proved = [&](double radius) { return this->proved(centre, radius); };
    const double greatest = domain_,
                 least = known > 0.0 ? std::max(1.4 * known, 0.2 * guess) : 64.0 * rounding_;
    double radius = std::min(std::max(guess, least), greatest);
    if (proved(radius)) {
      for (int doubling = 0; doubling < 3 && 2.0 * radius <= greatest && proved(2.0 * radius); ++doubling)
        radius *= 2.0;
      return radius;
    }
    while (radius > 2.0 * least) {
      radius *= 0.5;
      if (proved(radius)) return radius;
    }
    return 0.0;
  }

  FieldAtRest<S> field_;
  Kind kind_;
  double level_, sign_, metres_per_gradient_, domain_, saturation_, doubtful_;
  double rounding_;  // m: how far a point moves at most when it becomes one of the scalar's
  FieldProof proof_;
  bool highest_ = false;
};

}  // namespace

double surface_level(Kind kind) { return kind == Kind::intensity || kind == Kind::ray ? 0.5 : 0.0; }

const char* name_of(Kind kind) {
  switch (kind) {
    case Kind::distance:
      return "distance";
    case Kind::intensity:
      return "intensity";
    case Kind::ray:
      return "ray";
    case Kind::algebraic:
      break;
  }
  return "algebraic";
}

std::unique_ptr<SceneField> scene_field(const SceneDescription& scene, FieldScalar scalar,
                                        const std::vector<double>& parameters, std::optional<double> level) {
  switch (scalar) {
    case FieldScalar::q27:
      return std::make_unique<SceneFieldIn<Fixed<27>>>(scene, parameters, level);
    case FieldScalar::q24:
      return std::make_unique<SceneFieldIn<Fixed<24>>>(scene, parameters, level);
    case FieldScalar::q16:
      return std::make_unique<SceneFieldIn<Fixed<16>>>(scene, parameters, level);
    case FieldScalar::single:
      break;
  }
  return std::make_unique<SceneFieldIn<float>>(scene, parameters, level);
}

}  // namespace nearfield::host
