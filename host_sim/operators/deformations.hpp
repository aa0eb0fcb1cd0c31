// Random deformations, and influence radii that depend on the place.
#pragma once

#include <algorithm>
#include <cmath>

#include <nearfield/curve/radius_profile.hpp>
#include <nearfield/modify/noise.hpp>
#include <nearfield/modify/scale_about.hpp>
#include <nearfield/modify/scale_along.hpp>
#include <nearfield/modify/scale_from_axis.hpp>

#include "operators/parameter.hpp"
#include "operators/ray.hpp"

namespace nearfield::host::operators {

// Solid noise on a field; the frequency is rounded to a multiple of 2^-16.
template <FieldKind kind>
struct NoiseOperator {
  static constexpr bool moves = kind == FieldKind::distance;

  static OperatorDescription description() {
    const NumberRange amplitudes{-16.0, 16.0, moves ? "m" : ""};
    return of_one(blend(moves ? "noise_distance" : "noise_intensity", kind,
                        {fitting(Fit::number, {"amplitude", 1, amplitudes}),
                         {"frequency", 1, {1.0 / 1024.0, 1024.0, "1/m"}},
                         {"octaves", 1, {1.0, 4.0, {}}, {1.0}, {}, true},
                         {"seed", 1, {0.0, 4294967295.0, {}}, {0.0}, {}, true}}));
  }
  static void add(FieldEmitter& emitter, const FieldNode& node) {
    const double amplitude = node.number("amplitude"), frequency = node.number("frequency");
    const auto octaves = static_cast<std::uint32_t>(node.number("octaves"));
    const auto seed = static_cast<std::uint32_t>(node.number("seed"));
    require_slopes(emitter, node, std::abs(amplitude) / (2.0 - std::pow(0.5, octaves - 1.0)));
    emitter.operand(node.operands.front());
    emitter.operation([&](auto zero) {
      using S = decltype(zero);
      const SolidNoise<S, kind> noise(quantise<S>(amplitude), Fixed<16>(frequency), octaves, seed);
      if constexpr (moves)
        return NoiseDistance<S>{noise};
      else
        return NoiseIntensity<S>{noise};
    });
  }

 private:
  // The gain times the frequency is below 16 per metre (intensities: per 1/16 m); of distances the rate, 15/4
  // times that an octave, leaves room for the operand's below 127.
  static void require_slopes(const FieldEmitter& emitter, const FieldNode& node, double gain) {
    const double steepest = moves ? std::min(15.99, 100.0 / (3.75 * node.number("octaves"))) : 16.0 * 15.99;
    const double most = std::min(1024.0, steepest / std::max(gain, 1e-9));
    emitter.require(node, "frequency", node.number("frequency"), {1.0 / 1024.0, most, "1/m"});
  }
};

// A radius over a parameter: the spline through "values".
inline ParameterDescription radius_values() {
  ParameterDescription values{"values", 2, {kLeastProfileRadius, kGreatestProfileRadius, {}}};
  values.most = ValueSpline::greatest_count;
  return values;
}
struct RadiusProfile {
  ValueSpline spline;
  ProfileRange range;

  RadiusProfile(const FieldEmitter& emitter, const FieldNode& node, bool periodic) {
    const std::vector<double>& values = node.parameters.at("values");
    spline = ValueSpline(values.data(), static_cast<int>(values.size()), periodic);
    range = range_of(spline);
    if (fits_table(spline)) return;
    emitter.refuse(node, "values",
                   "the spline through them goes from " + format_number(range.least) + " to " +
                       format_number(range.greatest),
                   "from " + format_number(kLeastProfileRadius) + " to " +
                       format_number(kGreatestProfileRadius) + ", the greatest at most " +
                       format_number(kGreatestProfileRatio) + " times the least");
  }
  // As ray_cut() has it: values up to 2 stay.
  double cut() const { return std::min<double>(kGreatestRay, 2.0 * range.greatest); }
  // The factor halfway between the least and the greatest.
  double level() const { return 0.5 / range.least + 0.5 / range.greatest; }

