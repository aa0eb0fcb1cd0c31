/// Skeletons: polylines and polygons.

#include "reference/skeletons.hpp"
#include "property/conformance/conformance.hpp"

namespace nearfield::property {
namespace {

struct Chain {
  std::vector<Vec3> points;
  Real radius{};
};

/// Where two segments meet at a shallow angle, which of them is nearer is decided within the error: too far
/// from the kink for differences to see it.
constexpr Real between_neighbours = 1e-3L;

/// Of a skeleton that rounds its points itself: as given, and its radius.
template <class S>
std::vector<Vector3<S>> rounded_points(const std::vector<Vec3>& points) {
  std::vector<Vector3<S>> result;
  for (const Vec3& point : points) result.push_back(rounded<S>(point));
  return result;
}

struct PolylineRow {
  static constexpr const char* name = "polyline";
  static constexpr bool exact_solid = true;
  static constexpr Real direction_tolerance = between_neighbours;
  using Operations = OnlyOperations<Operation::polyline>;
  using Parameters = Chain;
  static Parameters draw(Random& random, Real size) {
    Chain chain{{}, random.chance(0.3L) ? 0 : random.uniform(0, 0.5L) * size};
    const std::int64_t count = random.integer(2, 8);
    const bool winding = random.chance(0.5L);
    for (std::int64_t i = 0; i < count; ++i) {
      const Vec3 anywhere = random.vector(-size, size);
      const Vec3 step = std::pow(Real{10}, random.uniform(-4, -0.5L)) * size * random.unit_vector();
      Vec3 next = winding && i > 0 ? chain.points.back() + step : anywhere;
      if (i > 0 && random.chance(0.05L)) next = chain.points.back();
      const auto inside = [size](Real a) { return std::clamp(a, -size, size); };
      chain.points.push_back({inside(next.x), inside(next.y), inside(next.z)});
    }
    return chain;
  }
  static std::vector<Parameters> degenerate(Real size) {
    const Vec3 o{}, x{size, 0, 0}, y{0, size, 0}, z{0, 0, size};
    return {{{o, o}, 0},
            {{o, o}, size},
            {{x, x, x, x, x, x, x, x}, 0},
            {{o, x}, 0},
            {{o, x, o, x, o}, 0},                     // there and back
            {{o, x, x, y, y, z, z, o}, 0.1L * size},  // closed, with segments of length 0
            {{o, {1e-7L, 0, 0}, {0, 1e-7L, 0}}, 0},
            {{-x, o, x, y}, 1e-3L}};
  }
  static std::vector<Vec3> places(const Parameters& p) {
    std::vector<Vec3> all;
    for (std::size_t i = 0; i + 1 < p.points.size(); ++i) {
      all.push_back(p.points[i]);
      all.push_back(0.5L * (p.points[i] + p.points[i + 1]));
    }
    all.push_back(p.points.back());
    all.push_back(p.points.back() + Vec3{0, 0, p.radius});
    return all;
  }
  template <class S>
  static auto node(const Parameters& p) {
    return Polyline<S>(rounded_points<S>(p.points).data(), static_cast<int>(p.points.size()),
                       rounded<S>(p.radius));
  }
  static Real value(const Parameters& parameters, const Vec3& p) {
    return reference::polyline_distance(parameters.points, p) - parameters.radius;
  }
};

struct PolygonRow {
  static constexpr const char* name = "polygon";
  static constexpr bool exact_solid = true;
  static constexpr Real direction_tolerance = between_neighbours;
  using Operations = OnlyOperations<Operation::polygon>;
  using Parameters = Chain;  // all points at one height
  /// About a point inside: at rising angles and any distances a polygon is simple.
  static Parameters draw(Random& random, Real size) {
    const auto count = static_cast<std::size_t>(random.integer(3, 8));
    std::vector<Real> angles;
    while (angles.size() < count) angles.push_back(random.uniform(0, 2 * reference::pi));
    std::sort(angles.begin(), angles.end());
    const Vec3 middle = 0.5L * random.vector(-size, size);
    const Real stretch = std::pow(Real{10}, random.uniform(-2, 0));
    Chain polygon{{}, random.chance(0.3L) ? 0 : random.uniform(0, 0.5L) * size};
    for (const Real angle : angles) {
      const Real away = random.uniform(0.1L, 0.5L) * size;
      polygon.points.push_back(middle + away * Vec3{std::cos(angle), stretch * std::sin(angle), 0});
    }
    if (random.chance(0.5L)) std::reverse(polygon.points.begin(), polygon.points.end());
    return polygon;
  }
  static std::vector<Parameters> degenerate(Real size) {
    const Real s = size, t = 1e-4L;
    return {
        {{{0, 0, 0}, {s, 0, 0}, {0, s, 0}}, 0},
        {{{0, 0, s}, {0, s, s}, {s, 0, s}}, s},
        {{{-s, -s, 0}, {s, -s, 0}, {s, s, 0}, {-s, s, 0}}, 0},
        {{{0, 0, 0}, {s, 0, 0}, {s, s, 0}, {t, s, 0}, {t, s / 2, 0}, {0, s / 2, 0}}, 0},  // two at one height
        {{{0, 0, 0}, {s, 0, 0}, {s, t, 0}, {t, t, 0}, {t, s, 0}, {0, s, 0}}, 0},          // thin, an L
        {{{0, 0, 0}, {s / 2, 0, 0}, {s, 0, 0}, {s, s, 0}, {s / 2, s / 4, 0}, {0, s, 0}},
         0},  // vertices on a line
        {{{-s, 0, 0}, {s, 0, 0}, {s, t, 0}}, 1e-3L},
        {{{0, 0, 0}, {s, 0, 0}, {s, s, 0}, {s - t, s, 0}, {s - t, t, 0}, {t, t, 0}, {t, s, 0}, {0, s, 0}},
         0}};  // thin, a U
  }
  static std::vector<Vec3> places(const Parameters& p) {
    std::vector<Vec3> all{{0.25L * (p.points[0] + p.points[1] + 2 * p.points[2])}};
    for (std::size_t i = 0; i < p.points.size(); ++i) {
      const Vec3 middle = 0.5L * (p.points[i] + p.points[(i + 1) % p.points.size()]);
      all.insert(all.end(), {p.points[i], middle, middle + Vec3{0, 0, p.radius}});
    }
    return all;
  }
  template <class S>
  static auto node(const Parameters& p) {
    std::vector<S> x, y;
    for (const Vec3& point : p.points) {
      x.push_back(rounded<S>(point.x));
      y.push_back(rounded<S>(point.y));
    }
    return Polygon<S>(x.data(), y.data(), static_cast<int>(x.size()), rounded<S>(p.points[0].z),
                      rounded<S>(p.radius));
  }
  static Real value(const Parameters& parameters, const Vec3& p) {
    return reference::polygon_distance(parameters.points, p) - parameters.radius;
  }
};

TEST(SkeletonConformance, Polyline) { judge_row<PolylineRow>(731); }
TEST(SkeletonConformance, Polygon) { judge_row<PolygonRow>(732); }

}  // namespace
}  // namespace nearfield::property
