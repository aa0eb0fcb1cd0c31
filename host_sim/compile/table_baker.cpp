#include "compile/table_baker.hpp"

#include <algorithm>

#include <nearfield/curve/tabulated_form.hpp>

namespace nearfield::host {
namespace {

constexpr double sought_error = 1.0 / 8388608.0;
// Slopes that sample_table() and the loader take.
constexpr int greatest_image_headroom = 3;

template <class S>
ImageTable bake_with(const TableFunction& function, int index_bits) {
  const TableShape shape{3, 1 << index_bits, 32, false};
  std::vector<detail::SegmentEnds> ends;
  detail::PolynomialBounds bounds;
  for (int i = 0; i < shape.segments; ++i) {
    const auto surveyed = detail::survey<1>(function, shape, i, false);
    ends.push_back(surveyed.ends[0]);
    bounds.include(surveyed.bounds);
  }
  const detail::ScaleChoice choice =
      detail::choose_scale(shape, bounds, std::min(index_bits, greatest_image_headroom));
  ImageTable table;
  table.index_bits = index_bits;
  table.slope_headroom = choice.scale.slope_headroom;
  table.coefficients.resize(4 * ends.size());
  detail::Deviation worst;
  detail::KnotAim aim;
  for (std::size_t i = 0; choice.usable && i < ends.size(); ++i) {
    const auto baked = detail::bake_segment<S, 3, 32, false>(function, shape, static_cast<int>(i), ends[i],
                                                             choice.scale, aim);
    aim = baked.next;
    std::copy(std::begin(baked.words), std::end(baked.words),
              table.coefficients.begin() + static_cast<std::ptrdiff_t>(4 * i));
    worst.include(baked.deviation.value, baked.deviation.slope);
  }
  const TableView<S> view{table.coefficients.data(), table.index_bits, table.slope_headroom};
  table.facts = detail::facts_with_errors(view, shape.segments, worst, choice.usable, choice.scale);
  return table;
}

}  // namespace

std::string identity_of(const ConfiguredCurve& curve) { return curve.name + "(" + curve.parameters + ")"; }

TableFunction potential_function(const ConfiguredCurve& potential) {
  const auto function = over_range(potential.curve);
  return {identity_of(potential), potential.curve.facts().to, function, function.breaks()};
}

TableFunction potential_over_square(const ConfiguredCurve& potential) {
  const AnyCurve curve = potential.curve;
  const CurveFacts facts = curve.facts();
  TableFunction function;
  function.identity = "square " + identity_of(potential);
  function.range = facts.to;
  function.exact = [curve, facts](const Differentiable& u) { return tabulated_form(curve, facts, true)(u); };
  function.kinks = detail::tabulated_breaks(facts, true);
  return function;
}

template <class S>
ImageTable bake_table(const TableFunction& function) {
  const double rounding = ScalarTraits<S>::is_fixed ? 0.0 : 1.0 / 4194304.0;
  const auto limit = static_cast<std::int32_t>((sought_error + rounding) * 1073741824.0);
  ImageTable best;
  for (int index_bits = 0; index_bits <= static_cast<int>(image_format::greatest_index_bits); ++index_bits) {
    ImageTable table = bake_with<S>(function, index_bits);
    if (index_bits == 0 || table.facts.error < best.facts.error) best = std::move(table);
    if (best.facts.error <= limit) break;
  }
  return best;
}

template ImageTable bake_table<Fixed<27>>(const TableFunction&);
template ImageTable bake_table<Fixed<24>>(const TableFunction&);
template ImageTable bake_table<Fixed<16>>(const TableFunction&);
template ImageTable bake_table<float>(const TableFunction&);

}  // namespace nearfield::host
