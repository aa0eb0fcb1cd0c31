// Measures what the kernels cost on this core: the worst instruction counts over some hundred arguments, in
// line in a loop and as a call, of the tables and of what a user would write instead. One row a kernel, value
// only and value with slope. Fails if the counter is not exact or a table is not near the function it was
// baked from.
#include <nearfield/curve/step.hpp>
#include <nearfield/table/bake.hpp>

#include <board/semihosting.hpp>
#include <board/worst_instruction_count.hpp>

namespace {

using namespace nearfield;
using board::ValueAndSlope;
using Q = Fixed<27>;

// Arguments in [0, 1). Every border of up to 64 segments and its two neighbours, then numbers anywhere; in
// units of 2^-bits.
constexpr uint32_t kBorderArguments = 3 * 64;
constexpr uint32_t kArguments = kBorderArguments + 128;

uint32_t argument_of_bits(uint32_t i, int bits) {
  if (i < kBorderArguments) return ((i + 1) / 3 << (bits - 6)) + (i + 1) % 3 - 1;
  return (i * 2654435761u) >> (32 - bits);
}

uint32_t fixed_argument(uint32_t i) { return argument_of_bits(i, 31); }

// The same as floats, then numbers of every magnitude below 1, subnormal ones included.
constexpr uint32_t kFloatArguments = kArguments + 128;

float float_argument(uint32_t i) {
  constexpr uint32_t kBitsOfOne = 0x3f800000;
  if (i < kArguments) return static_cast<float>(argument_of_bits(i, 24)) * (1.0f / 16777216.0f);
  return bits_as<float>(multiply_high(i * 2654435761u, kBitsOfOne));
}

// The tables, for use in line, and their views as a program meets them that was loaded: known at run time
// only.
constexpr auto kStep = bake<Q>(step::over_unit_interval(step::polynomial<3>));
constexpr auto kFloatStep = bake<float>(step::over_unit_interval(step::polynomial<3>));

template <class S>
[[gnu::noipa]] TableView<S> at_run_time(TableView<S> view) {
  return view;
}
TableView<Q> step_view;
TableView<float> float_step_view;

ValueAndSlope<int32_t> words_of(const TableSample<Q>& sample) {
  return {sample.value.raw(), sample.slope.raw()};
}
ValueAndSlope<float> words_of(const TableSample<float>& sample) { return {sample.value, sample.slope}; }

template <bool with_slope, class S>
[[gnu::noipa]] auto sample_called(const TableView<S>& table, typename TableArgument<S>::type argument) {
  if constexpr (with_slope)
    return words_of(sample_table<true>(table, argument));
  else
    return words_of(sample_table<false>(table, argument)).value;
}

// The step H_3 over [0, 1] in its three pieces.
[[gnu::always_inline]] inline ValueAndSlope<float> exact_step(float u) {
  const float x = 3.0f * u;
  if (x <= 0.0f) return {0.0f, 0.0f};
  if (x < 1.0f) return {x * x * x * (1.0f / 6.0f), 1.5f * x * x};
  if (x < 2.0f) {
    const float y = x - 1.5f;
    return {0.5f + y * (0.75f - y * y * (1.0f / 3.0f)), 3.0f * (0.75f - y * y)};
  }
  if (x < 3.0f) {
    const float y = 3.0f - x;
    return {1.0f - y * y * y * (1.0f / 6.0f), 1.5f * y * y};
  }
  return {1.0f, 0.0f};
}

// The potential of Wyvill as a function of the squared distance.
[[gnu::always_inline]] inline ValueAndSlope<float> exact_potential(float u) {
  if (u >= 1.0f) return {0.0f, 0.0f};
  return {((-4.0f / 9.0f * u + 17.0f / 9.0f) * u - 22.0f / 9.0f) * u + 1.0f,
          (-12.0f / 9.0f * u + 34.0f / 9.0f) * u - 22.0f / 9.0f};
}

// The same where the compiler cannot inline it.
[[gnu::noipa]] float called_step_value(float u) { return exact_step(u).value; }
[[gnu::noipa]] ValueAndSlope<float> called_step(float u) { return exact_step(u); }
[[gnu::noipa]] float called_potential_value(float u) { return exact_potential(u).value; }
[[gnu::noipa]] ValueAndSlope<float> called_potential(float u) { return exact_potential(u); }

bool failed = false;

constexpr size_t kNameWidth = 40, kCountWidth = 8;

void write_right_aligned(uint32_t number, size_t width) {
  size_t digits = 1;
  for (uint32_t rest = number; rest >= 10; rest /= 10) ++digits;
  for (; digits < width; ++digits) board::write(" ");
  board::write_decimal(number);
}

void write_row(const char* name, uint32_t value, uint32_t value_and_slope) {
  size_t length = 0;
  while (name[length] != '\0') ++length;
  board::write(name);
  for (; length < kNameWidth; ++length) board::write(" ");
  write_right_aligned(value, kCountWidth);
  write_right_aligned(value_and_slope, kCountWidth);
  board::write("\n");
  if (value == 0 || value_and_slope == 0) {
    board::write("  0 is no count: a measurement failed\n");
    failed = true;
  }
}

// One row: a name and the kernel without and with slope, of a fixed-point or a float argument; lambdas both.
template <class Value, class Both>
void fixed_row(const char* name, Value value, Both both) {
  write_row(name, board::worst_instruction_count(value, fixed_argument, kArguments),
            board::worst_instruction_count(both, fixed_argument, kArguments));
}
template <class Value, class Both>
void float_row(const char* name, Value value, Both both) {
  write_row(name, board::worst_instruction_count(value, float_argument, kFloatArguments),
            board::worst_instruction_count(both, float_argument, kFloatArguments));
}

bool near(float a, float b, float tolerance) { return a - b < tolerance && b - a < tolerance; }

// Whether a table is near the function that stands for it in float, within its range.
template <class Exact>
void check(const char* name, const TableView<Q>& table, Exact exact) {
  for (uint32_t i = 0; i < kArguments; ++i) {
    const uint32_t argument = fixed_argument(i);
    const ValueAndSlope<int32_t> sampled = sample_called<true>(table, argument);
    const ValueAndSlope<float> expected = exact(static_cast<float>(argument) * (1.0f / 2147483648.0f));
    if (near(static_cast<float>(sampled.value) * (1.0f / 1073741824.0f), expected.value, 1e-4f) &&
        near(static_cast<float>(sampled.slope) * (1.0f / 134217728.0f), expected.slope, 1e-2f)) {
      continue;
    }
    board::write(name);
    board::write(": the table is not near the function\n");
    failed = true;
    return;
  }
}

}  // namespace

