#pragma once
/// Random distance fields, built at the same time as a program image and as a tree of the reference.

#include <nearfield/curve/kernel.hpp>
#include <nearfield/field/builder.hpp>
#include <nearfield/field/program.hpp>

#include "property/conversion.hpp"
#include "reference/additive_blends.hpp"
#include "reference/field.hpp"
#include "reference/random.hpp"
#include "reference/step_curves.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <memory>
#include <utility>
#include <vector>

namespace nearfield::property {

/// What one kernel's table stands for: the smooth maximum of a length in metres.
enum class BlendFamily {
  exterior, two_sided_exterior, interior, two_sided_interior, log_sum_exp, quadratic, cubic, log_sum_exp_of_any, count
};
inline const char* family_name(BlendFamily family) {
  constexpr const char* names[] = {"exterior", "exterior, two-sided", "interior", "interior, two-sided",
                                   "log-sum-exp", "quadratic", "cubic", "log-sum-exp of any number"};
  return names[static_cast<std::size_t>(family)];
}

template <class S>
struct BlendKernel {
  BlendFamily family;
  int order;  // the n of the H_n in it, 3 for kernels at least as smooth
  std::function<reference::Blend(Real length)> exact;
  Table<S, 32> table;
  Sides sides = Sides::alike;
};

template <class S>
const std::vector<BlendKernel<S>>& blend_kernels() {
  static const std::vector<BlendKernel<S>> kernels = [] {
    std::vector<BlendKernel<S>> list;
    const auto add_exterior = [&list](int order, double ratio) {
      const reference::UnitStep step{reference::StepKind::polynomial, order, 0};
      list.push_back({BlendFamily::exterior, order,
                      [=](Real delta) { return reference::exterior_blend(step, delta, delta * static_cast<Real>(ratio)); },
                      bake<S>(exterior(step::Polynomial{order}, ratio))});
    };
    for (const int order : {1, 2, 3}) {
      for (const double ratio : {0.25, 1.0}) add_exterior(order, ratio);
    }
    const auto steep = reference::step_with_slope(reference::RisingCutoffCurve(2));
    for (const double ratio : {0.5, 1.0}) {
      list.push_back({BlendFamily::two_sided_exterior, 3,
                      [=](Real delta) {
                        return reference::custom_blend([=](Real x, Real y) {
                          return reference::exterior_maximum_point(steep, delta, delta * static_cast<Real>(ratio), x, y);
                        });
                      },
                      bake<S>(two_sided(exterior(step::RisingCutoff{2}, ratio))), Sides::differ});
    }
    for (const int order : {2, 3}) {
      const reference::UnitStep step{reference::StepKind::polynomial, order, 0};
      list.push_back({BlendFamily::interior, order, [=](Real epsilon) { return reference::interior_blend(step, epsilon); },
                      bake<S>(interior(step::Polynomial{order}))});
    }
    list.push_back({BlendFamily::two_sided_interior, 3,
                    [=](Real epsilon) {
                      return reference::custom_blend(
                          [=](Real x, Real y) { return reference::interior_maximum_point(steep, epsilon, x, y); });
                    },
                    bake<S>(two_sided(interior(step::RisingCutoff{2}))), Sides::differ});
    list.push_back({BlendFamily::log_sum_exp, 3,
                    [](Real range) {
                      return reference::custom_blend(
                          [=](Real x, Real y) { return reference::log_sum_exp_point(18 / range, x, y); });
                    },
                    bake<S>(LogSumExpKernel{})});
    const auto polynomial = [](auto minimum) {
      return [minimum](Real k) {
        return reference::custom_blend([=](Real x, Real y) {
          const reference::BlendPoint point = minimum(k, -x, -y);
          return reference::BlendPoint{-point.value, point.by_x, point.by_y};
        });
      };
    };
    list.push_back({BlendFamily::quadratic, 3, polynomial(reference::quadratic_minimum_point), bake<S>(QuadraticKernel{})});
    list.push_back({BlendFamily::cubic, 3, polynomial(reference::cubic_minimum_point), bake<S>(CubicKernel{})});
    // Has no table of its own: this one is not used.
    list.push_back({BlendFamily::log_sum_exp_of_any, 3,
                    [](Real range) {
                      return reference::custom_blend([=](Real x, Real y) {
                        return reference::log_sum_exp_point(32 * std::log(Real{2}) / range, x, y);
                      });
                    },
                    bake<S>(QuadraticKernel{})});
    return list;
  }();
  return kernels;
}

/// What a random field may hold.
struct FieldTaste {
  int greatest_depth = 5;
  bool unions_only = false;
  bool sharp_only = false;
  BlendFamily family = BlendFamily::exterior;  // count: any
  bool slots = true;
  Real size = 1;  // metres: centres within size, shapes and blend radii a part of it
};

/// A field, its image (which the program refers to) and the poses of its slots.
template <class S>
struct RandomField {
  std::unique_ptr<ImageBuilder<S, 4096>> image = std::make_unique<ImageBuilder<S, 4096>>();
  Program<S> program;
  reference::Node node;
  std::vector<Pose<S>> slots;
  int lowest_order = 9;     // the least n of the H_n of its blends; 9 if all blends are sharp
  bool unions_only = true;  // no intersection or subtraction in it
};

namespace detail {

template <class S>
class FieldMaker {
 public:
  FieldMaker(reference::Random& random, const FieldTaste& taste, RandomField<S>& field)
      : random_(random), taste_(taste), field_(field), image_(*field.image) {}

