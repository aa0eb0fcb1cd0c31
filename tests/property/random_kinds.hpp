#pragma once
/// Random fields of rays, algebraic values and intensities: trees of operations, evaluated and certified from
/// the leaves up by the operations' own functions, at the same time as by the reference. Parameters are real
/// numbers: what is evaluated has them rounded.

#include <nearfield/curve/potential.hpp>
#include <nearfield/curve/range_control.hpp>
#include <nearfield/curve/ray_kernel.hpp>
#include <nearfield/curve/tabulated_form.hpp>
#include <nearfield/field/compose.hpp>

#include "property/conversion.hpp"
#include "reference/algebraic_blends.hpp"
#include "reference/implicit_patches.hpp"
#include "reference/potential_curves.hpp"
#include "reference/random.hpp"
#include "reference/shapes.hpp"
#include "reference/soft_blends.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <functional>
#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace nearfield::property {

using reference::Random;
using reference::Vec3;

/// A field, twice, and what is certified within the reach for which it was made.
template <class S>
struct CertifiedNode {
  std::function<S(const Vector3<S>&)> evaluated;
  std::function<Real(const Vec3&)> exact;
  Certificate<S> certificate;
  int depth = 0;     // blends above each other
  Real weights = 0;  // of an intensity: the sum of the magnitudes of its weights
};
template <class S>
using CertifiedField = std::shared_ptr<const CertifiedNode<S>>;

/// A table that lives as long as the test.
template <class S>
struct Tabulated {
  TableView<S> view;
  TableFacts facts;
};

/// A function of a table whose type does not matter, so that baking is compiled once.
class AnyFunction {
 public:
  template <class Function>
  explicit AnyFunction(const Function& function)
      : function_(function), breaks_(nearfield::detail::breaks_of(function, 0)) {}

  Differentiable operator()(const Differentiable& u) const { return function_(u); }
  nearfield::detail::Breaks breaks() const { return breaks_; }

 private:
  std::function<Differentiable(const Differentiable&)> function_;
  nearfield::detail::Breaks breaks_;
};

template <class S>
Tabulated<S> tabulated(const AnyFunction& function, bool monotone = false) {
  static std::vector<std::unique_ptr<Table<S, 128>>> tables;
  tables.push_back(std::make_unique<Table<S, 128>>(bake<S, 128>(function, monotone)));
  return {tables.back()->view(), tables.back()->facts};
}

/// Of a leaf's point, and of a blend's operands in an array.
using ExactLeaf = std::function<Real(const Vec3&)>;
using ExactBlend = std::function<Real(const Real*)>;

template <class S, class Shape>
[[gnu::noinline]] CertifiedField<S> leaf(const Shape& shape, Reach<S> reach, ExactLeaf exact) {
  auto node = std::make_shared<CertifiedNode<S>>();
  node->evaluated = [shape](const Vector3<S>& p) { return shape.template evaluate<Value<S>>(p).value; };
  node->exact = std::move(exact);
  node->certificate = shape.certificate(reach);
  return node;
}
template <class S, class Shape>
[[gnu::noinline]] CertifiedField<S> leaf(const Shape& shape, const Tabulated<S>& table, Reach<S> reach,
                                         ExactLeaf exact) {
  auto node = std::make_shared<CertifiedNode<S>>();
  node->evaluated = [shape, view = table.view](const Vector3<S>& p) {
    return shape.template evaluate<Value<S>>(p, view).value;
  };
  node->exact = std::move(exact);
  node->certificate = shape.certificate(reach, table.facts);
  node->certificate.valid = node->certificate.valid && nearfield::detail::slopes_fit(table.view);
  return node;
}

inline constexpr std::size_t most_operands = 2 * kGreatestSideCount;

/// What all blends have in common: `evaluated` and `exact` are of the operands' values, in order.
template <class S>
[[gnu::noinline]] std::shared_ptr<CertifiedNode<S>> blended(std::vector<CertifiedField<S>> operands,
                                                            std::function<S(const Value<S>*)> evaluated,
                                                            ExactBlend exact) {
  auto node = std::make_shared<CertifiedNode<S>>();
  for (const CertifiedField<S>& operand : operands) {
    node->depth = std::max(node->depth, operand->depth + 1);
    node->weights += operand->weights;
  }
  node->evaluated = [evaluated = std::move(evaluated), operands](const Vector3<S>& p) {
    Value<S> x[most_operands];
    for (std::size_t i = 0; i < operands.size(); ++i) x[i].value = operands[i]->evaluated(p);
    return evaluated(x);
  };
  node->exact = [exact = std::move(exact), operands = std::move(operands)](const Vec3& p) {
    Real x[most_operands];
    for (std::size_t i = 0; i < operands.size(); ++i) x[i] = operands[i]->exact(p);
    return exact(x);
  };
  return node;
}

