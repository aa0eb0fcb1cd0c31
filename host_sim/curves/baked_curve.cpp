#include "curves/baked_curve.hpp"

namespace nearfield::host {
namespace {

// The shape that tabulate() would choose.
template <class S> std::optional<TableShape> choose(const AnyCurve& curve, const CurveFacts& facts, const TableRequest& request) {
  const bool monotone = facts.direction != Direction::none;
  const double rounding = detail::rounding_of_value<S>(request.bits);
  const double limit = request.greatest_error() - rounding;
  const CandidateShapes candidates = candidate_shapes(facts, request);
  const auto deviation_of = [&](const TableShape& shape) {
    const auto form = tabulated_form(curve, facts, shape.over_square);
    const double argument_error = detail::argument_error_of<S>(form.start, form.length);
    return deviation_of_shape(form, shape, monotone, argument_error, 0, shape.segments, limit).total();
  };
  std::optional<TableShape> best;
  double least = 0.0;
  // Backwards, so that of equally good ones the first stays, as in tabulate().
  for (int i = candidates.count - 1; i >= 0 && request.log2_error == 0; --i) {
    const TableShape& shape = candidates.shapes[i];
    const double deviation = deviation_of(shape);
    if (!best || detail::no_worse(deviation, least, rounding)) {
      best = shape;
      least = deviation;
    }
  }
  for (int i = 0; i < candidates.count && request.log2_error > 0; ++i) {
    if (deviation_of(candidates.shapes[i]) <= limit) return candidates.shapes[i];
  }
  return best;
}

}  // namespace

template <class S> BakedSample BakedCurve<S>::sample(S x) const {
  return with_view(*this, [&](const auto& view, auto rising) -> BakedSample {
    const auto raw = sample_curve<true, rising.value>(view, layout.placement, x);
    if constexpr (ScalarTraits<S>::is_fixed) {
      return {Fixed<30>::from_raw(raw.value).to_double(), raw.slope / detail::power_of_two(layout.slope_fraction_bits)};
    } else {
      return {static_cast<double>(raw.value), static_cast<double>(raw.slope)};
    }
  });
}

template <class S> std::optional<BakedCurve<S>> bake_curve(const AnyCurve& curve, const TableRequest& request) {
  const CurveFacts facts = curve.facts();
  const bool monotone = facts.direction != Direction::none;
  const std::optional<TableShape> shape = choose<S>(curve, facts, request);
  if (!shape) return std::nullopt;

  const auto form = tabulated_form(curve, facts, shape->over_square);
  std::vector<detail::SegmentEnds> ends;
  detail::PolynomialBounds bounds;
  for (int i = 0; i < shape->segments; ++i) {
    const auto surveyed = detail::survey<1>(form, *shape, i, monotone);
    ends.push_back(surveyed.ends[0]);
    bounds.include(surveyed.bounds);
  }
  BakedCurve<S> baked;
  baked.layout = detail::layout_of<S>(facts, *shape, form.start, form.length, bounds);
  if (!baked.layout.usable) return std::nullopt;

  detail::Deviation worst;
  const auto bake_all = [&](auto degree, auto bits, auto rising) {
    detail::KnotAim aim;
    for (int i = 0; i < shape->segments; ++i) {
      const auto segment = detail::bake_segment<S, degree.value, bits.value, rising.value>(
          form, *shape, i, ends[static_cast<std::size_t>(i)], baked.layout.scale, aim);
      aim = segment.next;
      for (const auto word : segment.words) {
        if constexpr (bits.value == 16) baked.narrow.push_back(word);
        else baked.wide.push_back(word);
      }
      worst.include(segment.deviation.value, segment.deviation.slope);
    }
    const auto view = view_of<degree.value, bits.value>(baked);
    baked.table_facts = detail::facts_with_errors(view, shape->segments, worst, true, baked.layout.scale);
    return 0;
  };
  with_format<S>(*shape, baked.layout.rising, bake_all);
  std::int32_t error = 0, slope_error = 0;
  detail::state_curve_errors(baked.table_facts, baked.layout, facts.middle_jump, error, slope_error);
  if (error == greatest_of<std::int32_t>) return std::nullopt;
  baked.error = error * detail::power_of_two(-30);
  baked.slope_error = slope_error * detail::power_of_two(-24);
  return baked;
}

#define NEARFIELD_INSTANTIATE(S)  \
  template struct BakedCurve<S>;  \
  template std::optional<BakedCurve<S>> bake_curve<S>(const AnyCurve&, const TableRequest&);
NEARFIELD_INSTANTIATE(Fixed<27>)
NEARFIELD_INSTANTIATE(Fixed<24>)
NEARFIELD_INSTANTIATE(Fixed<16>)
NEARFIELD_INSTANTIATE(float)
#undef NEARFIELD_INSTANTIATE

}  // namespace nearfield::host