  void make() {
    if (!taste_.sharp_only) {
      for (std::size_t i = 0; i < kernels_.size(); ++i) {
        kernels_[i] = &random_kernel();
        tables_[i] = image_.table(kernels_[i]->table);
      }
    }
    field_.node = node(static_cast<int>(random_.integer(0, taste_.greatest_depth)), 0);
  }

 private:
  const BlendKernel<S>& random_kernel() {
    const std::vector<BlendKernel<S>>& all = blend_kernels<S>();
    for (;;) {
      const BlendKernel<S>& kernel = all[static_cast<std::size_t>(random_.integer(0, static_cast<std::int64_t>(all.size()) - 1))];
      if (taste_.family == BlendFamily::count || taste_.family == kernel.family) return kernel;
    }
  }

  reference::Node node(int depth, int frames) {
    if (depth == 0) return random_.chance(0.15L) && frames < 3 ? framed(0, frames) : leaf();
    if (random_.chance(0.2L) && frames < 3) return framed(depth - 1, frames);
    reference::Node first = node(depth - 1, frames);
    reference::Node second = node(static_cast<int>(random_.integer(0, depth - 1)), frames);
    return combined(std::move(first), std::move(second));
  }

  reference::Node leaf() {
    const Real part = taste_.size * random_.uniform(0.02L, 0.5L);
    const reference::Vec3 center = random_.vector(-taste_.size, taste_.size) * 0.55L;
    switch (random_.integer(0, 4)) {
      case 0:
        image_.operation(Sphere<S>{rounded<S>(center), rounded<S>(part)});
        return reference::sphere(center, part);
      case 1: {
        const Real reach = random_.chance(0.2L) ? taste_.size * 1e-4L : taste_.size * 0.6L;
        const reference::Vec3 end = random_.chance(0.05L) ? center : center + random_.vector(-reach, reach);
        image_.operation(Capsule<S>(rounded<S>(center), rounded<S>(end), rounded<S>(part / 3)));
        return reference::capsule(center, end, part / 3);
      }
      case 2: {
        const reference::Vec3 half_edges = random_.vector(0.1L, 1) * part;
        image_.operation(Box<S>{rounded<S>(center), rounded<S>(half_edges)});
        return reference::box(center, half_edges);
      }
      default: {
        const Real half_height = part * random_.uniform(0.1L, 1);
        image_.operation(Cylinder<S>{rounded<S>(center), rounded<S>(part), rounded<S>(half_height)});
        return reference::cylinder(center, part, half_height);
      }
    }
  }

  reference::Node framed(int depth, int frames) {
    const reference::Pose pose = random_.pose(taste_.size * 0.3L);
    if (taste_.slots && frames == 0 && random_.chance(0.5L)) {
      image_.enter_slot(static_cast<uint32_t>(field_.slots.size()));
      field_.slots.push_back(run_time_pose(pose));
    } else {
      image_.enter(rounded_pose<S>(pose));
    }
    reference::Node inner = node(depth, frames + 1);
    image_.leave();
    return reference::placed(pose, std::move(inner));
  }

