// Contact of I-patches and functional splines with their primaries, measured on the evaluated surface at
// shrinking distances from the sides: how fast the surfaces, their normals and their curvatures part.
#include "patch_samples.hpp"

#include <array>
#include <functional>

namespace {

using namespace nearfield;
using namespace nearfield::test;
using reference::announced_seed;

template <class S>
class ContactOf : public testing::Test {};
TYPED_TEST_SUITE(ContactOf, AllScalars, );

// A function's value and gradient per metre.
struct Jet {
  Real value{};
  Vec3 gradient{};
};
Jet operator+(const Jet& a, const Jet& b) { return {a.value + b.value, a.gradient + b.gradient}; }
Jet operator-(const Jet& a, const Jet& b) { return {a.value - b.value, a.gradient - b.gradient}; }
Jet operator*(const Jet& a, const Jet& b) {
  return {a.value * b.value, a.value * b.gradient + b.value * a.gradient};
}
Jet operator*(Real scale, const Jet& a) { return {scale * a.value, scale * a.gradient}; }
Jet power(const Jet& a, int exponent) { return exponent > 1 ? a * power(a, exponent - 1) : a; }
Jet quotient(const Jet& a, const Jet& b) {
  const Real value = a.value / b.value;
  return {value, (a.gradient - value * b.gradient) / b.value};
}
Jet linear(const Vec3& normal, Real offset, const Vec3& p) { return {dot(normal, p) + offset, normal}; }

using Function = std::function<Jet(const Vec3&)>;

// The point next to `p` where two functions vanish, or three, by Newton's method.
Vec3 common_zero(const Function& first, const Function& second, const Function& third, Vec3 p) {
  for (int step = 0; step < 12; ++step) {
    const Jet a = first(p), b = second(p);
    const Jet c = third ? third(p) : Jet{0, cross(a.gradient, b.gradient)};
    const Vec3 of_a = cross(b.gradient, c.gradient), of_b = cross(c.gradient, a.gradient);
    const Vec3 whole = a.value * of_a + b.value * of_b + c.value * cross(a.gradient, b.gradient);
    p = p - whole / dot(a.gradient, of_a);
  }
  return p;
}

// Where a surface and its primary touch, and a direction along the primary in which they part.
struct Ray {
  Function primary;
  Vec3 point, normal, direction;
};
Ray ray_of(const Function& primary, const Vec3& point, const Vec3& inwards) {
  const Vec3 normal = reference::normalized_or_zero(primary(point).gradient);
  return {primary, point, normal, reference::normalized_or_zero(inwards - dot(inwards, normal) * normal)};
}
// Into the side of one bound, up to 50 degrees off the straight way.
Ray ray_from_side(const Function& primary, const Function& bound, const Vec3& point, Random& random) {
  const Vec3 along = reference::normalized_or_zero(cross(primary(point).gradient, bound(point).gradient));
  Ray ray = ray_of(primary, point, bound(point).gradient);
  const Real angle = random.uniform(-0.9L, 0.9L);
  ray.direction = std::cos(angle) * ray.direction + std::sin(angle) * along;
  return ray;
}
// Between two sides.
Ray ray_from_corner(const Function& primary, const Function& a, const Function& b, const Vec3& point,
                    Random& random) {
  const Vec3 normal = primary(point).gradient, of_a = a(point).gradient, of_b = b(point).gradient;
  const Vec3 into_a = cross(of_b, normal), into_b = cross(normal, of_a);
  const Real sign = dot(of_a, into_a) > 0 ? 1 : -1;
  return ray_of(primary, point, sign * (random.uniform(0.5L, 1) * into_a + random.uniform(0.5L, 1) * into_b));
}

// Height of a function's zero set over a point, along a direction.
Real height(const Function& function, const Vec3& from, const Vec3& normal) {
  Real height = 0;
  for (int step = 0; step < 5; ++step) {
    const Jet at = function(from + height * normal);
    height -= at.value / dot(at.gradient, normal);
  }
  return height;
}

// The greatest differences between a surface and its primary, over rays, at distances that halve: of heights
// over the tangent plane, of normals (sine of the angle), of normal curvatures (second differences of these
// heights).
class Contact {
 public:
  static constexpr size_t level_count = 4;