template <class S, class Blend>
[[gnu::noinline]] CertifiedField<S> combined(const Blend& blend, const Tabulated<S>& table,
                                             std::vector<CertifiedField<S>> operands, Reach<S> reach,
                                             ExactBlend exact) {
  Certificate<S> of[most_operands];
  for (std::size_t i = 0; i < operands.size(); ++i) of[i] = operands[i]->certificate;
  const auto evaluated = [blend, view = table.view](const Value<S>* x) {
    static_cast<void>(view);
    constexpr int count = nearfield::detail::operand_count_of<Blend>;
    constexpr bool with_table = nearfield::detail::uses_table<Blend>;
    if constexpr (count == kAnyNumber)
      return blend.template combine_all<Value<S>>(x).value;
    else if constexpr (count == 1 && with_table)
      return blend.combine(x[0], view).value;
    else if constexpr (count == 1)
      return blend.combine(x[0]).value;
    else if constexpr (with_table)
      return blend.combine(x[0], x[1], view).value;
    else
      return blend.combine(x[0], x[1]).value;
  };
  const auto node = blended<S>(std::move(operands), evaluated, std::move(exact));
  node->certificate = blend.certificate(of, table.facts, reach);
  node->certificate.valid = node->certificate.valid && nearfield::detail::slopes_fit(table.view);
  return node;
}
template <class S, class Blend>
CertifiedField<S> combined(const Blend& blend, std::vector<CertifiedField<S>> operands, Reach<S> reach,
                           ExactBlend exact) {
  return combined<S>(blend, Tabulated<S>{}, std::move(operands), reach, std::move(exact));
}

/// `inner` was made for inner_reach(), of the rounded pose.
template <class S>
CertifiedField<S> placed(const reference::Pose& pose, Kind kind, CertifiedField<S> inner, Reach<S> outer) {
  const Pose<S> rounded_one = rounded_pose<S>(pose);
  auto node = std::make_shared<CertifiedNode<S>>();
  node->depth = inner->depth;
  node->weights = inner->weights;
  node->certificate = placed_certificate(inner->certificate, kind,
                                         inner_reach(outer, rounded_one.translation), PoseOrigin::constant);
  node->certificate.valid = node->certificate.valid && valid_pose(rounded_one);
  node->evaluated = [rounded_one, inner](const Vector3<S>& p) {
    return inner->evaluated(to_inner(rounded_one, p));
  };
  node->exact = [pose, inner](const Vec3& p) { return inner->exact(reference::to_local(pose, p)); };
  return node;
}

template <class S, Kind kind, SetOperation operation>
CertifiedField<S> sharp(std::vector<CertifiedField<S>> operands, Reach<S> reach) {
  constexpr bool least = (operation == SetOperation::unite) != (kind == Kind::intensity);
  return combined<S>(Sharp<S, operation, kind>{}, std::move(operands), reach,
                     [](const Real* x) { return least ? std::min(x[0], x[1]) : std::max(x[0], x[1]); });
}

/// Trees of one kind of field. A maker tells what its leaves and blends are.
template <class S, Kind kind>
class KindMaker {
 public:
  /// `size`, metres: shapes lie within it about the origin.
  KindMaker(Random& random, Real size) : random_(random), size_(size) {}
  virtual ~KindMaker() = default;

  /// The maker's own blend, of operands that are at most `depth` - 1 blends deep.
  CertifiedField<S> field(int depth, Reach<S> reach) { return own_blend(operands(depth, reach, 0), reach); }
  /// At most `depth` blends deep, these or sharp ones.
  CertifiedField<S> any_field(int depth, Reach<S> reach, int frames = 0) {
    if (random_.chance(0.15L) && frames < 3) {
      const reference::Pose pose = random_.pose(size_ * 0.3L);
      const Reach<S> inner = inner_reach(reach, rounded<S>(pose.translation));
      return placed<S>(pose, kind, any_field(depth, inner, frames + 1), reach);
    }
    if (depth == 0) return leaf_field(reach);
    if (!random_.chance(0.25L)) return own_blend(operands(depth, reach, frames), reach);
    return sharp_blend(operands(depth, reach, frames), reach);
  }

