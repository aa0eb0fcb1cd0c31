// Exact curves into tables: in the compiler with tabulate(), on the host with the same steps one by one.
// Never linked into a target.
#pragma once

#include <nearfield/curve/curve_table.hpp>
#include <nearfield/curve/request.hpp>
#include <nearfield/table/bake.hpp>

namespace nearfield {

// Everything about a tabulated curve but its coefficients.
template <class S> struct CurveLayout {
  TableShape shape;
  detail::CoefficientScale scale;
  bool usable = false;  // values and slopes fit
  bool rising = false;
  int slope_fraction_bits = 0;
  double slope_factor = 1.0;  // slopes of the curve per unit of its argument from slopes per unit argument of the table
  double argument_error = 0.0;  // greatest rounding of the table's argument, as a fraction of its range
  double sharpest = 0.0;        // bound of the second derivative over that range
  CurvePlacement<S> placement;
};

namespace detail {

// Segments baked in one go: few enough for the step limits of compilers.
inline constexpr int kChunk = 16;
// Slopes up to 2^(this + 1) per unit argument of a table.
inline constexpr int kSlopeHeadroom = 3;

constexpr uint32_t as_fraction(double x, uint32_t) { return x == 1.0 ? 0u : static_cast<uint32_t>(x * 4294967296.0 + 0.5); }
constexpr float as_fraction(double x, float) { return x == 1.0 ? 0.0f : static_cast<float>(x); }

// Deviations below the kernel's rounding are as good as none.
constexpr bool no_worse(double a, double b, double rounding) { return a <= greatest_of_two(b, rounding); }

constexpr Deviation greater_of(const Deviation& a, const Deviation& b) {
  Deviation both = a;
  both.include(b.value, b.slope, b.argument);
  return both;
}

// How far the argument of the table may be off, as a fraction of its range: products with reciprocals that are rounded
// down, and the rounding of where the range begins and ends.
template <class S> constexpr double argument_error_of(double start, double length) {
  using T = ScalarTraits<S>;
  const double end = start + length;
  const double start_off = magnitude(T::to_double(S(static_cast<S>(start))) - start);
  const double end_off = magnitude(T::to_double(S(static_cast<S>(end))) - end);
  return (T::is_fixed ? 1.0 / 268435456.0 : 1.0 / 4194304.0) + 2.0 * (start_off + end_off) / length;
}

template <class S>
constexpr CurveLayout<S> layout_of(const CurveFacts& facts, const TableShape& shape, double start, double length,
                                   const PolynomialBounds& bounds) {
  CurveLayout<S> layout;
  layout.shape = shape;
  const int index_bits = index_bits_for(shape.segments);
  const ScaleChoice choice =
      choose_scale(shape, bounds, index_bits > kSlopeHeadroom ? index_bits : kSlopeHeadroom);
  layout.scale = choice.scale;
  layout.usable = choice.usable;
  layout.rising = choice.scale.slope_headroom > index_bits;
  layout.argument_error = argument_error_of<S>(start, length);
  layout.sharpest = bounds.sharpest;

  CurvePlacement<S>& placement = layout.placement;
  placement.from = S(static_cast<S>(facts.from));
  placement.to = S(static_cast<S>(facts.to));
  placement.start = S(static_cast<S>(start));
  placement.before = Unit<S>(static_cast<Unit<S>>(facts.before));
  placement.after = Unit<S>(static_cast<Unit<S>>(facts.after));
  placement.squared = shape.over_square;
  placement.mirrored = !shape.over_square && facts.antisymmetric;
  const S length_of_table = subtract_in_range(placement.to, placement.start);
  placement.scale = ArgumentScale<S>::of(length_of_table);
  placement.square_scale = SquareScale<S>::of(length_of_table);
  using Argument = typename TableArgument<S>::type;
  placement.stretch = as_fraction(1.0 / choice.scale.per_unit, Argument{});

  // Over the square, P'(x) = 2 x P'(u) per unit of u.
  const double unit_length = shape.over_square ? length * length : length;
  layout.slope_factor = 1.0 / (choice.scale.per_unit * unit_length);
  double stored = layout.slope_factor;
  layout.slope_fraction_bits = 30 - choice.scale.slope_headroom;
  if constexpr (ScalarTraits<S>::is_fixed) {
    // As many fraction bits as leave room for the steepest slope.
    const double greatest = shape.over_square ? 0.5 / facts.to : 1.0;
    for (; stored > greatest; stored *= 0.5) --layout.slope_fraction_bits;
    for (; stored <= 0.5 * greatest; stored *= 2.0) ++layout.slope_fraction_bits;
  }
  placement.slope_factor = as_fraction(stored, Argument{});
  return layout;
}

template <int count, class S, int degree, int bits> struct BakedChunk {
  BakedSegment<S, degree, bits> segments[static_cast<size_t>(count)] = {};
};
template <int count, class S, int degree, int bits, bool rising, class Form>
constexpr BakedChunk<count, S, degree, bits> bake_chunk(const Form& form, const CurveLayout<S>& layout, int first,
                                                        const SegmentEnds* ends, KnotAim aim) {
  BakedChunk<count, S, degree, bits> chunk;
  for (int i = 0; layout.usable && i < count && first + i < layout.shape.segments; ++i) {
    chunk.segments[i] = bake_segment<S, degree, bits, rising>(form, layout.shape, first + i, ends[i], layout.scale, aim);
    aim = chunk.segments[i].next;
  }
  return chunk;
}

// The errors of the whole curve from those of its table: in the curve's own unit, the rounding of the argument included.
template <class S>
constexpr void state_curve_errors(const TableFacts& facts, const CurveLayout<S>& layout, double middle_jump, int32_t& error,
                                  int32_t& slope_error) {
  error = slope_error = greatest_of<int32_t>;
  if (facts.error == greatest_of<int32_t>) return;
  const double steepest = greatest_of_two(magnitude(facts.greatest_slope), magnitude(facts.least_slope)) / 16777216.0;
  const double off = layout.argument_error / layout.scale.per_unit;
  error = round_up(facts.error / 1073741824.0 + steepest * off + middle_jump, 1073741824.0);
  const double reach = layout.shape.over_square ? 2.0 * ScalarTraits<S>::to_double(layout.placement.to) : 1.0;
  const double slope = facts.slope_error / 16777216.0 + layout.sharpest * layout.scale.per_unit * layout.argument_error;
  if (facts.slope_error != greatest_of<int32_t>) slope_error = round_up(slope * layout.slope_factor * reach, 16777216.0);
  if (slope_error < greatest_of<int32_t> - 4) slope_error += 4;  // roundings of the slope itself
}

// The search and the baking of one curve, cut into constant expressions of bounded length each.
template <class S, const auto& curve, class Request> struct Tabulation {
  static constexpr CurveFacts facts = curve_facts(curve);
  static constexpr bool monotone = facts.direction != Direction::none;
  static constexpr TableRequest request = Request::value;
  static constexpr CandidateShapes candidates = candidate_shapes(facts, request);
  static constexpr double rounding = rounding_of_value<S>(request.bits);
  static constexpr double limit = request.greatest_error() - rounding;

  template <int candidate>
  static constexpr auto candidate_form = tabulated_form(curve, facts, candidates.shapes[candidate].over_square);
  template <int candidate>
  static constexpr double argument_error =
      argument_error_of<S>(candidate_form<candidate>.start, candidate_form<candidate>.length);
  template <int candidate, int chunk>
  static constexpr Deviation chunk_deviation =
      deviation_of_shape(candidate_form<candidate>,
                         candidates.shapes[candidate], monotone, argument_error<candidate>, chunk * kChunk, kChunk, limit);

  template <int candidate, int chunk = 0> static constexpr Deviation deviation() {
    constexpr Deviation here = chunk_deviation<candidate, chunk>;
    if constexpr (!(here.total() <= limit) || (chunk + 1) * kChunk >= candidates.shapes[candidate].segments) return here;
    else return greater_of(here, deviation<candidate, chunk + 1>());
  }
  // The first candidate within the limit; when the best is asked for, the first that is no worse than any. -1: none.
  template <int candidate = 0> static constexpr int choose() {
    if constexpr (candidate == candidates.count) return -1;
    else if constexpr (request.log2_error > 0) {
      if constexpr (deviation<candidate>().total() <= limit) return candidate;
      else return choose<candidate + 1>();
    } else {
      constexpr int rest = choose<candidate + 1>();
      if constexpr (rest < 0) return candidate;
      else return no_worse(deviation<candidate>().total(), deviation<rest>().total(), rounding) ? candidate : rest;
    }
  }

  static constexpr int chosen = choose<>();
  static_assert(curve_problem(curve) == nullptr, "the curve's parameters are out of range: see its problem()");
  static_assert(chosen >= 0, "no table of the size asked for comes within the error asked for");
  static constexpr TableShape shape = candidates.shapes[chosen < 0 ? 0 : chosen];
  static constexpr auto form = tabulated_form(curve, facts, shape.over_square);
  static constexpr int chunk_count = (shape.segments + kChunk - 1) / kChunk;

  template <int chunk>
  static constexpr SurveyedSegments<kChunk> surveyed = survey<kChunk>(form, shape, chunk * kChunk, monotone);
  template <int chunk = 0> static constexpr PolynomialBounds bounds() {
    PolynomialBounds all = surveyed<chunk>.bounds;
    if constexpr (chunk + 1 < chunk_count) all.include(bounds<chunk + 1>());
    return all;
  }
  static constexpr CurveLayout<S> layout = layout_of<S>(facts, shape, form.start, form.length, bounds<>());
  static_assert(layout.usable, "the curve is too steep for a table of this size");

  template <int chunk> static constexpr KnotAim aim_of() {
    if constexpr (chunk == 0) return {};
    else return baked<chunk - 1>.segments[kChunk - 1].next;
  }
  template <int chunk>
  static constexpr auto baked = bake_chunk<kChunk, S, shape.degree, shape.bits, layout.rising>(
      form, layout, chunk * kChunk, surveyed<chunk>.ends, aim_of<chunk>());

  using Result = CurveTable<S, shape.segments, shape.degree, shape.bits, layout.rising, layout.slope_fraction_bits>;
  template <int chunk = 0> static constexpr void fill(Result& result, Deviation& worst) {
    for (int i = 0; i < kChunk && chunk * kChunk + i < shape.segments; ++i) {
      const auto& segment = baked<chunk>.segments[i];
      for (int j = 0; j <= shape.degree; ++j) {
        result.table.coefficients[(shape.degree + 1) * (chunk * kChunk + i) + j] = segment.words[j];
      }
      worst.include(segment.deviation.value, segment.deviation.slope);
    }
    if constexpr (chunk + 1 < chunk_count) fill<chunk + 1>(result, worst);
  }
  static constexpr Result result() {
    Result result;
    result.placement = layout.placement;
    result.table.slope_headroom = layout.scale.slope_headroom;
    result.table.range = S(static_cast<S>(form.length));
    Deviation worst;
    fill<>(result, worst);
    result.table.facts = facts_with_errors(result.table.view(), shape.segments, worst, layout.usable, layout.scale);
    state_curve_errors(result.table.facts, layout, facts.middle_jump, result.error, result.slope_error);
    return result;
  }
};

}  // namespace detail

// The table of a curve in the compiler:
//   constexpr potential::Blanc hard{0.05};
//   constexpr auto table = tabulate<Fixed<27>, hard, Within<16>>();
// `curve` is a constexpr variable outside functions (or a static one). The smallest table that meets the request;
// what cannot be met does not compile. No compiler needs a flag for it. The same table to the bit on the host.
template <class S, const auto& curve, class Request = Within<20>> constexpr auto tabulate() {
  return detail::Tabulation<S, curve, Request>::result();
}

}  // namespace nearfield