  explicit Contact(Real greatest_distance) : greatest_distance_(greatest_distance) {}

  void measure(const Function& surface, const Ray& ray) {
    const auto parted = [&](Real distance, size_t level) {
      const Vec3 from = ray.point + distance * ray.direction;
      const Real of_primary = height(ray.primary, from, ray.normal);
      const Real of_surface = height(surface, from, ray.normal);
      const Vec3 on_surface = from + of_surface * ray.normal;
      const Vec3 a = surface(on_surface).gradient, b = ray.primary(on_surface).gradient;
      see(angles_[level], norm(cross(a, b)) / (norm(a) * norm(b)));
      return of_surface - of_primary;
    };
    std::array<Real, level_count> parts{};
    Real distance = greatest_distance_;
    for (size_t level = 0; level < level_count; ++level, distance /= 2) {
      parts[level] = parted(distance, level);
      see(heights_[level], parts[level]);
    }
    std::array<Real, level_count> unused = angles_;
    const Real touching = parted(0, 0);
    angles_ = unused;
    at_side_ = std::max(at_side_, std::fabs(touching));
    distance = greatest_distance_ / 2;
    for (size_t level = 0; level + 1 < level_count; ++level, distance /= 2) {
      see(curvatures_[level], (parts[level] - 2 * parts[level + 1] + touching) / (distance * distance));
    }
  }

  Real at_side() const { return at_side_; }
  // The power of the distance with which the differences close, between the two shortest distances.
  Real order_of_heights() const { return order(heights_, level_count - 1); }
  Real order_of_normals() const { return order(angles_, level_count - 1); }
  Real order_of_curvatures() const { return order(curvatures_, level_count - 2); }
  Real last_angle() const { return angles_[level_count - 1]; }
  Real last_curvature() const { return curvatures_[level_count - 2]; }

  // Whether they close at all, by rather more than what is measured by accident.
  bool has_common_normals() const { return order_of_normals() > 0.5L && last_angle() < 0.5L * angles_[0]; }
  bool has_common_curvatures() const {
    return has_common_normals() && order_of_curvatures() > 0.5L && last_curvature() < 0.5L * curvatures_[0];
  }
  void expect_orders(int exponent, Real tolerance, const char* name) const {
    EXPECT_LE(std::fabs(order_of_heights() - static_cast<Real>(exponent)), tolerance) << name;
    EXPECT_LE(std::fabs(order_of_normals() - static_cast<Real>(exponent - 1)), tolerance) << name;
    EXPECT_EQ(has_common_normals(), exponent >= 2) << name;
    EXPECT_EQ(has_common_curvatures(), exponent >= 3) << name;
    if (exponent >= 2) {
      EXPECT_LE(std::fabs(order_of_curvatures() - static_cast<Real>(exponent - 2)), tolerance) << name;
    }
    if (exponent == 2) {
      EXPECT_GT(last_curvature(), 0.1L) << name;
    }
  }
  void print(const char* name) const {
    std::printf("%-32s orders: heights %.2Lf, normals %.2Lf, curvatures %.2Lf; ", name, order_of_heights(),
                order_of_normals(), order_of_curvatures());
    std::printf("last differences: normals %.1Le, curvatures %.1Le\n", last_angle(), last_curvature());
  }

 private:
  using Levels = std::array<Real, level_count>;
  static void see(Real& greatest, Real seen) { greatest = std::max(greatest, std::fabs(seen)); }
  static Real order(const Levels& levels, size_t last) { return std::log2(levels[last - 1] / levels[last]); }

  Real greatest_distance_, at_side_ = 0;
  Levels heights_{}, angles_{}, curvatures_{};
};

// A patch of n sides in a polygon about 2 m wide: its bounds stand on the sides, bent and leaning; ribbons
// share the curves in which one function vanishes on the bounds, and cross them each at its own angle;
// corners are bent planes through the polygon's.
struct Polygon {
  size_t count;
  std::vector<Function> bounds, ribbons, corners;
  std::vector<Vec3> vertices;