 protected:
  virtual CertifiedField<S> leaf_field(Reach<S> reach) = 0;
  /// Of these two operands, and others if it takes more.
  virtual CertifiedField<S> own_blend(std::vector<CertifiedField<S>> operands, Reach<S> reach) = 0;

  CertifiedField<S> sharp_blend(std::vector<CertifiedField<S>> operands, Reach<S> reach) {
    return random_.chance(0.5L) ? sharp<S, kind, SetOperation::unite>(std::move(operands), reach)
                                : sharp<S, kind, SetOperation::intersect>(std::move(operands), reach);
  }

  Vec3 centre() { return random_.vector(-size_, size_) * 0.55L; }
  Real sign() { return random_.chance(0.5L) ? 1 : -1; }
  template <class Element>
  const Element& one_of(const std::vector<Element>& all) {
    return all[static_cast<std::size_t>(random_.integer(0, static_cast<std::int64_t>(all.size()) - 1))];
  }

  Random& random_;
  Real size_;

 private:
  /// Some operands occur twice: that is where many blends are steepest.
  std::vector<CertifiedField<S>> operands(int depth, Reach<S> reach, int frames) {
    std::vector<CertifiedField<S>> both{any_field(depth - 1, reach, frames)};
    if (random_.chance(0.1L)) {
      both.push_back(both[0]);
    } else {
      both.push_back(any_field(static_cast<int>(random_.integer(0, depth - 1)), reach, frames));
    }
    return both;
  }
};

// Rays
// ---------------------------------------------------------------------------------------------------------

inline Real bounded_ray(Real x) { return std::clamp(x, Real{0}, Real{kGreatestRay}); }

/// A super-ellipsoidal or a scale blend; those of one name are one blend with different parameters.
struct RayProfile {
  std::string name;
  SetOperation operation;
  AnyFunction profile;
  RayFactors both;
  std::function<Real(Real, Real)> exact;  // of a difference: that of the intersection with the complement

  RayFactors factors() const { return both; }
};

inline void add_super_ellipsoids(std::vector<RayProfile>& list, Real n) {
  char exponent[24];
  std::snprintf(exponent, sizeof exponent, ", n = %.3Lg", n);
  const auto united = profile::super_ellipsoidal_union(static_cast<double>(n));
  const auto common = profile::super_ellipsoidal_intersection(static_cast<double>(n));
  const auto exact = [n](Real x, Real y) {
    return reference::super_ellipsoidal_intersection(n, {x, y}).value;
  };
  list.push_back({std::string("super-ellipsoidal union") + exponent, SetOperation::unite, AnyFunction(united),
                  united.factors(), [n](Real x, Real y) {
                    return reference::super_ellipsoidal_union(n, {x, y}).value;
                  }});
  list.push_back({std::string("super-ellipsoidal intersection") + exponent, SetOperation::intersect,
                  AnyFunction(common), common.factors(), exact});
  list.push_back({std::string("super-ellipsoidal difference") + exponent, SetOperation::subtract,
                  AnyFunction(common), common.factors(), exact});
}
inline void add_scale_blends(std::vector<RayProfile>& list, double r1, double r2, double p) {
  const reference::ScaleRanges ranges{static_cast<Real>(r1), static_cast<Real>(r2), static_cast<Real>(p)};
  const auto united = profile::scale_union(r1, r2, p), common = profile::scale_intersection(r1, r2, p);
  list.push_back({"scale union", SetOperation::unite, AnyFunction(united), united.factors(),
                  [ranges](Real x, Real y) { return reference::scale_union_in_closed_form(ranges, x, y); }});
  list.push_back(
      {"scale intersection", SetOperation::intersect, AnyFunction(common), common.factors(),
       [ranges](Real x, Real y) { return reference::scale_intersection_in_closed_form(ranges, x, y); }});
}
inline const std::vector<RayProfile>& ray_profiles() {
  static const std::vector<RayProfile> profiles = [] {
    std::vector<RayProfile> list;
    for (const Real n : {1.0L, 1.5L, 2.0L, 3.0L, 8.0L}) add_super_ellipsoids(list, n);
    for (const auto& [r1, r2] : {std::pair{0.3, 0.3}, {0.95, 0.95}, {0.6, 0.25}, {0.08, 0.9}}) {
      for (const double share : {-3.0, 0.0, 0.5, 0.9}) add_scale_blends(list, r1, r2, share * r1 * r2);
    }
    return list;
  }();
  return profiles;
}

