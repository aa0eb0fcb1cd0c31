#pragma once

#include <nearfield/shape/bicubic_cell.hpp>
#include <nearfield/shape/bicubic_place.hpp>
#include <nearfield/shape/certificate.hpp>
#include <nearfield/shape/cubic_chords.hpp>
#include <nearfield/shape/payload.hpp>
#include <nearfield/shape/sample.hpp>

namespace nearfield {

inline constexpr int kPatchNewtonSteps = 2;

// All points within `radius` of a bicubic Bezier patch. Metres: 16 control points within the domain, those of
// u = 0 first, in the order of v; coordinates of neighbours at most half the domain apart, in either
// direction; radius in [0, domain]. Points, curves and folded patches are allowed. The distance from a point
// of the patch, less the radius: never below the true one but for rounding, and above it by no more than
// twice the greatest distance of a sixteenth of the patch from its parallelogram (bicubic_cell.hpp), about
// (|Puu| + |Pvv|) / 192 + |Puv| / 64. Searched from the nearest of 16 parallelograms by 2 Newton steps in two
// variables, of which the nearest place counts: exact wherever no other place of the patch is as near within
// that bound. The direction is that from this place; none on the patch.
template <class S>
struct BicubicPatch {
  using Scalar = S;
  static constexpr Kind kind = Kind::distance;
  static constexpr int control_count = 16, cell_count = 16;
  using Cell = detail::BicubicCell<S>;
  S radius{};
  uint32_t swapped = 0;              // bit i: v runs along cell i, and u across
  S control[3][control_count] = {};  // x, y and z of all
  Cell cell[cell_count] = {};

  constexpr BicubicPatch() = default;
  // Invalid, and without cells, where control points do not fit.
  constexpr BicubicPatch(const Vector3<S>* points, S rounding_radius) : radius(rounding_radius) {
    for (int i = 0; i < control_count; ++i) {
      control[0][i] = points[i].x;
      control[1][i] = points[i].y;
      control[2][i] = points[i].z;
    }
    if (!control_points_fit()) return;
    for (int i = 0; i < cell_count; ++i) {
      const detail::BakedBicubicCell<S> baked(control, i / 4, i % 4);
      cell[i] = baked.cell();
      if (baked.swapped()) swapped |= 1u << i;
    }
  }

  // What evaluation reads, where it is.
  struct InImage {
    const uint32_t* payload;
    S radius() const { return detail::words_as<S>(payload + offsetof(BicubicPatch, radius) / 4); }
    bool swapped(uint32_t i) const { return (payload[offsetof(BicubicPatch, swapped) / 4] >> i & 1u) != 0; }
    Cell cell(uint32_t i) const {
      return Cell::read(payload + offsetof(BicubicPatch, cell) / 4 + i * (sizeof(Cell) / 4));
    }
    S operator()(uint32_t axis, uint32_t i) const {
      return detail::words_as<S>(payload + offsetof(BicubicPatch, control) / 4 + control_count * axis + i);
    }
  };
  struct InMemory {
    const BicubicPatch& patch;
    constexpr S radius() const { return patch.radius; }
    constexpr bool swapped(uint32_t i) const { return (patch.swapped >> i & 1u) != 0; }
    constexpr const Cell& cell(uint32_t i) const { return patch.cell[i]; }
    constexpr S operator()(uint32_t axis, uint32_t i) const { return patch.control[axis][i]; }
  };

  template <class Out, class Source>
  static constexpr Out evaluate_from(const Source& source, const Vector3<S>& p) {
    return from_offset<Out>(offset_from(source, p), source.radius());
  }
  template <class Out>
  constexpr Out evaluate(const Vector3<S>& p) const {
    return evaluate_from<Out>(InMemory{*this}, p);
  }

