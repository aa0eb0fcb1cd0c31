/// Skeletons whose nearest points are found by Newton steps: cubic curves.

#include "property/conformance/wild_skeletons.hpp"
#include "reference/cubic_curves.hpp"

namespace nearfield::property {
namespace {

struct Curve {
  std::vector<Vec3> control;
  bool is_spline = false;
  Real radius{};
  reference::CubicChain chain;

  Curve(std::vector<Vec3> points, bool spline, Real rounding)
      : control(std::move(points)), is_spline(spline), radius(rounding) {
    std::vector<reference::CubicPiece> pieces;
    const auto& c = control;
    for (std::size_t i = 0; i + 3 < c.size(); i += spline ? 1 : 3) {
      pieces.push_back(spline ? reference::spline_piece(c[i], c[i + 1], c[i + 2], c[i + 3])
                              : reference::bezier_piece(c[i], c[i + 1], c[i + 2], c[i + 3]));
    }
    chain = reference::CubicChain(std::move(pieces));
  }
  template <class S>
  CubicCurve<S> rounded_to() const {
    std::vector<Vector3<S>> points;
    for (const Vec3& point : control) points.push_back(rounded<S>(point));
    const int count = static_cast<int>(points.size());
    return is_spline ? CubicCurve<S>::b_spline(points.data(), count, rounded<S>(radius))
                     : CubicCurve<S>(points.data(), count, rounded<S>(radius));
  }
};

/// Of steps of up to `step` that turn by chance; `turn` from 0 for a straight line.
Curve drawn_curve(Random& random, Real size, Real step, Real turn) {
  const bool spline = random.chance(0.5L);
  const std::int64_t pieces = random.chance(0.5L) ? 1 : random.integer(2, 4);
  std::vector<Vec3> control{0.5L * random.vector(-size, size)};
  Vec3 onwards = step * random.unit_vector();
  Vec3 bend = turn * step * random.unit_vector();
  while (static_cast<std::int64_t>(control.size()) < (spline ? pieces + 3 : 3 * pieces + 1)) {
    onwards = onwards + bend;
    if (random.chance(0.3L)) bend = turn * step * random.unit_vector();
    control.push_back(control.back() + onwards);
  }
  return {std::move(control), spline, random.chance(0.3L) ? 0 : random.uniform(0, 0.2L) * size};
}

/// Curves so gentle that their certified errors leave differences of the reference something to say of
/// directions.
struct CurveRow {
  static constexpr const char* name = "cubic_curve";
  static constexpr bool exact_solid = false;  // certified: how far chords may be off, twice
  // Which of two places is nearer is decided within what is certified. Where they are too close for
  // differences to see both, as beside a joint that turns by a small angle, directions differ by that; for
  // all others see the test of wild curves.
  static constexpr Real direction_tolerance = 0.02L;
  using Operations = OnlyOperations<Operation::cubic_curve>;
  using Parameters = Curve;
  static Parameters draw(Random& random, Real size) {
    return drawn_curve(random, size, std::pow(Real{10}, random.uniform(-3, -1.5L)) * size,
                       random.uniform(0, 0.03L));
  }
  static std::vector<Parameters> degenerate(Real size) {
    const Vec3 o{}, x{size, 0, 0}, y{0, size, 0};
    const Real t = 1e-3L * size;
    return {{{o, o, o, o}, false, 0},
            {{x, x, x, x}, true, size},
            {{o, x / 3, (2.0L / 3) * x, x}, false, 0},  // straight, at an even speed
            {{x, x, y, y}, false, 0},                   // straight, its ends at rest
            {{o, o, {t, 0, 0}, {t, t, 0}, {t, 2 * t, 0}, {t, t, t}, {t, t, t}}, true, t},
            {{o, {t, t, 0}, {t, -t, 0}, o}, false, 0},         // a loop
            {{o, {t, t, 0}, {0, t, 0}, {t, 0, 0}}, false, 0},  // a cusp
            {{o, {t, 0, 0}, o, {t, 0, 0}}, false, 0}};         // there and back
  }
  static std::vector<Vec3> places(const Parameters& p) {
    std::vector<Vec3> all;
    for (const reference::CubicPiece& piece : p.chain.pieces()) {
      all.push_back(piece.at(0));
      all.push_back(piece.at(0.43L));
      all.push_back(piece.at(1) + Vec3{0, p.radius, 0});
    }
    return all;
  }
  template <class S>
  static auto node(const Parameters& p) {
    return p.rounded_to<S>();
  }
  static Real value(const Parameters& parameters, const Vec3& p) {
    return parameters.chain.distance(p) - parameters.radius;
  }
};

struct WildCurve {
  static Curve draw(Random& random, Real domain, Real step) {
    return drawn_curve(random, 0.5L * domain, step, std::pow(Real{10}, random.uniform(-3, 0.3L)));
  }
  static Vec3 on(const Curve& curve, Random& random) { return curve.chain.pieces()[0].at(random.uniform(0, 1)); }
  static auto nearest(const Curve& curve, const Vec3& p) { return curve.chain.nearest(p); }
};

TEST(CurveConformance, CubicCurve) { judge_row<CurveRow>(741); }

TEST(CurveConformance, WildCurvesAreWithinWhatIsCertified) {
  const WildTaste taste{"curves", 150, 100, 20, 16, 0.001L};
  judge_wild_skeletons<WildCurve>(taste, reference::announced_seed("wild curves", 742));
}

}  // namespace
}  // namespace nearfield::property