template <class S>
struct RayBlend {
  const RayProfile* profile;
  RaySides<S> sides;
  Tabulated<S> table;
};
template <class S>
const std::vector<RayBlend<S>>& ray_blends() {
  static const std::vector<RayBlend<S>> blends = [] {
    std::vector<RayBlend<S>> list;
    for (const RayProfile& each : ray_profiles()) {
      list.push_back({&each, RaySides<S>::of(each), tabulated<S>(each.profile)});
    }
    return list;
  }();
  return blends;
}

/// Blends of one name, and sharp ones; with "sharp" only these, with "any" all.
template <class S>
class RayMaker : public KindMaker<S, Kind::ray> {
 public:
  using Base = KindMaker<S, Kind::ray>;
  RayMaker(Random& random, Real size, const std::string& name) : Base(random, size) {
    for (const RayBlend<S>& blend : ray_blends<S>()) {
      if (name == "any" || name == blend.profile->name) blends_.push_back(blend);
    }
  }

 protected:
  using Base::random_;
  using Base::size_;

  CertifiedField<S> leaf_field(Reach<S> reach) override {
    const Real radius = std::max(size_ * random_.uniform(0.03L, 0.7L), 1.001L / 64);
    const RayRadius<S> influence(rounded<S>(radius));
    const Vec3 center = Base::centre();
    switch (random_.integer(0, 2)) {
      case 0:
        return leaf<S>(RayPoint<S>{rounded<S>(center), influence}, reach,
                       [=](const Vec3& p) { return bounded_ray(reference::distance(p, center) / radius); });
      case 1: {
        const Vec3 end = center + random_.vector(-size_, size_) * 0.6L;
        const Capsule<S> segment(rounded<S>(center), rounded<S>(end), S{});
        return leaf<S>(RaySegment<S>{segment, influence}, reach, [=](const Vec3& p) {
          return bounded_ray(reference::point_segment_distance(p, {center, end}) / radius);
        });
      }
      default: {
        const Vec3 normal = random_.unit_vector();
        return leaf<S>(
            RayPlane<S>{rounded<S>(center), rounded<Unit<S>>(normal), influence}, reach,
            [=](const Vec3& p) { return bounded_ray(reference::dot(p - center, normal) / radius); });
      }
    }
  }

  CertifiedField<S> own_blend(std::vector<CertifiedField<S>> operands, Reach<S> reach) override {
    if (blends_.empty()) return Base::sharp_blend(std::move(operands), reach);
    const RayBlend<S>& blend = Base::one_of(blends_);
    const auto exact = [f = blend.profile->exact](const Real* x) {
      return bounded_ray(f(bounded_ray(x[0]), bounded_ray(x[1])));
    };
    if (blend.profile->operation == SetOperation::unite) {
      return combined<S>(RayLinearUnion<S>{{blend.sides}}, blend.table, std::move(operands), reach, exact);
    }
    if (blend.profile->operation == SetOperation::intersect) {
      return combined<S>(RayLinearIntersection<S>{{blend.sides}}, blend.table, std::move(operands), reach,
                         exact);
    }
    // As scenes may have them.
    const Real surface = random_.chance(0.2L) ? 0.25L : random_.uniform(0.25L, 1);
    const Real least =
        std::min<Real>(1, surface * (random_.chance(0.3L) ? 0.26L : random_.uniform(0.26L, 4)));
    const RayLinearDifference<S> difference{
        {blend.sides, {rounded<S>(surface * surface), rounded<S>(least)}}};
    return combined<S>(
        difference, blend.table, std::move(operands), reach, [=, f = blend.profile->exact](const Real* x) {
          const Real b = bounded_ray(x[1]), reached = std::max(b, least), value = surface * surface / reached;
          return bounded_ray(f(bounded_ray(x[0]), value + value / reached * (reached - b)));
        });
  }

