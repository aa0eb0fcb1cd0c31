#include "curves/curve_study.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace nearfield::host {
namespace {

template <class S> struct TypeOf { using type = S; };

// Calls work(TypeOf<S>) with the type of the scalar.
template <class Work> auto with_type(CurveScalar scalar, const Work& work) {
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

// The nearest argument that S has, or if that is not within (low, high) the next one that is.
template <class S> double nearest_within(double x, double low, double high) {
  const double nearest = ScalarTraits<S>::to_double(S(static_cast<S>(x)));
  if constexpr (ScalarTraits<S>::is_fixed) {
    const double unit = detail::power_of_two(-S::fraction_bits);
    return nearest <= low ? nearest + unit : nearest >= high ? nearest - unit : nearest;
  } else {
    constexpr float infinity = std::numeric_limits<float>::infinity();
    const float single = static_cast<float>(nearest);
    // Zero's neighbours are too small to tell from it.
    if (nearest <= low) return static_cast<double>(single == 0.0f ? 1e-12f : std::nextafter(single, infinity));
    return nearest >= high ? static_cast<double>(std::nextafter(single, -infinity)) : nearest;
  }
}

double nearest_argument(const CurveStudy& study, double x, bool strictly_within) {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  const CurveFacts facts = study.curve().facts();
  return with_type(study.scalar, [&](auto type) {
    using S = typename decltype(type)::type;
    return strictly_within ? nearest_within<S>(x, facts.from, facts.to) : nearest_within<S>(x, -infinity, infinity);
  });
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

template <class S> StudiedTable studied(const AnyCurve& curve, BakedCurve<S> baked) {
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
    row.argument = nearest_argument(study, facts.from + share * (facts.to - facts.from), facts.end_jump > 0.0);
    row.exact = study.curve()(Differentiable::argument(row.argument));
    if (study.table) row.table = study.table->sample_at(row.argument);
    rows.push_back(row);
  }
  return rows;
}

}  // namespace nearfield::host
