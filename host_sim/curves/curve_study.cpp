#include "curves/curve_study.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace nearfield::host {
namespace {

template <class S>
struct TypeOf {
  using type = S;
};

// Calls work(TypeOf<S>) with the type of the scalar.
template <class Work>
auto with_type(CurveScalar scalar, const Work& work) {
  switch (scalar) {
    case CurveScalar::q27:
      return work(TypeOf<Fixed<27>>{});
    case CurveScalar::q24:
      return work(TypeOf<Fixed<24>>{});
    case CurveScalar::q16:
      return work(TypeOf<Fixed<16>>{});
    case CurveScalar::single:
      break;
  }
  return work(TypeOf<float>{});
}

// The next argument above x that S has; for float, zero's is a small one rather than the least there is.
template <class S>
double next_above(double x) {
  if constexpr (ScalarTraits<S>::is_fixed)
    return x + detail::power_of_two(-S::fraction_bits);
  else
    return x == 0.0 ? 0x1p-40 : static_cast<double>(std::nextafter(static_cast<float>(x), 1e30f));
}

// The nearest argument that S has. `within`: if that is an end of the range or beyond, its neighbour inside.
template <class S>
double nearest_argument(double x, const CurveFacts& facts, bool within) {
  const auto rounded = [](double real) { return ScalarTraits<S>::to_double(S(static_cast<S>(real))); };
  const double nearest = rounded(x), from = rounded(facts.from), to = rounded(facts.to);
  if (within && nearest <= from) return next_above<S>(from);
  // The neighbour below is the mirror image of the one above.
  if (within && nearest >= to) return -next_above<S>(-to);
  return nearest;
}

std::vector<double> knots_of(const AnyCurve& curve, const TableShape& shape, bool mirrored) {
  const auto form = tabulated_form(curve, curve.facts(), shape.over_square);
  std::vector<double> knots;
  for (int i = 0; i <= shape.segments; ++i) {
    const double u = static_cast<double>(i) / shape.segments;
    const double offset = form.length * (shape.over_square ? std::sqrt(u) : u);
    knots.push_back(form.start + offset);
    if (mirrored && i > 0) knots.push_back(form.start - offset);
  }
  std::sort(knots.begin(), knots.end());
  return knots;
}

template <class S>
StudiedTable studied(const AnyCurve& curve, BakedCurve<S> baked) {
  StudiedTable table;
  table.shape = baked.layout.shape;
  table.mirrored = baked.layout.placement.mirrored;
  table.error = baked.error;
  table.slope_error = baked.slope_error;
  table.knots = knots_of(curve, table.shape, table.mirrored);
  table.sample_at = [baked = std::move(baked)](double x) { return baked.sample_at(x); };
  return table;
}

}  // namespace

CurveStudy study_of(const ConfiguredCurve& configured, const TableRequest& request, CurveScalar scalar) {
  CurveStudy study{configured, request, scalar, std::nullopt, false};
  with_type(scalar, [&](auto type) {
    using S = typename decltype(type)::type;
    const auto bake = [&](const TableRequest& wanted) {
      auto baked = bake_curve<S>(configured.curve, wanted);
      if (baked) study.table = studied<S>(configured.curve, std::move(*baked));
      return study.table && study.table->error <= wanted.greatest_error();
    };
    study.within_error = bake(request);
    if (study.within_error) return;
    TableRequest best = request;
    best.log2_error = 0;
    bake(best);
    study.within_error = study.table && study.table->error <= request.greatest_error();
  });
  return study;
}

std::string type_name(CurveScalar scalar) {
  switch (scalar) {
    case CurveScalar::q27:
      return "Fixed<27>";
    case CurveScalar::q24:
      return "Fixed<24>";
    case CurveScalar::q16:
      return "Fixed<16>";
    case CurveScalar::single:
      break;
  }
  return "float";
}

std::vector<CurveRow> rows_of(const CurveStudy& study, int count) {
  const CurveFacts facts = study.curve().facts();
  std::vector<CurveRow> rows;
  for (int i = 0; i < count; ++i) {
    const double share = static_cast<double>(i) / (count - 1);
    CurveRow row;
    const double x = facts.from + share * (facts.to - facts.from);
    row.argument = with_type(study.scalar, [&](auto type) {
      return nearest_argument<typename decltype(type)::type>(x, facts, facts.end_jump > 0.0);
    });
    // The end of the range is where the scalar has it.
    const bool at_end = i == count - 1 && !(facts.end_jump > 0.0);
    row.exact = study.curve()(Differentiable::argument(at_end ? facts.to : row.argument));
    if (study.table) row.table = study.table->sample_at(row.argument);
    rows.push_back(row);
  }
  return rows;
}

}  // namespace nearfield::host
