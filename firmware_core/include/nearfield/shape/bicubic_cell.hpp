// Parts of a bicubic surface as parallelograms in space: where the search for its nearest point starts.
#pragma once

#include <nearfield/number/direction.hpp>
#include <nearfield/number/ratio.hpp>
#include <nearfield/shape/payload.hpp>
#include <nearfield/shape/skeleton_offset.hpp>

namespace nearfield::detail {

// How far a parallelogram may lean: thinner ones are made that wide.
inline constexpr int kGreatestSlant = 256;

// A slant and what follows from it. For payloads: `of` divides.
template <class S>
struct Slant;
template <int F>
struct Slant<Fixed<F>> {
  Fixed<22> tangent;
  Fixed<30> steep;  // 1 / (1 + tangent^2)
  Fixed<30> lean;   // tangent / (1 + tangent^2)

  constexpr int greatest_magnitude() const { return (absolute(tangent).raw() >> 22) + 1; }
  // Of `across` metres that lead `along` metres sideways; |along| <= kGreatestSlant across.
  static constexpr Slant of(Fixed<F> along, Fixed<F> across) {
    Slant slant;
    if (across.raw() > 0) {
      const int64_t share = int64_t{along.raw()} * (1 << 22) / across.raw();
      const int64_t limit = int64_t{kGreatestSlant} << 22;
      slant.tangent = Fixed<22>::from_raw(static_cast<int32_t>(clamp(share, -limit, limit)));
    }
    const int64_t tangent = slant.tangent.raw();
    const uint64_t sum = (uint64_t{1} << 44) + static_cast<uint64_t>(tangent * tangent);
    const int shift = leading_zeros(sum);  // 3 to 19
    const uint64_t inverse = (uint64_t{1} << 63) / (sum << shift >> 32);
    slant.steep = Fixed<30>::from_raw(static_cast<int32_t>(inverse >> (21 - shift)));
    slant.lean =
        Fixed<30>::from_raw(static_cast<int32_t>(tangent * static_cast<int64_t>(inverse) >> (43 - shift)));
    return slant;
  }
};
template <>
struct Slant<float> {
  float tangent = 0.0f, steep = 0.0f, lean = 0.0f;

  constexpr int greatest_magnitude() const { return static_cast<int>(absolute(tangent)) + 1; }
  static constexpr Slant of(float along, float across) {
    Slant slant;
    constexpr float limit = static_cast<float>(kGreatestSlant);
    if (across > 0.0f) slant.tangent = clamp(along / across, -limit, limit);
    slant.steep = 1.0f / (1.0f + slant.tangent * slant.tangent);
    slant.lean = slant.tangent * slant.steep;
    return slant;
  }
};

// numerator / denominator of lengths, in [0, 1]; 0 for a denominator of 0. Error: 2^-29 (float: 2^-23).
template <int F>
constexpr Fixed<30> share_of(Fixed<F> numerator, Fixed<F> denominator) {
  if (numerator >= denominator && denominator.raw() > 0) return Fixed<30>::from_raw(1 << 30);
  const uint32_t share =
      ratio(static_cast<uint32_t>(numerator.raw()), static_cast<uint32_t>(denominator.raw()));
  return Fixed<30>::from_raw(static_cast<int32_t>(share >> 1));
}
constexpr float share_of(float numerator, float denominator) {
  return numerator >= denominator && denominator > 0.0f ? 1.0f : ratio(numerator, denominator);
}

// What counts as nothing beside coordinates of metres: 64 units in the last place.
template <class S>
constexpr S small_length() {
  if constexpr (ScalarTraits<S>::is_fixed)
    return S::from_raw(64);
  else
    return 1e-9f;
}

// A product as a number, cut off: a rounding unit below it at most.
template <class To, int F>
constexpr To rounded_down(WideProduct<F, int32_t> wide) {
  return To::from_raw(shift_right_to_32<F - To::fraction_bits>(wide.raw));
}
template <class To>
constexpr float rounded_down(float wide) {
  return wide;
}

template <class S>
constexpr Vector3<S> along_axis(const Vector3<Unit<S>>& axis, S length) {
  return {narrow_in_range<S>(product(length, axis.x)), narrow_in_range<S>(product(length, axis.y)),
          narrow_in_range<S>(product(length, axis.z))};
}
template <class S>
constexpr S distance_from_origin(const Vector3<S>& v) {
  return length_of<S>(sum_of_squares(v.x, v.y, v.z));
}

// corner + x along + y across for y in [0, height] and x - y slant in [0, length]. The axes are perpendicular
// to each other and to the normal, within 2^-28 (float: 2^-21).
template <class S>
struct BicubicCell {
  Vector3<S> corner;
  Vector3<Unit<S>> along, across, normal;
  S length{}, height{};
  Slant<S> slant;

