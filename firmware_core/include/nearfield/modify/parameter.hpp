// Fields that change while they run: operations that take a parameter x in [0, 1] with each query, by the number of its
// slot (KW: animation, soft to hard, metamorphosis).
#pragma once

#include <nearfield/modify/offset.hpp>

namespace nearfield {

namespace detail {

// Whether an intensity is known not to saturate: the greatest number stands for anything above.
template <class S> constexpr bool never_saturates(const Certificate<S>& intensity) {
  return intensity.magnitude > S{} && intensity.magnitude < ScalarTraits<S>::greatest();
}

}  // namespace detail

// (1 - x) a + x b: exactly a at 0, exactly b at 1, in between half a unit of rounding. Between a soft and a sharp blend of
// the same operands it changes softness, between two potentials too. A clearance is that to the surface as it is at x; to
// the sharp solids as well only where a and b are blends of the same ones: erosion and inflation are the greater of both.
// Intensities must be known not to saturate.
template <class S, Kind of> struct MorphOf {
  static_assert(of != Kind::algebraic, "algebraic fields have no morph");
  using Scalar = S;
  static constexpr Kind kind = of;
  static constexpr int fixed_operand_count = 2;
  static constexpr bool takes_parameter = true;
  static constexpr bool has_highest = of == Kind::intensity;
  uint32_t slot = 0;

  template <class Out> constexpr Out combine(const Out& a, const Out& b, S x) const {
    const S rest = subtract_in_range(ScalarTraits<S>::one(), x);
    const auto mixed = [&](S from, S to) { return narrow_in_range<S>(product(from, rest) + product(to, x)); };
    Out out;
    out.value = mixed(a.value, b.value);
    if constexpr (Out::has_gradient) {
      out.gradient = {mixed(a.gradient.x, b.gradient.x), mixed(a.gradient.y, b.gradient.y),
                      mixed(a.gradient.z, b.gradient.z)};
    }
    return out;
  }
  constexpr Highest<S> highest(const Highest<S>& a, const Highest<S>& b, const Ball<S>&, S x) const {
    return combine(a, b, x);
  }
  constexpr Certificate<S> certificate(OperandCertificates<S> operands, const TableFacts&, Reach<S> reach) const {
    Certificate<S> between = worst_of(operands[0], operands[1]);
    if (of == Kind::intensity) between.valid = between.valid && detail::never_saturates(operands[0]) && detail::never_saturates(operands[1]);
    between.magnitude = operands[0].magnitude > S{} && operands[1].magnitude > S{}
                            ? greatest_of_two(operands[0].magnitude, operands[1].magnitude) : S{};
    // Fixed: half a unit for the product; float: two products and a sum of numbers up to the greatest one.
    const S size = between.magnitude > S{} ? between.magnitude : reach.radius;
    using T = ScalarTraits<S>;
    between.error = between.error + T::times(T::rounding_unit(size), T::is_fixed ? 1 : 3);
    return between;
  }
};

template <class S> using Morph = MorphOf<S, Kind::distance>;
template <class S> using IntensityMorph = MorphOf<S, Kind::intensity>;
template <class S> using RayMorph = MorphOf<S, Kind::ray>;

// a - x radius: grown by up to `radius` metres, within the domain; a negative one shrinks. Half a unit of rounding. Exact
// outside where a is; a shrunk solid's distance is a lower bound near its edges.
template <class S> struct Swell {
  using Scalar = S;
  static constexpr Kind kind = Kind::distance;
  static constexpr int fixed_operand_count = 1;
  static constexpr bool takes_parameter = true;
  S radius{};
  uint32_t slot = 0;

  template <class Out> constexpr Out combine(const Out& a, S x) const {
    Out out = a;
    out.value = subtract_in_range(a.value, narrow_in_range<S>(product(radius, x)));
    return out;
  }
  constexpr Certificate<S> certificate(OperandCertificates<S> operands, const TableFacts&, Reach<S>) const {
    // The radius's own rounding, the product's; float: the sum's as well.
    return detail::offset_certificate(operands[0], radius, ScalarTraits<S>::is_fixed ? 1 : 3);
  }
};

// x F: an intensity, known not to saturate, that comes and goes. Half a unit of rounding.
template <class S> struct Fade {
  using Scalar = S;
  static constexpr Kind kind = Kind::intensity;
  static constexpr int fixed_operand_count = 1;
  static constexpr bool takes_parameter = true;
  static constexpr bool has_highest = true;
  uint32_t slot = 0;

  template <class Out> constexpr Out combine(const Out& a, S x) const {
    const auto faded = [x](S number) { return narrow_in_range<S>(product(number, x)); };
    Out out;
    out.value = faded(a.value);
    if constexpr (Out::has_gradient) out.gradient = {faded(a.gradient.x), faded(a.gradient.y), faded(a.gradient.z)};
    return out;
  }
  constexpr Highest<S> highest(const Highest<S>& a, const Ball<S>&, S x) const { return combine(a, x); }
  constexpr Certificate<S> certificate(OperandCertificates<S> operands, const TableFacts&, Reach<S>) const {
    using T = ScalarTraits<S>;
    Certificate<S> faded = operands[0];
    faded.valid = operands[0].valid && detail::never_saturates(operands[0]);
    faded.error = operands[0].error + T::rounding_unit(operands[0].magnitude + T::one());
    return faded;
  }
};

}  // namespace nearfield