 private:
  std::vector<RayBlend<S>> blends_;
};

// Algebraic
// ----------------------------------------------------------------------------------------------------

enum class AlgebraicBlend {
  hoffmann_union,
  hoffmann_intersection,
  hoffmann_difference,
  liming,
  functional_spline,
  ribbon_patch,
  corner_patch,
  sharp,
  any
};

/// Hoffmann and Hopcroft's union with the corner's conic in place of their jumps
/// (blend/hoffmann_hopcroft.hpp).
inline Real hoffmann_hopcroft(const reference::ScaleRanges& ranges, Real x, Real y) {
  const auto& [r1, r2, p] = ranges;
  const Real u = std::max(x, Real{0}), v = std::max(y, Real{0}), nearer = std::min(x, y);
  if (!(u / r1 + v / r2 < 1)) return nearer;
  return std::min(nearer,
                  -(r1 + r2) / (2 * (r1 * r2 - p) * r1 * r2) * reference::hoffmann_conic(ranges, u, v));
}

/// One blend, and sharp ones. `size`: no point is farther from the origin.
template <class S>
class AlgebraicMaker : public KindMaker<S, Kind::algebraic> {
 public:
  using Base = KindMaker<S, Kind::algebraic>;
  AlgebraicMaker(Random& random, Real size, AlgebraicBlend blend) : Base(random, size), blend_(blend) {}

 protected:
  using Base::random_;
  using Base::size_;

  CertifiedField<S> leaf_field(Reach<S> reach) override {
    const Real strength = std::exp(random_.uniform(-2, 0.5L));
    switch (random_.integer(0, 4)) {
      case 0: {
        const Vec3 normal = strength * random_.vector(-1, 1);
        const Real offset = random_.uniform(-1, 1) * strength * size_;
        return leaf<S>(AlgebraicPlane<S>{rounded<S>(normal), rounded<S>(offset)}, reach,
                       [=](const Vec3& p) { return reference::dot(normal, p) - offset; });
      }
      case 1: {
        const Vec3 centre = Base::centre();
        const Real radius = size_ * random_.uniform(0.05L, 1), factor = strength * Base::sign();
        const auto ball =
            leaf<S>(Sphere<S>{rounded<S>(centre), rounded<S>(radius)}, reach, [=](const Vec3& p) {
              return reference::signed_distance(reference::Sphere{centre, radius}, p);
            });
        return converted(AlgebraicOfDistance<S>{rounded<S>(factor)}, ball, reach,
                         [factor](const Real* x) { return factor * x[0]; });
      }
      case 2: {
        const Vec3 centre = Base::centre();
        const Real radius = size_ * random_.uniform(0.2L, 1) + 1.001L / 64, level = random_.uniform(0.05L, 1);
        const Real factor = strength * Base::sign() / 2;
        const auto ray =
            leaf<S>(RayPoint<S>{rounded<S>(centre), RayRadius<S>(rounded<S>(radius))}, reach,
                    [=](const Vec3& p) { return bounded_ray(reference::distance(p, centre) / radius); });
        return converted(AlgebraicOfRay<S>{rounded<S>(level), rounded<S>(factor)}, ray, reach,
                         [=](const Real* x) { return factor * (x[0] - level); });
      }
      default:
        return quadric(strength, reach);
    }
  }

  CertifiedField<S> own_blend(std::vector<CertifiedField<S>> operands, Reach<S> reach) override {
    AlgebraicBlend blend = blend_;
    if (blend == AlgebraicBlend::any) {
      blend = static_cast<AlgebraicBlend>(random_.integer(0, static_cast<int>(AlgebraicBlend::any) - 1));
    }
    switch (blend) {
      case AlgebraicBlend::hoffmann_union:
      case AlgebraicBlend::hoffmann_intersection:
      case AlgebraicBlend::hoffmann_difference:
        return conic(blend, std::move(operands), reach);
      case AlgebraicBlend::liming:
        return spline(2, 1, 2, std::move(operands), reach);
      case AlgebraicBlend::functional_spline:
        return spline(static_cast<uint32_t>(random_.integer(1, 3)),
                      static_cast<uint32_t>(random_.integer(1, 2)),
                      static_cast<uint32_t>(random_.integer(1, 4)), std::move(operands), reach);
      case AlgebraicBlend::ribbon_patch:
        return patch<RibbonPatch<S>>(2, std::move(operands), reach);
      case AlgebraicBlend::corner_patch:
        return patch<CornerPatch<S>>(3, std::move(operands), reach);
      default:
        return Base::sharp_blend(std::move(operands), reach);
    }
  }