  template <class Profile>
  static std::uint32_t table(FieldEmitter& emitter, const FieldNode& node, const char* name,
                             const Profile& profile) {
    std::string identity = name;
    for (const double value : node.parameters.at("values")) identity += " " + format_number(value);
    return emitter.table(node, "values", {identity, 1.0, profile, profile.breaks()});
  }
};

// The operand's influence radius times a function of the place along the segment from `from` to `to`.
struct ScaleAlongOperator {
  static OperatorDescription description() {
    return of_one(blend("scale_along", FieldKind::ray,
                        {required_point("from"), required_point("to"), radius_values()}));
  }
  static void add(FieldEmitter& emitter, const FieldNode& node) {
    const RadiusProfile radius(emitter, node, false);
    const Ends ends = ends_of(emitter, node);
    const double reach = length(ends.to - ends.from);
    if (!(reach >= 1.0 / 64.0)) {
      emitter.refuse(node, "to", format_number(reach) + " m from `from`", "at least 0.015625 m");
    }
    emitter.operand(node.operands.front());
    const std::uint32_t table = RadiusProfile::table(emitter, node, "along", along_profile(radius.spline));
    emitter.operation(
        [&](auto zero) {
          using S = decltype(zero);
          return ScaleAlong<S>(quantise_capsule<S>(ends.from, ends.to, 0.0), quantise<S>(radius.cut()));
        },
        table);
  }
};

// The same of the distance from the local z axis, from 0 to `limit`.
struct ScaleFromAxisOperator {
  static OperatorDescription description() {
    return of_one(blend("scale_from_axis", FieldKind::ray,
                        {fitting(Fit::length, {"limit", 1, ray_radius_range}), radius_values()}));
  }
  static void add(FieldEmitter& emitter, const FieldNode& node) {
    const RadiusProfile radius(emitter, node, false);
    const double limit = node.number("limit");
    emitter.operand(node.operands.front());
    const std::uint32_t table = RadiusProfile::table(emitter, node, "along", along_profile(radius.spline));
    emitter.operation(
        [&](auto zero) {
          using S = decltype(zero);
          return ScaleFromAxis<S>(quantise<S>(limit), quantise<S>(radius.cut()));
        },
        table);
  }
};

// The same of the angle about the local z axis, counted from a direction that turns by `twist` rad/m; with
// `ring`, m, about the circle of that radius in the plane z = 0.
struct ScaleAboutOperator {
  static OperatorDescription description() {
    ParameterDescription ring = fitting(Fit::number, {"ring", 1, {0.0, 16.0, "m"}});
    ring.optional = true;
    ring.instead_of = {"twist"};
    return of_one(blend("scale_about", FieldKind::ray,
                        {radius_values(),
                         fitting(Fit::length, {"core", 1, ray_radius_range}),
                         {"twist", 1, {-790.0, 790.0, "rad/m"}, {0.0}},
                         ring}));
  }
  static void add(FieldEmitter& emitter, const FieldNode& node) {
    const RadiusProfile radius(emitter, node, true);
    const double core = node.number("core"), turns = node.number("twist") / (2.0 * kPi);
    const std::vector<double>& ring = node.parameters.at("ring");
    emitter.operand(node.operands.front());
    const std::uint32_t table = RadiusProfile::table(emitter, node, "about", about_profile(radius.spline));
    emitter.operation(
        [&](auto zero) {
          using S = decltype(zero);
          ScaleAbout<S> scale;
          scale.cut = quantise<S>(radius.cut());
          scale.core = nearfield::detail::RayScaleRange<S>(quantise<S>(core));
          scale.level = quantise<Unit<S>>(radius.level());
          scale.twist = quantise<typename ScaleAbout<S>::Twist>(turns);
          if (!ring.empty()) {
            scale.ring = quantise<S>(ring.front());
            scale.about = AngleAbout::ring;
          }
          return scale;
        },
        table);
  }
};

}  // namespace nearfield::host::operators
