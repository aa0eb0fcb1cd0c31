// What a smooth union of two given distances costs on this core, next to what a user would write instead: the worst
// instruction counts over some hundred pairs, in line in a loop. Fails if the counter is not exact or a blend is not near
// its direct formula.
#include <nearfield/blend/additive.hpp>
#include <nearfield/curve/kernel.hpp>

#include <board/cost_rows.hpp>
#include <board/console.hpp>

#include <float_blends.hpp>

namespace {

using namespace nearfield;
using board::Several;
using Q = Fixed<27>;

// Blend radii: delta 0.24 m, epsilon 0.06 m; p = 20/m; k = 0.3 m.
constexpr float kDelta = 0.24f, kEpsilon = 0.06f, kSharpness = 20.0f, kLength = 0.3f;

template <int bits> constexpr auto kExterior = bake<Q, 32, 3, bits>(exterior(step::polynomial<3>, 0.25));
template <int bits> constexpr auto kLogSumExp = bake<Q, 32, 3, bits>(LogSumExpKernel{});
template <int bits> constexpr auto kQuadratic = bake<Q, 1, 3, bits>(QuadraticKernel{});
constexpr auto kFloatExterior = bake<float, 32>(exterior(step::polynomial<3>, 0.25));

// The union of a range with a table.
template <const auto& table, const auto& blend> struct Tabulated {
  template <class Out> Out operator()(const Out& a, const Out& b) const { return blend.combine(a, b, table.view()); }
};
template <class S> constexpr AdditiveUnion<S> union_of_range(S range) { return {ArgumentScale<S>::of(range)}; }
constexpr auto kExteriorUnion = union_of_range(Q(0.3)), kLogSumExpUnion = union_of_range(Q(0.9));
constexpr auto kQuadraticUnion = union_of_range(Q(0.3));
constexpr auto kFloatUnion = union_of_range(0.3f);
template <int bits> constexpr Tabulated<kExterior<bits>, kExteriorUnion> exterior_union;
template <int bits> constexpr Tabulated<kLogSumExp<bits>, kLogSumExpUnion> log_sum_exp_union;
template <int bits> constexpr Tabulated<kQuadratic<bits>, kQuadraticUnion> quadratic_union;

// Pairs of distances from far apart to equal, in units of 2^-27 m.
constexpr uint32_t kPairs = 240;
int32_t distance_of(uint32_t i) { return static_cast<int32_t>(i * 2654435761u) >> 4; }
int32_t other_distance_of(uint32_t i) {
  const int32_t apart = (static_cast<int32_t>(i % 80) - 40) * 1000003;  // up to 0.3 m
  return i < 200 ? distance_of(i) + apart : distance_of(3 * i + 1);
}
Several<int32_t, 2> fixed_pair(uint32_t i) { return {{distance_of(i), other_distance_of(i)}}; }
float to_metres(int32_t raw) { return static_cast<float>(raw) * (1.0f / 134217728.0f); }
Several<float, 2> float_pair(uint32_t i) { return {{to_metres(distance_of(i)), to_metres(other_distance_of(i))}}; }

// With gradients along two axes that are not orthogonal.
template <class Word> Several<Word, 8> with_gradients(const Several<Word, 2>& pair, Word six_tenths, Word eight_tenths) {
  return {{pair.word[0], six_tenths, eight_tenths, Word{}, pair.word[1], Word{}, six_tenths, eight_tenths}};
}
Several<int32_t, 8> fixed_pair_with_gradients(uint32_t i) { return with_gradients(fixed_pair(i), Q(0.6).raw(), Q(0.8).raw()); }
Several<float, 8> float_pair_with_gradients(uint32_t i) { return with_gradients(float_pair(i), 0.6f, 0.8f); }

Q number(int32_t raw) { return Q::from_raw(raw); }
float number(float x) { return x; }
int32_t word(Q x) { return x.raw(); }
float word(float x) { return x; }

template <class S, class Word> Sample<S> sample_of(const Several<Word, 8>& words, int first) {
  return {number(words.word[first]), {number(words.word[first + 1]), number(words.word[first + 2]), number(words.word[first + 3])}};
}
template <class S, class Word> Several<Word, 4> words_of(const Sample<S>& s) {
  return {{word(s.value), word(s.gradient.x), word(s.gradient.y), word(s.gradient.z)}};
}

// A blend, callable as (a, b) of Value or Sample.
template <class S, class Word, class Blend> board::Cost cost_of(Blend blend, Several<Word, 2> (*pair)(uint32_t),
                                                                Several<Word, 8> (*pair_with_gradients)(uint32_t)) {
  return {board::worst_instruction_count(
              [blend](const Several<Word, 2>& in) {
                return word(blend(Value<S>{number(in.word[0])}, Value<S>{number(in.word[1])}).value);
              },
              pair, kPairs),
          board::worst_instruction_count(
              [blend](const Several<Word, 8>& in) {
                return words_of<S, Word>(blend(sample_of<S>(in, 0), sample_of<S>(in, 4)));
              },
              pair_with_gradients, kPairs)};
}
template <class Blend> board::Cost fixed_cost(Blend blend) { return cost_of<Q, int32_t>(blend, fixed_pair, fixed_pair_with_gradients); }
template <class Blend> board::Cost float_cost(Blend blend) { return cost_of<float, float>(blend, float_pair, float_pair_with_gradients); }

// A blend of straightforward::Distance as one of Value and Sample: Direct has template <bool> static Distance of(a, b).
template <class Direct> struct InFloat {
  Value<float> operator()(const Value<float>& a, const Value<float>& b) const {
    return {Direct::template of<false>({a.value, 0.0f, 0.0f, 0.0f}, {b.value, 0.0f, 0.0f, 0.0f}).value};
  }
  Sample<float> operator()(const Sample<float>& a, const Sample<float>& b) const {
    const straightforward::Distance d = Direct::template of<true>({a.value, a.gradient.x, a.gradient.y, a.gradient.z},
                                                                  {b.value, b.gradient.x, b.gradient.y, b.gradient.z});
    return {d.value, {d.x, d.y, d.z}};
  }
};
struct DirectExterior {
  template <bool with_gradient>
  static straightforward::Distance of(const straightforward::Distance& a, const straightforward::Distance& b) {
    return straightforward::exterior_union<with_gradient>(a, b, kDelta, kEpsilon);
  }
};
struct DirectLogSumExp {
  template <bool with_gradient>
  static straightforward::Distance of(const straightforward::Distance& a, const straightforward::Distance& b) {
    return straightforward::log_sum_exp_union<with_gradient>(a, b, kSharpness);
  }
};
struct DirectQuadratic {
  template <bool with_gradient>
  static straightforward::Distance of(const straightforward::Distance& a, const straightforward::Distance& b) {
    return straightforward::quadratic_union<with_gradient>(a, b, kLength);
  }
};

bool failed = false;

void row(const char* name, board::Cost cost) { failed = !board::write_row(name, cost) || failed; }

// Whether two blends agree within `tolerance`, metres.
template <class Blend, class Direct> void check(const char* name, Blend blend, Direct exact, float tolerance) {
  for (uint32_t i = 0; i < kPairs; ++i) {
    const Several<int32_t, 2> raw = fixed_pair(i);
    const Several<float, 2> pair = float_pair(i);
    const float found = to_metres(blend(Value<Q>{number(raw.word[0])}, Value<Q>{number(raw.word[1])}).value.raw());
    const float expected = exact(Value<float>{pair.word[0]}, Value<float>{pair.word[1]}).value;
    if (found - expected < tolerance && expected - found < tolerance) continue;
    board::write(name);
    board::write(": not near the direct formula\n");
    failed = true;
    return;
  }
}

}  // namespace