 private:
  template <class Conversion>
  CertifiedField<S> converted(const Conversion& conversion, const CertifiedField<S>& operand, Reach<S> reach,
                              ExactBlend exact) {
    auto node =
        std::make_shared<CertifiedNode<S>>(*combined<S>(conversion, {operand}, reach, std::move(exact)));
    node->depth = 0;
    return node;
  }

  CertifiedField<S> quadric(Real strength, Reach<S> reach) {
    const Vec3 d = strength * random_.vector(-1, 1), o = strength * random_.vector(-1, 1);
    const Vec3 linear = strength * size_ * random_.vector(-1, 1);
    const Real constant = strength * size_ * size_ * random_.uniform(-1, 1);
    const Quadric<S> quadric{rounded<S>(d), rounded<S>(o), rounded<S>(linear), rounded<S>(constant)};
    return leaf<S>(quadric, reach, [=](const Vec3& p) {
      const Vec3 bent{d.x * p.x + o.z * p.y + o.y * p.z, o.z * p.x + d.y * p.y + o.x * p.z,
                      o.y * p.x + o.x * p.y + d.z * p.z};
      return reference::dot(p, bent + linear) + constant;
    });
  }

  CertifiedField<S> conic(AlgebraicBlend blend, std::vector<CertifiedField<S>> operands, Reach<S> reach) {
    const Real size =
        std::max(real(operands[0]->certificate.magnitude), real(operands[1]->certificate.magnitude));
    const Real most = real(ScalarTraits<S>::domain()) * 0.999L;
    const Real r1 = std::min(most, size * random_.uniform(0.05L, 1));
    const Real r2 = std::min(most, r1 * std::exp(random_.uniform(-1.2L, 1.2L)));
    const Real flat = random_.chance(0.5L) ? random_.uniform(0.126L, 1) : random_.uniform(1, 3.9L);
    const reference::ScaleRanges ranges{r1, r2, (1 - flat) * r1 * r2};
    const S first = rounded<S>(r1), second = rounded<S>(r2), shape = rounded<S>(1 - flat);
    if (blend == AlgebraicBlend::hoffmann_union) {
      return combined<S>(HoffmannHopcroftUnion<S>::of(first, second, shape), std::move(operands), reach,
                         [ranges](const Real* x) { return hoffmann_hopcroft(ranges, x[0], x[1]); });
    }
    if (blend == AlgebraicBlend::hoffmann_intersection) {
      return combined<S>(HoffmannHopcroftIntersection<S>::of(first, second, shape), std::move(operands),
                         reach, [ranges](const Real* x) { return -hoffmann_hopcroft(ranges, -x[0], -x[1]); });
    }
    return combined<S>(HoffmannHopcroftDifference<S>::of(first, second, shape), std::move(operands), reach,
                       [ranges](const Real* x) { return -hoffmann_hopcroft(ranges, -x[0], x[1]); });
  }

  CertifiedField<S> spline(uint32_t primary_count, uint32_t bound_count, uint32_t exponent,
                           std::vector<CertifiedField<S>> operands, Reach<S> reach) {
    const Real lambda = random_.uniform(0.05L, 1) * Base::sign();
    complete(operands, primary_count + bound_count, reach);
    const FunctionalSpline<S> blend{primary_count, bound_count, exponent, rounded<S>(lambda)};
    return combined<S>(blend, std::move(operands), reach, [=](const Real* x) {
      const Real* end = x + primary_count;
      const Real bounds = reference::product_of({end, end + bound_count});
      return (1 - lambda) * reference::product_of({x, end}) +
             lambda * std::pow(bounds, static_cast<Real>(exponent));
    });
  }