  // As far from a rotation as valid_pose() lets pass, in half of all cases: stretched and sheared.
  Pose<S> run_time_pose(const reference::Pose& pose) {
    const Pose<S> precise = rounded_pose<S>(pose);
    if (random_.chance(0.5L)) return precise;
    const Real unit = ScalarTraits<S>::is_fixed ? std::ldexp(Real{1}, -30) : std::ldexp(Real{1}, -19) / 32;
    reference::Mat3 stretch;
    for (std::size_t row = 0; row < 3; ++row) {
      for (std::size_t column = row; column < 3; ++column) {
        const Real entry = random_.uniform(-1, 1) * unit * (row == column ? 31 : 15);
        stretch(row, column) += entry;
        if (row != column) stretch(column, row) += entry;
      }
    }
    Pose<S> bent = precise;
    bent.rotation = rounded_rotation<S>(stretch * pose.rotation);
    return valid_pose(bent) ? bent : precise;
  }

  reference::Node combined(reference::Node first, reference::Node second) {
    const std::int64_t operation = taste_.unions_only ? 0 : std::max<std::int64_t>(0, random_.integer(-1, 2));
    if (operation != 0) field_.unions_only = false;
    reference::Blend blend;
    if (taste_.sharp_only || random_.chance(0.4L)) {
      if (operation == 0) image_.operation(SharpUnion<S>{});
      if (operation == 1) image_.operation(SharpIntersection<S>{});
      if (operation == 2) image_.operation(SharpSubtraction<S>{});
    } else {
      const std::size_t which = static_cast<std::size_t>(random_.integer(0, 1));
      const BlendKernel<S>& kernel = *kernels_[which];
      field_.lowest_order = std::min(field_.lowest_order, kernel.order);
      const Real delta = taste_.size * (random_.chance(0.5L) ? 0.05L : random_.uniform(0.001L, 0.4L));
      blend = kernel.exact(delta);
      const ArgumentScale<S> scale =
          ArgumentScale<S>::of(narrow<S>(product(rounded<S>(delta), kernel.table.range)));
      if (kernel.family == BlendFamily::log_sum_exp_of_any) {
        if (operation == 0) image_.operation(LogSumExpUnion<S>{scale, 2});
        if (operation == 1) image_.operation(LogSumExpIntersection<S>{scale, 2});
        if (operation == 2) image_.operation(LogSumExpSubtraction<S>{scale, 2});
      } else if (kernel.sides == Sides::alike) {
        if (operation == 0) image_.operation(AdditiveUnion<S>{scale}, tables_[which]);
        if (operation == 1) image_.operation(AdditiveIntersection<S>{scale}, tables_[which]);
        if (operation == 2) image_.operation(AdditiveSubtraction<S>{scale}, tables_[which]);
      } else {
        if (operation == 0) image_.operation(TwoSidedUnion<S>{scale}, tables_[which]);
        if (operation == 1) image_.operation(TwoSidedIntersection<S>{scale}, tables_[which]);
        if (operation == 2) image_.operation(TwoSidedSubtraction<S>{scale}, tables_[which]);
      }
    }
    std::vector<reference::Node> operands;
    operands.push_back(std::move(first));
    operands.push_back(std::move(second));
    if (operation == 0) return reference::unite(blend, std::move(operands));
    if (operation == 1) return reference::intersect(blend, std::move(operands));
    return reference::subtract(blend, std::move(operands));
  }

  reference::Random& random_;
  const FieldTaste& taste_;
  RandomField<S>& field_;
  ImageBuilder<S, 4096>& image_;
  std::array<const BlendKernel<S>*, 2> kernels_{};
  std::array<uint32_t, 2> tables_{};
};

}  // namespace detail

/// A loaded field. Draws again when an image is refused because its shapes and frames reach out of range;
/// gives up, with a field whose program is not valid, after 100 refusals.
template <class S>
RandomField<S> random_field(reference::Random& random, FieldTaste taste) {
  for (int attempt = 0; attempt < 100; ++attempt) {
    RandomField<S> field;
    detail::FieldMaker<S>(random, taste, field).make();
    const Inspection<S> built = field.image->finish();
    field.program = load<S>(field.image->words(), field.image->size() * sizeof(uint32_t));
    if (built.status == LoadStatus::ok && field.program.valid()) return field;
    if (built.status != LoadStatus::parameter_out_of_range) return field;
    taste.size *= 0.8L;
  }
  return {};
}

}  // namespace nearfield::property
