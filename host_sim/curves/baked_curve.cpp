#include "curves/baked_curve.hpp"

namespace nearfield::host {
namespace {

// Calls work(degree, bits, rising) with the numbers as types.
template <int number> struct Number { static constexpr int value = number; };

template <class S, class Work> auto with_format(const TableShape& shape, bool rising, const Work& work) {
  const auto with_rising = [&](auto degree, auto bits) {
    return rising ? work(degree, bits, Number<1>{}) : work(degree, bits, Number<0>{});
  };
  const auto with_bits = [&](auto degree) {
    if constexpr (ScalarTraits<S>::is_fixed) {
      if (shape.bits == 16) return with_rising(degree, Number<16>{});
    }
    return with_rising(degree, Number<32>{});
  };
  return shape.degree == 1 ? with_bits(Number<1>{}) : shape.degree == 2 ? with_bits(Number<2>{}) : with_bits(Number<3>{});
}

template <class S, int degree, int bits> TableView<S, degree, bits> view_of(const BakedCurve<S>& curve) {
  TableView<S, degree, bits> view;
  if constexpr (bits == 16) view.coefficients = curve.narrow.data();
  else view.coefficients = curve.wide.data();
  view.index_bits = index_bits_for(curve.layout.shape.segments);
  view.slope_headroom = curve.slope_headroom;
  return view;
}

// The shape that tabulate() would choose.
template <class S> std::optional<TableShape> choose(const AnyCurve& curve, const CurveFacts& facts, const TableRequest& request) {
  const bool monotone = facts.direction != Direction::none;
  const double limit = request.greatest_error() - detail::rounding_of_value<S>(request.bits);
  const double rounding = detail::rounding_of_value<S>(request.bits);
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
  return with_format<S>(layout.shape, layout.rising, [&](auto degree, auto bits, auto rising) -> BakedSample {
    const auto view = view_of<S, degree.value, bits.value>(*this);
    const auto raw = sample_curve<true, rising.value != 0>(view, layout.placement, x);
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
  double steepest = 0.0, sharpest = 0.0, tallest = 0.0;
  for (int i = 0; i < shape->segments; ++i) {
    const auto surveyed = detail::survey<1>(form, *shape, i, monotone);
    ends.push_back(surveyed.ends[0]);
    steepest = greatest_of_two(steepest, surveyed.steepest);
    sharpest = greatest_of_two(sharpest, surveyed.sharpest);
    tallest = greatest_of_two(tallest, surveyed.tallest);
  }
  BakedCurve<S> baked;
  baked.layout = detail::layout_of<S>(facts, *shape, form.start, form.length, steepest, sharpest, tallest);
  if (!baked.layout.usable) return std::nullopt;
  baked.slope_headroom = baked.layout.scale.slope_headroom;

  detail::Deviation worst;
  const auto bake_all = [&](auto degree, auto bits, auto rising) {
    detail::KnotAim aim;
    for (int i = 0; i < shape->segments; ++i) {
      const auto segment = detail::bake_segment<S, degree.value, bits.value, rising.value != 0>(
          form, *shape, i, ends[static_cast<std::size_t>(i)], baked.layout.scale, aim);
      aim = segment.next;
      for (const auto word : segment.words) {
        if constexpr (bits.value == 16) baked.narrow.push_back(word);
        else baked.wide.push_back(word);
      }
      worst.include(segment.deviation.value, segment.deviation.slope);
    }
    const auto view = view_of<S, degree.value, bits.value>(baked);
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