  template <class Patch>
  CertifiedField<S> patch(std::int64_t fewest, std::vector<CertifiedField<S>> operands, Reach<S> reach) {
    constexpr bool with_ribbons = std::is_same_v<Patch, RibbonPatch<S>>;
    const auto count = static_cast<std::size_t>(random_.integer(fewest, 5));
    reference::PatchCoefficients w;
    Patch blend;
    blend.side_count = static_cast<uint32_t>(count);
    w.exponent = static_cast<int>(random_.integer(2, 3));
    blend.exponent = static_cast<uint32_t>(w.exponent);
    for (std::size_t i = 0; i < count; ++i) {
      w.side.push_back(random_.uniform(-1, 1));
      blend.side_weight[i] = rounded<S>(w.side[i]);
    }
    w.bound = random_.uniform(-1, 1);
    blend.centre_weight = rounded<S>(w.bound);
    complete(operands, 2 * count, reach);
    return combined<S>(blend, std::move(operands), reach, [=](const Real* x) {
      std::vector<Real> primaries, bounds;
      for (std::size_t i = 0; i < count; ++i) {
        primaries.push_back(with_ribbons ? x[2 * i] : x[i]);
        bounds.push_back(with_ribbons ? x[2 * i + 1] : x[count + i]);
      }
      return with_ribbons ? reference::ribbon_patch(w, primaries, bounds).value
                          : reference::corner_patch(w, primaries, bounds).value;
    });
  }

  void complete(std::vector<CertifiedField<S>>& operands, std::size_t count, Reach<S> reach) {
    while (operands.size() < count) operands.push_back(leaf_field(reach));
    std::swap(operands.back(), operands[1]);  // the second one may be deep too: sometimes a bound
  }

  AlgebraicBlend blend_;
};

// Intensities
// --------------------------------------------------------------------------------------------------

struct SoftCurve {
  AnyFunction over_range;
  AnyFunction over_square;
  reference::PotentialFunction exact;
  double to;
};
template <class Curve>
SoftCurve soft_curve(const Curve& curve, const reference::PotentialFunction& exact) {
  return {AnyFunction(over_range(curve)), AnyFunction(over_square(curve)), exact, curve.facts().to};
}
inline const std::vector<SoftCurve>& soft_curves() {
  using potential::with_range_control;
  using reference::RemappedCurve;
  static const std::vector<SoftCurve> curves = {
      soft_curve(potential::Cubic{}, reference::CubicCurve{}),
      soft_curve(potential::wyvill, reference::WyvillCurve{}),
      soft_curve(potential::Wyvill{0.3, 0.7},
                 reference::WyvillCurve{static_cast<Real>(0.3), static_cast<Real>(0.7)}),
      soft_curve(potential::Blanc{1.0}, reference::BlancCurve(1)),
      soft_curve(potential::ArctangentClamped{10.0, 0.5}, reference::ArctangentCurve::clamped(10, 0.5L)),
      soft_curve(with_range_control(potential::wyvill, 0.5, 0.25),
                 RemappedCurve<reference::WyvillCurve>({0.5L, 0.25L}, {})),
      soft_curve(with_range_control(potential::Cubic{}, 2.0, 0.75),
                 RemappedCurve<reference::CubicCurve>({2, 0.75L}, {}))};
  return curves;
}

template <class S>
struct SoftPotential {
  Tabulated<S> over_square;  // of potentials that end at 1
  Tabulated<S> over_range;
  reference::PotentialFunction exact;
  Real to = 1;
};

template <class S>
const std::vector<SoftPotential<S>>& soft_potentials() {
  static const std::vector<SoftPotential<S>> potentials = [] {
    std::vector<SoftPotential<S>> list;
    for (const SoftCurve& curve : soft_curves()) {
      const bool ends_at_one = !(curve.to > 1.0) && !(curve.to < 1.0);
      list.push_back({ends_at_one ? tabulated<S>(curve.over_square, true) : Tabulated<S>{},
                      tabulated<S>(curve.over_range, true), curve.exact, static_cast<Real>(curve.to)});
    }
    return list;
  }();
  return potentials;
}

enum class SoftLeaf { point, segment, of_distance, of_ray, any };
enum class SoftBlend { sum, unite, intersect, any };

template <class S>
class IntensityMaker : public KindMaker<S, Kind::intensity> {
 public:
  using Base = KindMaker<S, Kind::intensity>;
  IntensityMaker(Random& random, Real size, SoftLeaf leaf, SoftBlend blend)
      : Base(random, size), leaf_(leaf), blend_(blend) {}

 protected:
  using Base::random_;
  using Base::size_;

