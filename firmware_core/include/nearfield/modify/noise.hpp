// Random deformations by solid noise (KW): F (1 + c N(p)) of intensities, d - c N(p) of distances.
#pragma once

#include <nearfield/number/lattice_noise.hpp>
#include <nearfield/shape/algebraic.hpp>
#include <nearfield/shape/operands.hpp>

namespace nearfield {

namespace detail {

// Factors of noise's slopes, Q27, within +-16, and the slopes, Q24, whatever the scalar's format, so that small ones keep their
// bits; or float.
template <class S> struct NoiseNumbers {
  using Factor = Fixed<27>;
  using Slope = Rate;
};
template <> struct NoiseNumbers<float> {
  using Factor = float;
  using Slope = float;
};

}  // namespace detail

// c N(p), N the noise of lattice_noise.hpp over its greatest value, so that |N| <= 1: of one to four octaves. `frequency`: cells
// of the lattice per metre in the first octave, from 2^-10 to 1024; what is stored is no rounded number. |c| <= domain.
template <class S, Kind of> struct SolidNoise {
  static_assert(of == Kind::distance || of == Kind::intensity, "noise is of distances and intensities");
  using Factor = typename detail::NoiseNumbers<S>::Factor;
  S gain{};            // c / (2 - 2^(1 - octaves))
  Factor steepness{};  // gain frequency, of intensities per 1/16 m (sample.hpp)
  Fixed<16> frequency;
  uint32_t octaves = 1;
  uint32_t seed = 0;

  constexpr SolidNoise() = default;
  constexpr SolidNoise(S amplitude, Fixed<16> cells_per_metre, uint32_t octave_count, uint32_t noise_seed)
      : gain(gain_of(amplitude, octave_count)), steepness(steepness_of(gain, cells_per_metre)), frequency(cells_per_metre),
        octaves(octave_count), seed(noise_seed) {}

  template <bool with_slope> constexpr LatticeNoise at(const Vector3<S>& p) const {
    return lattice_noise<with_slope>({coordinate(p.x), coordinate(p.y), coordinate(p.z)}, seed, octaves);
  }
  // c N.
  constexpr S value(const LatticeNoise& noise) const { return narrow_in_range<S>(product(gain, number(noise.value))); }
  // Its slope; saturates.
  template <class To> constexpr Vector3<To> slope(const LatticeNoise& noise) const {
    return {narrow<To>(product(steepness, number(noise.slope.x))), narrow<To>(product(steepness, number(noise.slope.y))),
            narrow<To>(product(steepness, number(noise.slope.z)))};
  }

  constexpr bool valid() const {
    const S limit = ScalarTraits<S>::domain();
    return octaves >= 1 && octaves <= kGreatestOctaveCount && frequency >= Fixed<16>::from_raw(1 << 6) &&
           frequency <= Fixed<16>::from_raw(1 << 26) && within(gain, -limit, limit) &&
           steepness == steepness_of(gain, frequency) && absolute(steepness) < ScalarTraits<Factor>::greatest();
  }
  // |c| before it was rounded, rounded up: 1.5 units for the gain's rounding and its own.
  constexpr S amplitude() const {
    S last = absolute(gain);
    for (uint32_t i = 1; i < octaves && i < kGreatestOctaveCount; ++i) last = ScalarTraits<S>::half(last);
    return absolute(gain) + (absolute(gain) - last) + ScalarTraits<S>::times(unit(), 2);
  }
  // Of c N, per metre: |gain| frequency 15/4 octaves.
  constexpr Rate rate() const {
    if (!valid()) return kNoRateBound;
    const int64_t slopes = 15 * static_cast<int64_t>(octaves);  // times 4
    if constexpr (ScalarTraits<S>::is_fixed) {
      constexpr int drop = S::fraction_bits + 16 + 2 - Rate::fraction_bits;
      const int64_t exact = (int64_t{absolute(gain).raw()} + 1) * frequency.raw() * slopes;
      ArithmeticStatus ignored;
      return Rate::saturate((exact >> drop) + 1, ignored);
    } else {
      return detail::rate_up_from((absolute(gain) + unit()) * cells_per_metre() * (static_cast<float>(slopes) * 0.250001f));
    }
  }
  // Of value(). Rounding units of |c|: the gain 1.5, the product 1/2; float: the place as well.
  constexpr S error(Reach<S> reach) const {
    using T = ScalarTraits<S>;
    const S of_noise = T::multiply_up(absolute(gain) + unit(), Rate::from_raw(kNoiseErrorQ29 >> (29 - Rate::fraction_bits)));
    const S of_place = T::is_fixed ? S{} : T::multiply_up(T::rounding_unit(reach.radius), rate());
    return of_noise + T::times(unit(), 2) + of_place;
  }

 private:
  constexpr S unit() const { return ScalarTraits<S>::rounding_unit(absolute(gain)); }
  static constexpr S gain_of(S amplitude, uint32_t octaves) {
    // 1, 2/3, 4/7, 8/15.
    constexpr int shares[] = {1, 1, 2, 4, 8}, of_shares[] = {1, 1, 3, 7, 15};
    const uint32_t last = octaves < kGreatestOctaveCount ? octaves : kGreatestOctaveCount;
    if constexpr (ScalarTraits<S>::is_fixed) {
      ArithmeticStatus ignored;
      const int64_t twice = int64_t{2} * amplitude.raw() * shares[last] + of_shares[last], divisor = int64_t{2} * of_shares[last];
      return S::saturate(twice / divisor - (twice % divisor < 0 ? 1 : 0), ignored);
    } else {
      return amplitude * (static_cast<float>(shares[last]) / static_cast<float>(of_shares[last]));
    }
  }
  static constexpr Factor steepness_of(S gain, Fixed<16> frequency) {
    if constexpr (ScalarTraits<S>::is_fixed) {
      constexpr int per_length = of == Kind::intensity ? -kGradientLengthLog2 : 0;
      const int64_t exact = int64_t{gain.raw()} * frequency.raw();
      return narrow<Factor>(WideProduct<S::fraction_bits + 16 + per_length, int32_t>{exact});
    } else {
      return gain * (static_cast<float>(frequency.raw()) * (of == Kind::intensity ? 1.0f / 1048576.0f : 1.0f / 65536.0f));
    }
  }
  constexpr float cells_per_metre() const { return static_cast<float>(frequency.raw()) * (1.0f / 65536.0f); }
  // In cells, Q32, rounded down (float: towards 0).
  constexpr int64_t coordinate(S x) const {
    if constexpr (ScalarTraits<S>::is_fixed) {
      static_assert(S::fraction_bits >= 16, "places of the lattice have 32 fraction bits");
      return (int64_t{x.raw()} * frequency.raw()) >> (S::fraction_bits - 16);
    } else {
      const float cells = x * cells_per_metre();
      if (!(cells > -1.0e9f && cells < 1.0e9f)) return 0;
      return static_cast<int64_t>(cells * 4294967296.0f);
    }
  }
  template <int F> static constexpr auto number(Fixed<F> noise) {
    if constexpr (ScalarTraits<S>::is_fixed) return noise;
    else return static_cast<float>(noise.raw()) * (1.0f / static_cast<float>(1 << F));
  }
};

// d - c N(p): the surface moves outwards by c N metres. The gradient is no unit vector; it saturates.
template <class S> struct NoiseDistance {
  using Scalar = S;
  static constexpr Kind kind = Kind::distance;
  static constexpr int fixed_operand_count = 1;
  static constexpr bool takes_point = true;
  SolidNoise<S, Kind::distance> noise;

  constexpr int item_count() const { return static_cast<int>(noise.octaves); }

  template <class Out> constexpr Out combine(const Vector3<S>& p, const Out& a) const {
    const LatticeNoise n = noise.template at<Out::has_gradient>(p);
    Out out;
    out.value = subtract_in_range(a.value, noise.value(n));
    if constexpr (Out::has_gradient) {
      const Vector3<S> slope = noise.template slope<S>(n);
      out.gradient = {a.gradient.x - slope.x, a.gradient.y - slope.y, a.gradient.z - slope.z};
    }
    return out;
  }
  constexpr Certificate<S> certificate(OperandCertificates<S> of, const TableFacts&, Reach<S> reach) const {
    using T = ScalarTraits<S>;
    Certificate<S> moved = of[0];
    const S amplitude = noise.amplitude();
    moved.lipschitz = of[0].lipschitz + noise.rate();
    moved.erosion = of[0].erosion + amplitude;
    moved.inflation = of[0].inflation + amplitude;
    const S greatest = moved.magnitude + moved.erosion + moved.inflation;
    moved.error = of[0].error + noise.error(reach) + (T::is_fixed ? S{} : T::rounding_unit(greatest));
    moved.valid = of[0].valid && noise.valid() && of[0].magnitude > S{} && greatest + moved.error < T::greatest() &&
                  moved.lipschitz < kNoRateBound;
    return moved;
  }
};

// F (1 + c N(p)). |c| above 1 only of intensities that are nowhere negative. Saturates.
template <class S> struct NoiseIntensity {
  using Scalar = S;
  static constexpr Kind kind = Kind::intensity;
  static constexpr int fixed_operand_count = 1;
  static constexpr bool takes_point = true;
  static constexpr bool has_highest = true;
  SolidNoise<S, Kind::intensity> noise;

  constexpr int item_count() const { return static_cast<int>(noise.octaves); }

  template <class Out> constexpr Out combine(const Vector3<S>& p, const Out& a) const {
    const LatticeNoise n = noise.template at<Out::has_gradient>(p);
    const S added = noise.value(n);
    Out out;
    out.value = a.value + narrow<S>(product(a.value, added));
    if constexpr (Out::has_gradient) {
      const auto slope = noise.template slope<typename detail::NoiseNumbers<S>::Slope>(n);
      out.gradient = a.gradient + scaled(a.gradient, added) +
                     Vector3<S>{narrow<S>(product(a.value, slope.x)), narrow<S>(product(a.value, slope.y)),
                                narrow<S>(product(a.value, slope.z))};
    }
    return out;
  }
  constexpr Highest<S> highest(const Highest<S>& a, const Ball<S>&) const {
    if (!(a.value > S{})) return {};
    return {a.value + narrow<S>(product(a.value, noise.amplitude())) + ScalarTraits<S>::rounding_unit(a.value)};
  }
  constexpr Certificate<S> certificate(OperandCertificates<S> of, const TableFacts&, Reach<S> reach) const {
    using T = ScalarTraits<S>;
    using namespace detail;
    const Certificate<S>& a = of[0];
    const S amplitude = noise.amplitude(), most = T::one() + amplitude;
    const Rate rate = noise.rate();
    Certificate<S> deformed = a;
    deformed.lipschitz = kNoRateBound;
    if (rate != kNoRateBound) {
      const Rate per_length = Rate::from_raw((rate.raw() >> -kGradientLengthLog2) + 1);
      deformed.lipschitz = rate_product_up(a.lipschitz, most) + rate_product_up(per_length, a.magnitude);
    }
    const S greatest = product_up(a.magnitude, most);
    const S of_noise = sum_up(product_up(noise.error(reach), a.magnitude), roundings(greatest, 2));
    deformed.error = sum_up(product_up(a.error, most), of_noise);
    deformed.magnitude = sum_up(greatest, deformed.error);
    const bool may_turn = amplitude > T::one() + T::times(T::rounding_unit(T::one()), 4);
    deformed.below_zero = a.below_zero > S{} || may_turn ? deformed.magnitude : S{};
    deformed.valid = a.valid && noise.valid() && a.magnitude > S{} && deformed.magnitude < T::greatest() &&
                     (!may_turn || a.below_zero == S{});
    return deformed;
  }
};

}  // namespace nearfield