int main() {
  if (!board::prepare_instruction_counter()) return 1;
  board::write("worst instructions of a smooth union on " NEARFIELD_CORE ": value, value and gradient\n");
  row("exterior, 32 bits", fixed_cost(exterior_union<32>));
  row("exterior, 16 bits", fixed_cost(exterior_union<16>));
  row("log-sum-exp, 32 bits", fixed_cost(log_sum_exp_union<32>));
  row("log-sum-exp, 16 bits", fixed_cost(log_sum_exp_union<16>));
  row("quadratic, 32 bits", fixed_cost(quadratic_union<32>));
  row("sharp", fixed_cost([](const auto& a, const auto& b) { return SharpUnion<Q>{}.combine(a, b); }));
  row("exterior, float table", float_cost(Tabulated<kFloatExterior, kFloatUnion>{}));
  row("float: exterior, directly", float_cost(InFloat<DirectExterior>{}));
  row("float: log-sum-exp, stabilised", float_cost(InFloat<DirectLogSumExp>{}));
  row("float: quadratic", float_cost(InFloat<DirectQuadratic>{}));

  check("exterior, 32 bits", exterior_union<32>, InFloat<DirectExterior>{}, 2e-5f);
  check("exterior, 16 bits", exterior_union<16>, InFloat<DirectExterior>{}, 4e-5f);
  check("log-sum-exp, 32 bits", log_sum_exp_union<32>, InFloat<DirectLogSumExp>{}, 2e-5f);
  check("log-sum-exp, 16 bits", log_sum_exp_union<16>, InFloat<DirectLogSumExp>{}, 1e-4f);
  check("quadratic, 32 bits", quadratic_union<32>, InFloat<DirectQuadratic>{}, 2e-6f);
  return failed ? 1 : 0;
}
