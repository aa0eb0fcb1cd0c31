// Tables of program images, made while the program runs: the same steps as bake() in the compiler, and the
// same bits.
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include <nearfield/field/image.hpp>
#include <nearfield/table/bake.hpp>

#include "curves/curve_settings.hpp"

namespace nearfield::host {

// What a table is made of: a function over [0, 1], see bake().
struct TableFunction {
  std::string identity;  // the same for the same function
  double range = 1.0;    // of its argument, in units of its own parameter
  std::function<Differentiable(const Differentiable&)> exact;
  detail::Breaks kinks = {};

  Differentiable operator()(const Differentiable& u) const { return exact(u); }
  detail::Breaks breaks() const { return kinks; }
};

// A blending kernel of nearfield/curve/kernel.hpp.
template <class Kernel>
TableFunction table_function(std::string identity, const Kernel& kernel) {
  return {std::move(identity), argument_range(kernel), kernel, detail::breaks_of(kernel, 0)};
}
// Its name and parameters, the same for the same curve.
std::string identity_of(const ConfiguredCurve& curve);
// A potential over u = r / end or its square, where `end`, the function's range, is the end of the
// potential's: 1 but for range control.
TableFunction potential_function(const ConfiguredCurve& potential);
TableFunction potential_over_square(const ConfiguredCurve& potential);
// A profile of nearfield/curve/ray_kernel.hpp.
template <class Profile>
TableFunction profile_function(std::string identity, const Profile& profile) {
  return {std::move(identity), 1.0, profile, detail::breaks_of(profile, 0)};
}

// A table as an image holds it: cubic, coefficients of 32 bits, a power of two of segments.
struct ImageTable {
  int index_bits = 0;
  int slope_headroom = 0;
  TableFacts facts;
  std::vector<std::uint32_t> coefficients;

  // Whether operations take it: the function fits into the format, and the table errs by less than 2^-6.
  bool usable() const { return facts.error >= 0 && facts.error < (1 << 24); }
};

// The table of the fewest segments, a power of two up to 256, that errs by at most 2^-23 of the function's
// unit (float: 2^-22 more, the kernel's own rounding); if there is none, the one that errs least. S: the
// scalar of the fields that sample it.
template <class S>
ImageTable bake_table(const TableFunction& function);

}  // namespace nearfield::host
