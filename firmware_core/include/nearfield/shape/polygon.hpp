#pragma once

#include <nearfield/number/direction.hpp>
#include <nearfield/shape/certificate.hpp>
#include <nearfield/shape/payload.hpp>
#include <nearfield/shape/sample.hpp>
#include <nearfield/shape/skeleton_offset.hpp>

namespace nearfield {

inline constexpr uint32_t kGreatestVertexCount = 8;

// All points within `radius` of a filled polygon in the local xy plane, raised by `height` along z. Metres: 3
// to 8 vertices and height within the domain, radius in [0, domain]. Simple, of either orientation, convex or
// not: edges of a length above 0 that do not meet but in the vertices that they share. What is inside is
// found by even and odd crossings. Exact distance less the radius; where several edges are equally near, the
// first has the direction. No direction on the polygon. Edges beyond the last one are 0.
template <class S>
struct Polygon {
  using Scalar = S;
  static constexpr Kind kind = Kind::distance;
  // From one vertex to the next, the last to the first.
  struct Edge {
    S x{}, y{};
    Unit<S> axis_x{}, axis_y{};  // a baked direction
    S length{};
  };
  uint32_t vertex_count = 0;
  S height{};
  S radius{};
  Edge edge[kGreatestVertexCount] = {};

  constexpr Polygon() = default;
  // Of vertices (x[i], y[i]). Invalid for any other number of them than 3 to 8.
  constexpr Polygon(const S* x, const S* y, int count, S plane_height, S rounding_radius)
      : height(plane_height), radius(rounding_radius) {
    if (count < 3 || count > static_cast<int>(kGreatestVertexCount)) return;
    vertex_count = static_cast<uint32_t>(count);
    for (int i = 0; i < count; ++i) {
      const int next = i + 1 < count ? i + 1 : 0;
      edge[i] = between(x[i], y[i], x[next], y[next]);
    }
  }

  // 0 for a number of vertices out of range.
  constexpr int item_count() const {
    return vertex_count <= kGreatestVertexCount ? static_cast<int>(vertex_count) : 0;
  }

  // What evaluation reads, where it is.
  struct InImage {
    const uint32_t* payload;
    uint32_t vertex_count() const { return payload[offsetof(Polygon, vertex_count) / 4]; }
    S height() const { return detail::words_as<S>(payload + offsetof(Polygon, height) / 4); }
    S radius() const { return detail::words_as<S>(payload + offsetof(Polygon, radius) / 4); }
    Edge edge(uint32_t i) const {
      const uint32_t* words = payload + offsetof(Polygon, edge) / 4 + i * (sizeof(Edge) / 4);
      return {detail::words_as<S>(words), detail::words_as<S>(words + 1),
              detail::words_as<Unit<S>>(words + 2), detail::words_as<Unit<S>>(words + 3),
              detail::words_as<S>(words + 4)};
    }
  };
  struct InMemory {
    const Polygon& polygon;
    constexpr uint32_t vertex_count() const { return polygon.vertex_count; }
    constexpr S height() const { return polygon.height; }
    constexpr S radius() const { return polygon.radius; }
    constexpr const Edge& edge(uint32_t i) const { return polygon.edge[i]; }
  };

  template <class Out, class Source>
  static constexpr Out evaluate_from(const Source& source, const Vector3<S>& p) {
    const uint32_t count = source.vertex_count();
    const S z = subtract_in_range(p.z, source.height()), radius = source.radius();
    const S first_x = subtract_in_range(p.x, source.edge(0).x),
            first_y = subtract_in_range(p.y, source.edge(0).y);
    S x = first_x, y = first_y;  // from the edge's start to p
    S nearest_x{}, nearest_y{};
    auto least = sum_of_squares(nearest_x, nearest_y);
    bool inside = false;
    for (uint32_t i = 0; i < count; ++i) {
      const Edge e = source.edge(i);
      const S along = narrow_in_range<S>(product(x, e.axis_x) + product(y, e.axis_y));
      const S place = detail::place_on_segment(along, e.length);
      const S away_x = subtract_in_range(x, narrow_in_range<S>(product(place, e.axis_x)));
      const S away_y = subtract_in_range(y, narrow_in_range<S>(product(place, e.axis_y)));
      const auto squares = sum_of_squares(away_x, away_y);
      if (i == 0 || squares < least) {
        least = squares;
        nearest_x = away_x;
        nearest_y = away_y;
      }
      const bool is_last = i + 1 == count;
      const S next_x = is_last ? first_x : subtract_in_range(p.x, source.edge(i + 1).x);
      const S next_y = is_last ? first_y : subtract_in_range(p.y, source.edge(i + 1).y);
      if ((y < S{}) != (next_y < S{}) &&
          (is_negative(product(y, next_x) - product(x, next_y)) != (y < S{}))) {
        inside = !inside;
      }
      x = next_x;
      y = next_y;
    }
    if (inside) {
      Out out;
      out.value = subtract_in_range(absolute(z), radius);
      if constexpr (Out::has_gradient) {
        const S one = ScalarTraits<S>::one();
        out.gradient.z = z > S{} ? one : z < S{} ? -one : S{};
      }
      return out;
    }
    return from_offset<Out>(detail::settled(Vector3<S>{nearest_x, nearest_y, z}), radius);
  }
  template <class Out>
  constexpr Out evaluate(const Vector3<S>& p) const {
    return evaluate_from<Out>(InMemory{*this}, p);
  }

