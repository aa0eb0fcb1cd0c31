// What the kernel costs on this core, next to what a user would write instead: the worst instruction counts over some
// hundred arguments, in line in a loop. One row a table format or function, value only and value with slope, then the
// comparison of KW's Table 1. Fails if the counter is not exact or a table is not near the function it stands for.
#include <nearfield/curve/curves.hpp>
#include <nearfield/curve/tabulate.hpp>

#include <board/cost_rows.hpp>
#include <board/console.hpp>

#include <float_curves.hpp>

namespace {

using namespace nearfield;
using board::Cost;
using board::ValueAndSlope;
using board::write_padded;
using board::write_right_aligned;
using Q = Fixed<27>;

// Arguments in [0, 1). Every border of up to 64 segments and its two neighbours, then numbers anywhere; in
// units of 2^-bits.
constexpr uint32_t kBorderArguments = 3 * 64;
constexpr uint32_t kArguments = kBorderArguments + 128;

uint32_t argument_of_bits(uint32_t i, int bits) {
  if (i < kBorderArguments) return ((i + 1) / 3 << (bits - 6)) + (i + 1) % 3 - 1;
  return (i * 2654435761u) >> (32 - bits);
}
uint32_t table_argument(uint32_t i) { return argument_of_bits(i, 31); }
// From -1 to 1, both beyond and within.
uint32_t step_argument(uint32_t i) { return argument_of_bits(i, 28) * 5 / 4 - 5 * (1u << 25); }

// The same as floats, then numbers of every magnitude below 1, subnormal ones included.
constexpr uint32_t kFloatArguments = kArguments + 128;

float float_argument(uint32_t i) {
  constexpr uint32_t kBitsOfOne = 0x3f800000;
  if (i < kArguments) return static_cast<float>(argument_of_bits(i, 24)) * (1.0f / 16777216.0f);
  return bits_as<float>(multiply_high(i * 2654435761u, kBitsOfOne));
}

constexpr auto kStepFunction = step::over_unit_interval(step::polynomial<3>);
template <int degree, int bits> constexpr auto kStep = bake<Q, 32, degree, bits>(kStepFunction);
constexpr auto kFloatStep = bake<float>(kStepFunction);
constexpr auto kMirroredStep = tabulate<Q, step::polynomial<3>>();

// A view as a program meets it that was loaded: known at run time only.
[[gnu::noipa]] TableView<Q> at_run_time(TableView<Q> view) { return view; }
TableView<Q> step_view;

ValueAndSlope<int32_t> words_of(const TableSample<Q>& sample) { return {sample.value.raw(), sample.slope.raw()}; }
ValueAndSlope<float> words_of(const TableSample<float>& sample) { return {sample.value, sample.slope}; }

[[gnu::noipa]] int32_t value_called(const TableView<Q>& table, uint32_t t) { return sample_table<false>(table, t).value.raw(); }
[[gnu::noipa]] ValueAndSlope<int32_t> both_called(const TableView<Q>& table, uint32_t t) {
  return words_of(sample_table<true>(table, t));
}

bool failed = false;

void row(const char* name, Cost cost) { failed = !board::write_row(name, cost) || failed; }

// A kernel without and with slope, over arguments of its own kind; lambdas both.
template <class Value, class Both> Cost fixed_cost(Value value, Both both, uint32_t (*argument)(uint32_t) = table_argument) {
  return {board::worst_instruction_count(value, argument, kArguments), board::worst_instruction_count(both, argument, kArguments)};
}
template <class Value, class Both> Cost float_cost(Value value, Both both) {
  return {board::worst_instruction_count(value, float_argument, kFloatArguments),
          board::worst_instruction_count(both, float_argument, kFloatArguments)};
}

template <int degree, int bits> Cost table_cost() {
  return fixed_cost([](uint32_t t) { return sample_table<false>(kStep<degree, bits>.view(), t).value.raw(); },
                    [](uint32_t t) { return words_of(sample_table<true>(kStep<degree, bits>.view(), t)); });
}

#define NEARFIELD_FUNCTION_COST(function)                                        \
  float_cost([](float x) { return straightforward::function<false>(x).value; },  \
             [](float x) {                                                       \
               const straightforward::Jet jet = straightforward::function<true>(x); \
               return ValueAndSlope<float>{jet.value, jet.slope};                \
             })

bool near(float a, float b, float tolerance) { return a - b < tolerance && b - a < tolerance; }

// Whether a table is near the function that stands for it in float, within its range.
template <class Table, class Exact>
void check(const char* name, const Table& table, Exact exact, float value_tolerance, float slope_tolerance) {
  for (uint32_t i = 0; i < kArguments; ++i) {
    const uint32_t argument = table_argument(i);
    const ValueAndSlope<int32_t> sampled = words_of(sample_table<true>(table.view(), argument));
    const straightforward::Jet expected = exact(static_cast<float>(argument) * (1.0f / 2147483648.0f));
    if (near(static_cast<float>(sampled.value) * (1.0f / 1073741824.0f), expected.value, value_tolerance) &&
        near(static_cast<float>(sampled.slope) * (1.0f / 134217728.0f), expected.slope, slope_tolerance)) {
      continue;
    }
    board::write(name);
    board::write(": the table is not near the function\n");
    failed = true;
    return;
  }
}

// KW, Table 1: efficiency relative to the cubic polynomial in r^2, in tenths.
void write_comparison(const char* name, Cost direct, Cost cubic, Cost table) {
  write_padded(name, 34);
  write_right_aligned(direct.both, 7);
  const uint32_t tenths = cubic.both == 0 ? 0 : (10 * direct.both + cubic.both / 2) / cubic.both;
  write_right_aligned(tenths / 10, 6);
  board::write(".");
  board::write_decimal(tenths % 10);
  write_right_aligned(table.both, 9);
  board::write("\n");
}

}  // namespace

