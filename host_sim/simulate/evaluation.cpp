#include "simulate/evaluation.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>

#include <nearfield/query/soft_clearance.hpp>
#include <nearfield/shape/algebraic_bounds.hpp>

#include "simulate/field_at_rest.hpp"
#include "text/input_error.hpp"
#include "text/number.hpp"

namespace nearfield::host {
namespace {

const char* name_of(ClearanceStatus status) {
  switch (status) {
    case ClearanceStatus::touching:
      return "touching";
    case ClearanceStatus::undecided:
      return "undecided";
    case ClearanceStatus::clear:
      return "clear";
    case ClearanceStatus::invalid:
      break;
  }
  return "invalid";
}

std::string list_of(const Vector3d& v) {
  return format_number(v.x) + "," + format_number(v.y) + "," + format_number(v.z);
}

// Zeros without a sign.
template <class S>
double real(S value) {
  return ScalarTraits<S>::to_double(value) + 0.0;
}

// Whether rounding to the scalar leaves a number where it is, but for that.
template <class S>
bool in_domain(const Vector3d& point) {
  const double limit = ScalarTraits<S>::to_double(ScalarTraits<S>::domain());
  const auto within_limit = [limit](double x) { return x >= -limit && x <= limit; };
  return within_limit(point.x) && within_limit(point.y) && within_limit(point.z);
}

using Numbers = std::array<double, 4>;  // value and gradient
template <class S>
Numbers numbers_of(const Sample<S>& sample) {
  return {real(sample.value), real(sample.gradient.x), real(sample.gradient.y), real(sample.gradient.z)};
}

// The same field in float, whose numbers end far beyond those of Fixed: what differs grossly has saturated on the way.
class WideField {
 public:
  WideField(const SceneDescription& scene, const std::vector<double>& parameters) {
    try {
      field_ = std::make_unique<FieldAtRest<float>>(scene, parameters);
    } catch (const InputError&) {
      // It fits the scalar asked for, but not float: there is nothing to compare with.
    }
  }
  bool differs(const Numbers& narrow, const Vector3d& point) const {
    if (!field_ || !in_domain<float>(point)) return false;
    const Numbers wide = numbers_of(field_->at(quantise<float>(point)));
    for (std::size_t i = 0; i < wide.size(); ++i) {
      const double allowed = (std::abs(wide[i]) + 1.0) / 64.0;
      // A gradient may be that of another operand where several are equal; what saturates is smaller.
      const double missing = i == 0 ? std::abs(wide[i] - narrow[i]) : std::abs(wide[i]) - std::abs(narrow[i]);
      if (missing > allowed) return true;
    }
    return false;
  }

 private:
  std::unique_ptr<FieldAtRest<float>> field_;
};

// What comes after the point in its line.
template <class S>
std::string answer(const FieldAtRest<S>& field, const WideField& wide, const Vector3d& point) {
  const nearfield::Vector3<S> p = quantise<S>(point);
  const Kind kind = field.program.kind();
  const Sample<S> sample = field.at(p);
  const Numbers numbers = numbers_of(sample);
  const double per_metre = kind == Kind::distance ? 1.0 : 1.0 / detail::power_of_two(kGradientLengthLog2);
  const std::string values = format_number(numbers[0]) + "," +
                             list_of(per_metre * Vector3d{numbers[1], numbers[2], numbers[3]});
  Clearance<S> found;
  if (kind == Kind::distance)
    found = clearance(field.program, p, field.slots);
  else if (kind == Kind::intensity)
    found = soft_clearance(field.program, p, field.slots);
  // Point and slots are acceptable: it is the field that has none.
  if (found.status == ClearanceStatus::invalid) {
    const double end = real(algebraic_limit<S>()) * (1.0 - 1e-6);
    const bool at_end = std::any_of(numbers.begin(), numbers.end(), [end](double x) { return !(std::abs(x) < end); });
    return values + (at_end || wide.differs(numbers, point) ? ",,saturated" : ",,no_clearance");
  }
  return values + "," + format_number(real(found.distance)) + "," + name_of(found.status);
}

template <class S>
std::string csv(const SceneDescription& scene, const std::vector<Vector3d>& points,
                const std::vector<double>& parameters) {
  const FieldAtRest<S> field(scene, parameters);
  const WideField wide(scene, parameters);
  std::string text = "x,y,z,value,gradient_x,gradient_y,gradient_z,clearance,status\n";
  for (const Vector3d& point : points) {
    text += list_of(point) + "," + (in_domain<S>(point) ? answer(field, wide, point) : ",,,,,invalid") + "\n";
  }
  return text;
}

}  // namespace

std::string evaluation_csv(const SceneDescription& scene, const std::vector<Vector3d>& points,
                           FieldScalar scalar, const std::vector<double>& parameters) {
  switch (scalar) {
    case FieldScalar::q27:
      return csv<Fixed<27>>(scene, points, parameters);
    case FieldScalar::q24:
      return csv<Fixed<24>>(scene, points, parameters);
    case FieldScalar::q16:
      return csv<Fixed<16>>(scene, points, parameters);
    case FieldScalar::single:
      return csv<float>(scene, points, parameters);
  }
  return "";
}

}  // namespace nearfield::host