  static BicubicCell read(const uint32_t* words) {
    BicubicCell cell;
    cell.corner = vector_as<S>(words);
    cell.along = vector_as<Unit<S>>(words + 3);
    cell.across = vector_as<Unit<S>>(words + 6);
    cell.normal = vector_as<Unit<S>>(words + 9);
    cell.length = words_as<S>(words + 12);
    cell.height = words_as<S>(words + 13);
    cell.slant.tangent = words_as<decltype(Slant<S>::tangent)>(words + 14);
    cell.slant.steep = words_as<Unit<S>>(words + 15);
    cell.slant.lean = words_as<Unit<S>>(words + 16);
    return cell;
  }

  // Where the nearest point to p is, and how far it is from p, squared. Off by 12 rounding units, and by 4 (1
  // + |slant|) where it lies on an edge.
  struct Foot {
    decltype(sum_of_squares(S{}, S{})) squares;
    S along, across;  // from the corner; the former less what the slant adds
  };
  [[gnu::always_inline]] constexpr Foot foot(const Vector3<S>& p) const {
    const Vector3<S> q = subtract_in_range(p, corner);
    const S x = rounded_down<S>(dot(q, along)), y = rounded_down<S>(dot(q, across)),
            z = rounded_down<S>(dot(q, normal));
    S up = place_on_segment(y, height), sideways = rounded_down<S>(product(up, slant.tangent));
    const S place = subtract_in_range(x, sideways), on = place_on_segment(place, length);
    if (on != place) {
      // On that edge.
      const S rest = subtract_in_range(x, on);
      up = place_on_segment(rounded_down<S>(product(rest, slant.lean) + product(y, slant.steep)), height);
      sideways = rounded_down<S>(product(up, slant.tangent));
    }
    return {
        sum_of_squares(subtract_in_range(subtract_in_range(x, on), sideways), subtract_in_range(y, up), z),
        on, up};
  }

  friend constexpr bool operator==(const BicubicCell& a, const BicubicCell& b) {
    return a.corner == b.corner && a.along == b.along && a.across == b.across && a.normal == b.normal &&
           a.length == b.length && a.height == b.height && a.slant.tangent == b.slant.tangent &&
           a.slant.steep == b.slant.steep && a.slant.lean == b.slant.lean;
  }
};

// A part of a bicubic Bezier surface, coordinates control[axis][4 i + j], for u and v between these quarters
// of [0, 1]: its parallelogram, and the greatest distance between the two at the same parameters, which run
// along the sides. For payloads: about 3000 operations. Precondition: coordinates within the domain, those of
// neighbours at most half of it apart.
template <class S>
class BakedBicubicCell {
 public:
  constexpr BakedBicubicCell(const S (&control)[3][16], int quarter_u, int quarter_v) {
    Vector3<S> part[16] = {};
    for (int i = 0; i < 16; ++i) part[i] = {control[0][i], control[1][i], control[2][i]};
    for (int i = 0; i < 4; ++i) restrict_to_quarter(part + 4 * i, 1, quarter_v);
    for (int j = 0; j < 4; ++j) restrict_to_quarter(part + j, 4, quarter_u);
    const Vector3<S> side_u =
        mean(subtract_in_range(part[12], part[0]), subtract_in_range(part[15], part[3]));
    const Vector3<S> side_v =
        mean(subtract_in_range(part[3], part[0]), subtract_in_range(part[15], part[12]));
    swapped_ = distance_from_origin(side_u) < distance_from_origin(side_v);
    set_frame(swapped_ ? side_v : side_u, swapped_ ? side_u : side_v);
    place_between(part);
  }

  constexpr const BicubicCell<S>& cell() const { return cell_; }
  // Whether v runs along, and u across.
  constexpr bool swapped() const { return swapped_; }
  // By the control points of the difference, which is bicubic as well. Rounding: within 20 units.
  constexpr S deviation() const { return deviation_; }

 private:
  using T = ScalarTraits<S>;

  static constexpr Vector3<S> mean(const Vector3<S>& a, const Vector3<S>& b) {
    return {T::half(a.x + b.x), T::half(a.y + b.y), T::half(a.z + b.z)};
  }
  // Four control points, `apart` from each other, of a cubic: of a quarter of it.
  static constexpr void restrict_to_quarter(Vector3<S>* point, int apart, int quarter) {
    restrict_to_half(point, apart, quarter >= 2);
    restrict_to_half(point, apart, quarter % 2 == 1);
  }
  static constexpr void restrict_to_half(Vector3<S>* point, int apart, bool later) {
    Vector3<S>&a = point[0], &b = point[apart], &c = point[2 * apart], &d = point[3 * apart];
    const Vector3<S> ab = mean(a, b), bc = mean(b, c), cd = mean(c, d);
    const Vector3<S> abc = mean(ab, bc), bcd = mean(bc, cd);
    (later ? a : d) = mean(abc, bcd);
    b = later ? bcd : ab;
    c = later ? cd : abc;
  }