int main() {
  if (!board::prepare_instruction_counter()) return 1;
  step_view = at_run_time(kStep.view());
  float_step_view = at_run_time(kFloatStep.view());

  board::write("worst instructions of each kernel on " NEARFIELD_CORE ": value, value and slope\n");
  fixed_row(
      "cubic table, 32 bits, in line",
      [](uint32_t t) { return words_of(sample_table<false>(kStep.view(), t)).value; },
      [](uint32_t t) { return words_of(sample_table<true>(kStep.view(), t)); });
  fixed_row(
      "cubic table, 32 bits, called", [](uint32_t t) { return sample_called<false>(step_view, t); },
      [](uint32_t t) { return sample_called<true>(step_view, t); });
  float_row(
      "cubic table, float, in line",
      [](float t) { return words_of(sample_table<false>(kFloatStep.view(), t)).value; },
      [](float t) { return words_of(sample_table<true>(kFloatStep.view(), t)); });
  float_row(
      "cubic table, float, called", [](float t) { return sample_called<false>(float_step_view, t); },
      [](float t) { return sample_called<true>(float_step_view, t); });
  float_row(
      "step H_3 by its pieces, float, in line", [](float u) { return exact_step(u).value; },
      [](float u) { return exact_step(u); });
  float_row(
      "step H_3 by its pieces, float, called", [](float u) { return called_step_value(u); },
      [](float u) { return called_step(u); });
  float_row(
      "Wyvill potential, float, in line", [](float u) { return exact_potential(u).value; },
      [](float u) { return exact_potential(u); });
  float_row(
      "Wyvill potential, float, called", [](float u) { return called_potential_value(u); },
      [](float u) { return called_potential(u); });

  check("step", step_view, exact_step);
  return failed ? 1 : 0;
}
