/// Surfaces whose nearest points are found by Newton steps: bicubic patches.

#include "property/conformance/wild_skeletons.hpp"
#include "reference/bicubic_patches.hpp"

namespace nearfield::property {
namespace {

struct Patch {
  std::vector<Vec3> control;
  Real radius{};
  reference::BicubicSurface surface;

  Patch(std::vector<Vec3> points, Real rounding, int cells = 8)
      : control(std::move(points)), radius(rounding), surface(control, cells) {}

  template <class S>
  BicubicPatch<S> rounded_to() const {
    Vector3<S> points[16];
    for (std::size_t i = 0; i < 16; ++i) points[i] = rounded<S>(control[i]);
    return {points, rounded<S>(radius)};
  }
};

/// A parallelogram of edges of `step` and less, each point off by up to `bend`. None too thin for the
/// reference's grid.
std::vector<Vec3> drawn_points(Random& random, Real size, Real step, Real bend) {
  const Vec3 corner = 0.5L * random.vector(-size, size), direction_u = random.unit_vector();
  Vec3 direction_v = random.unit_vector();
  while (std::fabs(dot(direction_u, direction_v)) > 0.9L) direction_v = random.unit_vector();
  const Vec3 along_u = step * direction_u, along_v = step * random.uniform(0.2L, 1) * direction_v;
  std::vector<Vec3> control;
  for (int i = 0; i < 16; ++i)
    control.push_back(corner + Real(i / 4) * along_u + Real(i % 4) * along_v +
                      random.uniform(0, bend) * random.unit_vector());
  return control;
}
/// Of a function of both indices.
template <class Place>
std::vector<Vec3> points_of(const Place& place) {
  std::vector<Vec3> control;
  for (int i = 0; i < 16; ++i) control.push_back(place(Real(i / 4), Real(i % 4)));
  return control;
}

/// Patches so gentle that their certified errors leave differences of the reference something to say of
/// directions.
struct PatchRow {
  static constexpr const char* name = "bicubic_patch";
  static constexpr bool exact_solid = false;  // certified: how far parallelograms may be off, twice
  // Where two places are too close for differences to see both; for all others see the test of wild patches.
  static constexpr Real direction_tolerance = 0.02L;
  static constexpr int one_draw_in = 8;
  using Operations = OnlyOperations<Operation::bicubic_patch>;
  using Parameters = Patch;
  static Parameters draw(Random& random, Real size) {
    const Real step = std::pow(Real{10}, random.uniform(-3, -1)) * size;
    return {drawn_points(random, size, step, random.uniform(0, 0.03L) * step),
            random.chance(0.3L) ? 0 : random.uniform(0, 0.2L) * size};
  }
  static std::vector<Parameters> degenerate(Real size) {
    const Real s = size / 3, t = 1e-3L * size;
    const Real there_and_back[] = {0, t, -0.2L * t, 0.8L * t};
    return {{points_of([&](Real, Real) {
               return Vec3{size, 0, -size};
             }),
             0, 2},
            {points_of([&](Real, Real) { return Vec3{}; }), size, 2},
            {points_of([&](Real i, Real j) {
               return Vec3{s * i, s * j, 0};
             }),
             0},  // planar
            {points_of([&](Real i, Real j) {
               return Vec3{1.9L * size * (i - 1.5L), 1.9L * size * (j - 1.5L), size};
             }),
             0},  // as large as can be
            {points_of([&](Real i, Real j) {
               return Vec3{s * i, s * i, t * j};
             }),
             0},  // a band
            {points_of([&](Real i, Real) {
               return Vec3{s * i, 0, s * i};
             }),
             t},  // a segment
            {points_of([&](Real, Real j) {
               return Vec3{0, s * j, 0};
             }),
             0},  // across
            {points_of([&](Real i, Real j) {
               return Vec3{t * i, 2 * t * j, 0.5L * t * i};
             }),
             0},
            {points_of([&](Real i, Real j) {
               return Vec3{t * (i + j), t * (i + j), 0};
             }),
             0},  // all in line
            {points_of([&](Real i, Real j) {
               return Vec3{t * i * j / 3, t * j, 0};
             }),
             0},  // a triangle
            {points_of([&](Real i, Real j) {
               return Vec3{there_and_back[static_cast<int>(i)], t * j, 0};
             }),
             0, 24}};
  }
  static std::vector<Vec3> places(const Parameters& p) {
    return {p.surface.at(0, 0), p.surface.at(1, 0.25L), p.surface.at(0.43L, 0.61L),
            p.surface.at(0.5L, 1) + Vec3{0, p.radius, 0}};
  }
  template <class S>
  static auto node(const Parameters& p) {
    return p.rounded_to<S>();
  }
  static Real value(const Parameters& parameters, const Vec3& p) {
    return parameters.surface.distance(p) - parameters.radius;
  }
};

struct WildPatch {
  static Patch draw(Random& random, Real domain, Real step) {
    const Real bend = std::pow(Real{10}, random.uniform(-3, 0)) * step;
    return Patch(drawn_points(random, 0.5L * domain, step, bend), 0.1L * step, 24);
  }
  static Vec3 on(const Patch& patch, Random& random) {
    const Real u = random.uniform(0, 1);
    return patch.surface.at(u, random.uniform(0, 1));
  }
  static auto nearest(const Patch& patch, const Vec3& p) { return patch.surface.nearest(p); }
};

TEST(PatchConformance, BicubicPatch) { judge_row<PatchRow>(751); }

TEST(PatchConformance, WildPatchesAreWithinWhatIsCertified) {
  const WildTaste taste{"patches", 60, 100, 6, 32, 0.01L};
  judge_wild_skeletons<WildPatch>(taste, reference::announced_seed("wild patches", 752));
}

}  // namespace
}  // namespace nearfield::property