  static constexpr Vector3<Unit<S>> unit_axis(int i) {
    const Unit<S> one = T::unit_one();
    return {i == 0 ? one : Unit<S>{}, i == 1 ? one : Unit<S>{}, i == 2 ? one : Unit<S>{}};
  }
  // The axis farthest from a direction.
  static constexpr Vector3<Unit<S>> axis_aside(const Vector3<Unit<S>>& v) {
    const Unit<S> x = absolute(v.x), y = absolute(v.y), z = absolute(v.z);
    return unit_axis(x <= y && x <= z ? 0 : y <= z ? 1 : 2);
  }
  template <class V>
  static constexpr V less_part_along(const V& v, const Vector3<Unit<S>>& axis) {
    using Number = decltype(v.x);
    const auto part = narrow_in_range<Number>(dot(v, axis));
    return {subtract_in_range(v.x, narrow_in_range<Number>(product(part, axis.x))),
            subtract_in_range(v.y, narrow_in_range<Number>(product(part, axis.y))),
            subtract_in_range(v.z, narrow_in_range<Number>(product(part, axis.z)))};
  }

  // Sides that are nothing, or in line with the other one, get any direction that is perpendicular.
  constexpr void set_frame(const Vector3<S>& longer, const Vector3<S>& shorter) {
    const S longer_length = distance_from_origin(longer);
    const bool is_point = longer_length <= (T::is_fixed ? S{} : small_length<S>());
    cell_.along = is_point ? unit_axis(0) : baked_direction(longer);
    cell_.length = is_point ? S{} : longer_length;
    const Vector3<S> aside = less_part_along(shorter, cell_.along);
    S least = distance_from_origin(shorter);
    for (int i = 0; i < 10; ++i) least = T::half(least);
    const bool in_line = distance_from_origin(aside) <= least + small_length<S>();
    // Again, as the first time left what was rounded.
    cell_.across = baked_direction(
        less_part_along(in_line ? axis_aside(cell_.along) : baked_direction(aside), cell_.along));
    cell_.across = baked_direction(less_part_along(cell_.across, cell_.along));
    const Vector3<Unit<S>>&a = cell_.along, &b = cell_.across;
    const auto turned = [](Unit<S> p, Unit<S> q, Unit<S> r, Unit<S> s) {
      return narrow_in_range<Unit<S>>(product(p, q) - product(r, s));
    };
    cell_.normal = {turned(a.y, b.z, a.z, b.y), turned(a.z, b.x, a.x, b.z), turned(a.x, b.y, a.y, b.x)};
    const S sideways = narrow_in_range<S>(dot(shorter, cell_.along));
    S least_height = absolute(sideways);
    for (int i = 1; i < kGreatestSlant; i *= 2) least_height = T::half(least_height);
    cell_.height =
        greatest_of_two(greatest_of_two(narrow_in_range<S>(dot(shorter, cell_.across)), S{}), least_height);
    cell_.slant = Slant<S>::of(sideways, cell_.height);
  }

  // Moves the corner to where the surface is as far to one side as to the other.
  constexpr void place_between(const Vector3<S>* part) {
    const Vector3<S> first = along_axis(cell_.along, cell_.length);
    const S sideways = narrow_in_range<S>(product(cell_.height, cell_.slant.tangent));
    const Vector3<S> second = along_axis(cell_.along, sideways) + along_axis(cell_.across, cell_.height);
    Vector3<S> away[16] = {};
    for (int i = 0; i < 4; ++i) {
      for (int j = 0; j < 4; ++j) {
        away[4 * i + j] = subtract_in_range(
            part[4 * i + j], thirds(first, swapped_ ? j : i) + thirds(second, swapped_ ? i : j));
      }
    }
    Vector3<S> low = away[0], high = away[0];
    for (const Vector3<S>& v : away) {
      low = {least_of_two(low.x, v.x), least_of_two(low.y, v.y), least_of_two(low.z, v.z)};
      high = {greatest_of_two(high.x, v.x), greatest_of_two(high.y, v.y), greatest_of_two(high.z, v.z)};
    }
    cell_.corner = mean(low, high);
    for (const Vector3<S>& v : away)
      deviation_ = greatest_of_two(deviation_, distance_from_origin(subtract_in_range(v, cell_.corner)));
  }
  // count / 3 of it.
  static constexpr Vector3<S> thirds(const Vector3<S>& v, int count) {
    if (count == 0) return {};
    if (count == 3) return v;
    if constexpr (T::is_fixed)
      return scaled_in_range(v, Unit<S>::from_raw(count == 1 ? 0x15555555 : 0x2aaaaaab));
    else
      return scaled_in_range(v, count == 1 ? 1.0f / 3.0f : 2.0f / 3.0f);
  }

  BicubicCell<S> cell_;
  bool swapped_ = false;
  S deviation_{};
};

}  // namespace nearfield::detail