  // Rounding units, at 12 m along an edge: vertices 1/sqrt(2), axis (half a unit of 2^-30 a component, in the
  // place and in the point) 3, place 1/2, its product 1/sqrt(2), length 1, height and radius 1/2 each,
  // root 1.
  constexpr Certificate<S> certificate(Reach<S> reach) const {
    using T = ScalarTraits<S>;
    const S limit = T::domain();
    if (vertex_count < 3 || item_count() == 0) return {};
    if (!(within(height, -limit, limit) && within(radius, S{}, limit))) return {};
    S extent{};
    for (uint32_t i = 0; i < kGreatestVertexCount; ++i) {
      const Edge& e = edge[i];
      if (!(within(e.x, -limit, limit) && within(e.y, -limit, limit))) return {};
      if (i < vertex_count) extent = greatest_of_two(extent, length_of<S>(sum_of_squares(e.x, e.y, height)));
    }
    if (!(edges_follow_from_vertices() && is_simple())) return {};
    // Points at 4 units from where they belong.
    extent = extent + T::times(T::rounding_unit(extent), 4);
    return exact_distance<S>(reach, extent + radius, true, 8);
  }

  // Whether edges have a length above 0 and meet in the vertices alone that they share.
  constexpr bool is_simple() const {
    for (uint32_t i = 0; i < vertex_count; ++i) {
      const Edge &a = edge[i], &b = after(i);
      if (a.length == S{} || folds_back(a, b, after(i + 1 < vertex_count ? i + 1 : 0))) return false;
      for (uint32_t j = i + 2; j < vertex_count; ++j) {
        if ((i != 0 || j + 1 != vertex_count) && meet(a, b, edge[j], after(j))) return false;
      }
    }
    return true;
  }

 private:
  static constexpr Edge between(S x, S y, S next_x, S next_y) {
    const Vector3<S> along = {subtract_in_range(next_x, x), subtract_in_range(next_y, y), S{}};
    const Vector3<Unit<S>> axis = baked_direction(along);
    return {x, y, axis.x, axis.y, length_of<S>(sum_of_squares(along.x, along.y))};
  }
  static constexpr bool same(const Edge& a, const Edge& b) {
    return a.x == b.x && a.y == b.y && a.axis_x == b.axis_x && a.axis_y == b.axis_y && a.length == b.length;
  }
  template <int F, class R>
  static constexpr bool is_negative(WideProduct<F, R> x) {
    return x.raw < 0;
  }
  static constexpr bool is_negative(float x) { return x < 0.0f; }

  constexpr const Edge& after(uint32_t i) const { return edge[i + 1 < vertex_count ? i + 1 : 0]; }

  constexpr bool edges_follow_from_vertices() const {
    for (uint32_t i = 0; i < kGreatestVertexCount; ++i) {
      const Edge& e = edge[i];
      if (!same(e, i < vertex_count ? between(e.x, e.y, after(i).x, after(i).y) : Edge{})) return false;
    }
    return true;
  }

  // On which side of the line from a through b the vertex c lies: 1, -1, or 0 on it. Exact for Fixed.
  static constexpr int side_of(const Edge& a, const Edge& b, const Edge& c) {
    const auto turn = product(subtract_in_range(b.x, a.x), subtract_in_range(c.y, a.y)) -
                      product(subtract_in_range(b.y, a.y), subtract_in_range(c.x, a.x));
    return is_negative(turn) ? -1 : is_negative(decltype(turn){} - turn) ? 1 : 0;
  }
  static constexpr bool overlap(S a, S b, S c, S d) {
    return least_of_two(a, b) <= greatest_of_two(c, d) && least_of_two(c, d) <= greatest_of_two(a, b);
  }
  // Whether the segments from a to b and from c to d have a point in common.
  static constexpr bool meet(const Edge& a, const Edge& b, const Edge& c, const Edge& d) {
    return overlap(a.x, b.x, c.x, d.x) && overlap(a.y, b.y, c.y, d.y) &&
           side_of(a, b, c) * side_of(a, b, d) <= 0 && side_of(c, d, a) * side_of(c, d, b) <= 0;
  }
  // Whether the edge after that from a to b leads back over it, on to c.
  static constexpr bool folds_back(const Edge& a, const Edge& b, const Edge& c) {
    if (side_of(a, b, c) != 0) return false;
    const auto onwards = product(subtract_in_range(b.x, a.x), subtract_in_range(c.x, b.x)) +
                         product(subtract_in_range(b.y, a.y), subtract_in_range(c.y, b.y));
    return is_negative(onwards);
  }
};

}  // namespace nearfield