int main() {
  if (!board::prepare_instruction_counter()) return 1;
  step_view = at_run_time(kStep<3, 32>.view());

  board::write("worst instructions in line on " NEARFIELD_CORE ": value, value and slope\n");
  const Cost table = table_cost<3, 32>();
  row("cubic table, 32 bits", table);
  row("quadratic table, 32 bits", table_cost<2, 32>());
  row("linear table, 32 bits", table_cost<1, 32>());
  const Cost short_table = table_cost<3, 16>();
  row("cubic table, 16 bits", short_table);
  row("quadratic table, 16 bits", table_cost<2, 16>());
  row("linear table, 16 bits", table_cost<1, 16>());
  row("cubic table of a program, called",
            fixed_cost([](uint32_t t) { return value_called(step_view, t); }, [](uint32_t t) { return both_called(step_view, t); }));
  row("mirrored curve at its own argument",
            fixed_cost([](uint32_t t) { return kMirroredStep.sample<false>(Q::from_raw(static_cast<int32_t>(t))).value.raw(); },
                       [](uint32_t t) {
                         const auto sample = kMirroredStep.sample(Q::from_raw(static_cast<int32_t>(t)));
                         return ValueAndSlope<int32_t>{sample.value.raw(), sample.slope.raw()};
                       },
                       step_argument));
  row("cubic table, float",
            float_cost([](float t) { return sample_table<false>(kFloatStep.view(), t).value; },
                       [](float t) { return words_of(sample_table<true>(kFloatStep.view(), t)); }));

  const Cost wyvill = NEARFIELD_FUNCTION_COST(wyvill), spline = NEARFIELD_FUNCTION_COST(natural_spline);
  const Cost bezier = NEARFIELD_FUNCTION_COST(bezier), bspline = NEARFIELD_FUNCTION_COST(bspline);
  const Cost arctangent = NEARFIELD_FUNCTION_COST(arctangent), parametric = NEARFIELD_FUNCTION_COST(parametric_bezier);
  row("float: step H_3 by its pieces", NEARFIELD_FUNCTION_COST(polynomial_step));
  row("float: rising cutoff R_2", NEARFIELD_FUNCTION_COST(rising_cutoff));
  row("float: logistic step", NEARFIELD_FUNCTION_COST(logistic));
  row("float: cubic potential", NEARFIELD_FUNCTION_COST(cubic));
  row("float: Wyvill potential, of r^2", wyvill);
  row("float: Blanc potential, of r^2", NEARFIELD_FUNCTION_COST(blanc));
  row("float: natural spline, 5 points", spline);
  row("float: Bezier, degree 5", bezier);
  row("float: B-spline, degree 3, 3 knots", bspline);
  row("float: arctangent", arctangent);
  row("float: parametric Bezier", parametric);

  board::write("value and slope: direct in float, relative to the cubic in r^2, any of them as a table\n");
  write_comparison("cubic polynomial in r^2", wyvill, wyvill, table);
  write_comparison("interpolating cubic spline", spline, wyvill, table);
  write_comparison("nonparametric Bezier curve", bezier, wyvill, table);
  write_comparison("nonparametric B-spline", bspline, wyvill, table);
  write_comparison("arctangent", arctangent, wyvill, table);
  write_comparison("parametric spline", parametric, wyvill, table);

  const auto exact = [](float u) { return straightforward::polynomial_step<true>(u); };
  check("cubic, 32 bits", kStep<3, 32>, exact, 1e-4f, 1e-2f);
  check("cubic, 16 bits", kStep<3, 16>, exact, 2e-4f, 2e-2f);
  check("quadratic, 32 bits", kStep<2, 32>, exact, 1e-3f, 5e-2f);
  check("linear, 32 bits", kStep<1, 32>, exact, 3e-3f, 2e-1f);
  return failed ? 1 : 0;
}