  // With D the greatest deviation of a cell, c the one whose parallelogram seems nearest, Q its point that
  // does, at the parameters s of P, and * the truth: |p - P| <= |p - Q| + D <= |p - Q*| + D <= |p - P*| + 2
  // D, Q* being of the same parameters as P*. Rounding units: |p - Q| at these parameters 12 and its being
  // the least 12 + 4 (1 + slant), what the deviations are off 2 * 20, control points sqrt(3)/2, places on the
  // patch 11, the choice among them 4, radius 1/2, root 1.
  constexpr Certificate<S> certificate(Reach<S> reach) const {
    using T = ScalarTraits<S>;
    if (!(within(radius, S{}, T::domain()) && control_points_fit())) return {};
    S extent{}, deviation{}, longest{};
    int slant = 0;
    for (int i = 0; i < control_count; ++i)
      extent = greatest_of_two(extent, detail::distance_from_origin(control_point(i)));
    for (int i = 0; i < cell_count; ++i) {
      const detail::BakedBicubicCell<S> baked(control, i / 4, i % 4);
      if (!(cell[i] == baked.cell()) || baked.swapped() != ((swapped >> i & 1u) != 0)) return {};
      deviation = greatest_of_two(deviation, baked.deviation());
      longest = greatest_of_two(longest, cell[i].length);
      slant = greatest_of_two(slant, cell[i].slant.greatest_magnitude());
    }
    if (swapped >> cell_count != 0) return {};
    // Parallelograms are as far from the origin, which is more than their rounding.
    const S edges = T::times(longest, 3);
    Certificate<S> all = exact_distance<S>(reach, extent + deviation + edges + radius, true, 86 + 4 * slant);
    all.error = all.error + deviation + deviation;
    return all;
  }

 private:
  // One function for values and gradients.
  template <class Source>
  [[gnu::noinline]] static constexpr Vector3<S> offset_from(const Source& source, const Vector3<S>& p) {
    uint32_t nearest = 0;
    auto least = detail::ChordWalk<S>::kGreatestSquare;
    S on_along{}, on_across{};
    for (uint32_t i = 0; i < cell_count; ++i) {
      const auto foot = source.cell(i).foot(p);
      if (foot.squares < least) {
        least = foot.squares;
        nearest = i;
        on_along = foot.along;
        on_across = foot.across;
      }
    }
    const S length = source.cell(nearest).length, height = source.cell(nearest).height;
    const Unit<S> along = detail::share_of(on_along, length), across = detail::share_of(on_across, height);
    const bool swapped = source.swapped(nearest);
    detail::BicubicParameters<S> at{in_quarter(nearest >> 2, swapped ? across : along),
                                    in_quarter(nearest & 3, swapped ? along : across)};
    detail::NearestTried<S> tried(p);
    for (int i = 0; i < kPatchNewtonSteps; ++i) {
      const detail::BicubicPlace<S> place(source, p, at);
      tried.add(place.offset);
      at = detail::BicubicStep<Unit<S>>(detail::paraboloid_at(place)).from(at);
    }
    tried.add(detail::bicubic_offset(source, p, at));
    return detail::settled(tried.offset());
  }
  // (quarter + share) / 4.
  static constexpr Unit<S> in_quarter(uint32_t quarter, Unit<S> share) {
    if constexpr (ScalarTraits<S>::is_fixed)
      return Unit<S>::from_raw(static_cast<int32_t>(quarter << 28) + (share.raw() >> 2));
    else
      return (static_cast<float>(quarter) + share) * 0.25f;
  }

  constexpr Vector3<S> control_point(int i) const { return {control[0][i], control[1][i], control[2][i]}; }
  constexpr bool control_points_fit() const {
    for (int i = 0; i < control_count; ++i) {
      if (!coordinates_in_domain(control_point(i))) return false;
      if (i % 4 != 0 && !are_near(i - 1, i)) return false;
      if (i >= 4 && !are_near(i - 4, i)) return false;
    }
    return true;
  }
  constexpr bool are_near(int i, int j) const {
    for (const auto& coordinate : control) {
      if (absolute(coordinate[j] - coordinate[i]) > ScalarTraits<S>::half(ScalarTraits<S>::domain()))
        return false;
    }
    return true;
  }
};

}  // namespace nearfield