  Polygon(size_t sides, Random& random) : count(sides) {
    const Vec3 slope = random.vector(-0.3L, 0.3L), bend = random.vector(-0.2L, 0.2L);
    const Function height_over = [=](const Vec3& p) {
      const Jet x = linear({1, 0, 0}, 0, p), y = linear({0, 1, 0}, 0, p);
      return linear({slope.x, slope.y, 1}, 0, p) - (bend.x * (x * x) + bend.y * (x * y) + bend.z * (y * y));
    };
    for (size_t i = 0; i < count; ++i) {
      const Real angle = angle_of(static_cast<Real>(i)), lean = random.uniform(-0.1L, 0.1L);
      const Real sag = random.uniform(-0.06L, 0.06L);
      bounds.push_back([=](const Vec3& p) {
        const Jet along = linear({-std::sin(angle), std::cos(angle), 0}, 0, p);
        return linear({-std::cos(angle), -std::sin(angle), lean}, 1, p) + sag * (along * along);
      });
      const Vec3 crossing = random.vector(-0.5L, 0.5L);
      const Real sign = random.chance(0.5L) ? -1 : 1;
      ribbons.push_back([=, bound = bounds.back()](const Vec3& p) {
        return height_over(p) - bound(p) * linear(crossing, sign, p);
      });
    }
    for (size_t k = 0; k < count; ++k) {
      const Real angle = angle_of(static_cast<Real>(k) + 0.5L);
      const Function &a = bounds[k], &b = bounds[next(k)];
      const Vec3 vertex = common_zero(a, b, height_over, {std::cos(angle), std::sin(angle), 0});
      vertices.push_back(vertex);
      const Vec3 tilt = random.vector(-0.4L, 0.4L);
      const Real curved = random.uniform(-0.3L, 0.3L);
      corners.push_back([=](const Vec3& p) {
        const Jet x = linear({1, 0, 0}, -vertex.x, p), y = linear({0, 1, 0}, -vertex.y, p);
        return linear({tilt.x, tilt.y, 1}, 0, p - vertex) + curved * (x * y);
      });
    }
  }
  size_t next(size_t k) const { return k + 1 < count ? k + 1 : 0; }
  size_t previous(size_t k) const { return k > 0 ? k - 1 : count - 1; }
  Real angle_of(Real side) const { return 2 * reference::pi * side / static_cast<Real>(count); }
  // On a side, away from its ends.
  Vec3 on_side(size_t i, const Function& primary, Random& random) const {
    const Vec3 a = vertices[previous(i)], b = vertices[i];
    return common_zero(bounds[i], primary, {}, a + random.uniform(0.35L, 0.65L) * (b - a));
  }
  // The two-sided patch that a patch by corners is on side k.
  Function ribbon_of_corners(size_t k, const reference::PatchCoefficients& weights) const {
    const Function before = corners[previous(k)], after = corners[k];
    const Function low = bounds[previous(k)], high = bounds[next(k)];
    const int exponent = weights.exponent;
    return [=, weight = weights.side[k]](const Vec3& p) {
      const Jet a = power(low(p), exponent), b = power(high(p), exponent);
      return quotient(before(p) * b + after(p) * a + weight * (a * b), a + b);
    };
  }
};

// Algebraic functions have any unit. In these, values and slopes of the polygons' have many digits in S.
template <class S>
struct Units {
  Real value, slope;
  static Units of_scalar() {
    const Real last_place = unit<S>(1);
    return last_place > 1e-6L ? Units{4096, 1024} : last_place > 1e-8L ? Units{16, 16} : Units{4, 2};
  }
  // A weight of terms with so many factors |B|^exponent more than the primaries' have.
  Real weight(int factors) const { return std::pow(value, static_cast<Real>(1 - factors)); }
};

// The polygon's patch as it is evaluated with numbers of S.
template <class S>
Jet evaluated(const Polygon& polygon, const reference::PatchCoefficients& weights, bool by_corners,
              const Vec3& p) {
  const Units<S> units = Units<S>::of_scalar();
  RandomPatch<S> patch;
  patch.weights = weights;
  const int exponent = weights.exponent;
  for (size_t i = 0; i < polygon.count; ++i) {
    const auto expressed = [&units](const Jet& at) {
      return Sample<S>{number<S>(units.value * at.value), vector<S>(units.slope * at.gradient)};
    };
    patch.primaries.push_back(expressed(by_corners ? polygon.corners[i](p) : polygon.ribbons[i](p)));
    patch.bounds.push_back(expressed(polygon.bounds[i](p)));
    if (by_corners) patch.weights.side[i] *= units.weight(exponent);
  }
  patch.weights.bound *= units.weight(by_corners ? 2 * exponent : exponent);
  const Sample<S> got = by_corners ? patch.template corner<Sample<S>>() : patch.template ribbon<Sample<S>>();
  return {real(got.value) / units.value, real(got.gradient) / units.slope};
}
// Weights that numbers of S express.
template <class S>
reference::PatchCoefficients expressed(reference::PatchCoefficients weights, bool by_corners) {
  const auto round = [](Real& weight, Real unit) { weight = real(number<S>(weight * unit)) / unit; };
  const Units<S> units = Units<S>::of_scalar();
  const int exponent = weights.exponent;
  for (Real& weight : weights.side) round(weight, by_corners ? units.weight(exponent) : 1);
  round(weights.bound, units.weight(by_corners ? 2 * exponent : exponent));
  return weights;
}
// By the reference, from its formulas.
Jet exact(const Polygon& polygon, const reference::PatchCoefficients& weights, bool by_corners,
          const Vec3& p) {
  const auto& functions = by_corners ? polygon.corners : polygon.ribbons;
  std::vector<Real> primaries, bounds;
  for (size_t i = 0; i < polygon.count; ++i) {
    primaries.push_back(functions[i](p).value);
    bounds.push_back(polygon.bounds[i](p).value);
  }
  const auto patch = by_corners ? reference::corner_patch : reference::ribbon_patch;
  const reference::PatchPoint point = patch(weights, primaries, bounds);
  Jet result{point.value, {}};
  for (size_t i = 0; i < polygon.count; ++i) {
    result.gradient += point.by_primaries[i] * functions[i](p).gradient;
    result.gradient += point.by_bounds[i] * polygon.bounds[i](p).gradient;
  }
  return result;
}

reference::PatchCoefficients random_weights(size_t count, int exponent, bool by_corners, Random& random) {
  reference::PatchCoefficients weights;
  weights.exponent = exponent;
  weights.bound = random.uniform(-0.5L, 0.5L);
  for (size_t i = 0; i < count; ++i) {
    weights.side.push_back(by_corners ? random.uniform(-0.3L, 0.3L) : random.uniform(0.5L, 1));
  }
  return weights;
}

// Along all sides of a few patches, and from the corners of those that have any.
struct PatchContact {
  Contact sides, corners;