  CertifiedField<S> leaf_field(Reach<S> reach) override {
    const Real weight = random_.chance(0.3L) ? random_.uniform(-1, 0) : random_.uniform(0, 1.5L);
    auto node = std::make_shared<CertifiedNode<S>>(*weighted_leaf(weight, reach));
    node->depth = 0;
    node->weights = std::fabs(weight);
    return node;
  }

  CertifiedField<S> own_blend(std::vector<CertifiedField<S>> operands, Reach<S> reach) override {
    const SoftBlend blend = blend_ == SoftBlend::any ? static_cast<SoftBlend>(random_.integer(0, 2)) : blend_;
    if (blend == SoftBlend::sum) {
      return combined<S>(SoftSum<S>{}, std::move(operands), reach, [](const Real* x) { return x[0] + x[1]; });
    }
    return blend == SoftBlend::unite
               ? sharp<S, Kind::intensity, SetOperation::unite>(std::move(operands), reach)
               : sharp<S, Kind::intensity, SetOperation::intersect>(std::move(operands), reach);
  }

 private:
  CertifiedField<S> weighted_leaf(Real weight, Reach<S> reach) {
    const SoftLeaf kind = leaf_ == SoftLeaf::any ? static_cast<SoftLeaf>(random_.integer(0, 3)) : leaf_;
    const SoftPotential<S>& potential = Base::one_of(soft_potentials<S>());
    const auto spread = [weight, f = potential.exact](Real r) { return weight * f(r).value; };
    if (kind == SoftLeaf::of_distance) {
      const Real radius = std::max(size_ * random_.uniform(0.05L, 0.7L), 0.02L),
                 limit = radius * potential.to;
      const CertifiedField<S> solid = random_.chance(0.5L) ? distance(reach) : group(reach);
      return combined<S>(PotentialOfDistance<S>(rounded<S>(limit), rounded<S>(weight), solid->certificate),
                         potential.over_range, {solid}, reach,
                         [=](const Real* x) { return spread(x[0] / radius); });
    }
    if (kind == SoftLeaf::of_ray) {
      const CertifiedField<S> ray =
          RayMaker<S>(random_, size_, "any").any_field(static_cast<int>(random_.integer(0, 2)), reach);
      return combined<S>(PotentialOfRay<S>(rounded<S>(potential.to), rounded<S>(weight), ray->certificate),
                         potential.over_range, {ray}, reach, [=](const Real* x) { return spread(x[0]); });
    }
    if (potential.over_square.view.coefficients == nullptr) return weighted_leaf(weight, reach);
    const Real radius = std::max(size_ * random_.uniform(0.05L, 0.7L), 0.07L);
    const Influence<S> influence(rounded<S>(radius), rounded<S>(weight));
    const Vec3 centre = Base::centre();
    if (kind == SoftLeaf::point) {
      return leaf<S>(SoftPoint<S>{rounded<S>(centre), influence}, potential.over_square, reach,
                     [=](const Vec3& p) { return spread(reference::distance(p, centre) / radius); });
    }
    const Vec3 end = centre + random_.vector(-size_, size_) * 0.6L;
    return leaf<S>(SoftSegment<S>{Capsule<S>(rounded<S>(centre), rounded<S>(end), S{}), influence},
                   potential.over_square, reach, [=](const Vec3& p) {
                     return spread(reference::point_segment_distance(p, {centre, end}) / radius);
                   });
  }

  CertifiedField<S> distance(Reach<S> reach) {
    const Vec3 centre = Base::centre();
    const Real part = size_ * random_.uniform(0.02L, 0.5L);
    if (random_.chance(0.5L)) {
      return leaf<S>(Sphere<S>{rounded<S>(centre), rounded<S>(part)}, reach, [=](const Vec3& p) {
        return reference::signed_distance(reference::Sphere{centre, part}, p);
      });
    }
    const Vec3 half = random_.vector(0.1L, 1) * part;
    return leaf<S>(Box<S>{rounded<S>(centre), rounded<S>(half)}, reach, [=](const Vec3& p) {
      return reference::signed_distance(reference::Box{centre, half}, p);
    });
  }
  CertifiedField<S> group(Reach<S> reach) {
    return combined<S>(SharpUnion<S>{}, {distance(reach), distance(reach)}, reach,
                       [](const Real* x) { return std::min(x[0], x[1]); });
  }

  SoftLeaf leaf_;
  SoftBlend blend_;
};

}  // namespace nearfield::property