  explicit PatchContact(Real distance) : sides(distance), corners(distance) {}
  template <class Patch>
  void measure(const Polygon& polygon, const reference::PatchCoefficients& weights, bool by_corners,
               Random& random, const Patch& patch) {
    const Function surface = [&](const Vec3& p) { return patch(polygon, weights, by_corners, p); };
    for (size_t i = 0; i < polygon.count; ++i) {
      const Function primary = by_corners ? polygon.ribbon_of_corners(i, weights) : polygon.ribbons[i];
      const Vec3 start = polygon.on_side(i, primary, random);
      sides.measure(surface, ray_from_side(primary, polygon.bounds[i], start, random));
      if (!by_corners) continue;
      const Function &before = polygon.bounds[i], &after = polygon.bounds[polygon.next(i)];
      corners.measure(surface,
                      ray_from_corner(polygon.corners[i], before, after, polygon.vertices[i], random));
    }
  }
};

constexpr int kPatchesOfAKind = 3;

// The reference's own, much closer to the sides: what the papers' formulas promise.
TEST(PatchContact, IsThatOfTheFormulas) {
  Random random(announced_seed("IsThatOfTheFormulas", 68));
  for (size_t count = 3; count <= 8; ++count) {
    for (const int exponent : {2, 3}) {
      for (const bool by_corners : {false, true}) {
        PatchContact contact(1.0L / 1024);
        for (int i = 0; i < kPatchesOfAKind; ++i) {
          const Polygon polygon(count, random);
          const auto weights = random_weights(count, exponent, by_corners, random);
          contact.measure(polygon, weights, by_corners, random, exact);
        }
        contact.sides.expect_orders(exponent, 0.05L, by_corners ? "sides between corners" : "ribbons");
        if (by_corners) contact.corners.expect_orders(exponent, 0.05L, "corners");
      }
    }
  }
}

// Exponent 2 has common normals and no common curvatures, exponent 3 has both.
TYPED_TEST(ContactOf, PatchesHaveTheOrderOfTheExponent) {
  using S = TypeParam;
  Random random(announced_seed("PatchesHaveTheOrderOfTheExponent", 69));
  const Real value_unit = Units<S>::of_scalar().value, rounding = 6 * unit<S>(value_unit) / value_unit;
  for (size_t count = 3; count <= 8; ++count) {
    for (const int exponent : {2, 3}) {
      for (const bool by_corners : {false, true}) {
        // What closes faster is lost sooner in the rounding.
        PatchContact contact((exponent == 2 ? 0.25L : 0.5L) / static_cast<Real>(count));
        for (int i = 0; i < kPatchesOfAKind; ++i) {
          const Polygon polygon(count, random);
          const auto weights = expressed<S>(random_weights(count, exponent, by_corners, random), by_corners);
          contact.measure(polygon, weights, by_corners, random, evaluated<S>);
        }
        const std::string name = std::to_string(count) + (by_corners ? " sides by corners" : " ribbons") +
                                 ", exponent " + std::to_string(exponent);
        contact.sides.print(name.c_str());
        contact.sides.expect_orders(exponent, 0.35L, name.c_str());
        EXPECT_LE(contact.sides.at_side(), rounding) << name;
        if (!by_corners) continue;
        contact.corners.print("  at its corners");
        contact.corners.expect_orders(exponent, 0.35L, (name + ", at its corners").c_str());
        EXPECT_LE(contact.corners.at_side(), rounding) << name;
      }
    }
  }
}

// The fillet of two bent surfaces: exponent 1 has contact and no common normals.
TYPED_TEST(ContactOf, FunctionalSplinesHaveTheOrderOfTheExponent) {
  using S = TypeParam;
  Random random(announced_seed("FunctionalSplinesHaveTheOrderOfTheExponent", 70));
  // Enlarged, coarse numbers express them as well.
  const Real enlarged = ScalarTraits<S>::is_fixed && unit<S>(1) > 1e-6L ? 8 : 1;
  for (const int exponent : {1, 2, 3}) {
    Contact contact(std::ldexp(Real{1}, exponent - 6));
    for (int i = 0; i < 20; ++i) {
      const Vec3 curved = random.vector(-0.2L, 0.2L), tilt = random.vector(-0.2L, 0.2L);
      const Function first = [=](const Vec3& p) {
        const Jet x = linear({1, 0, 0}, 0, p), y = linear({0, 1, 0}, 0, p);
        return linear({tilt.x, tilt.y, 1}, 0, p) + curved.x * (x * x) + curved.y * (x * y);
      };
      const Function second = [=](const Vec3& p) {
        const Jet y = linear({0, 1, 0}, 0, p);
        return linear({1, tilt.z, 0.2L}, 0, p) + curved.z * (y * y);
      };
      const Function bound = [=](const Vec3& p) { return linear({-1, 0.1L * tilt.x, -1}, 1, p); };
      FunctionalSpline<S> spline;
      spline.primary_count = 2;
      spline.bound_count = 1;
      spline.exponent = static_cast<uint32_t>(exponent);
      spline.lambda = number<S>(0.25L);
      const Function surface = [&](const Vec3& p) {
        std::vector<Sample<S>> of;
        for (const Function* one : {&first, &second, &bound}) {
          const Jet at = (*one)(p);
          of.push_back({number<S>(enlarged * at.value), vector<S>(enlarged * at.gradient)});
        }
        const Sample<S> got = spline.template combine_all<Sample<S>>(of.data());
        return Jet{real(got.value), real(got.gradient)};
      };
      const Vec3 start = common_zero(bound, first, {}, {1, random.uniform(-0.5L, 0.5L), 0});
      contact.measure(surface, ray_from_side(first, bound, start, random));
    }
    const std::string name = "functional spline, exponent " + std::to_string(exponent);
    contact.print(name.c_str());
    contact.expect_orders(exponent, 0.35L, name.c_str());
  }
}

}  // namespace
