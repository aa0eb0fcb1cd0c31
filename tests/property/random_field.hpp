#pragma once
/// Random distance fields, built at the same time as a program image and as a tree of the reference.

#include <nearfield/curve/kernel.hpp>
#include <nearfield/field/builder.hpp>
#include <nearfield/field/program.hpp>

#include "property/conversion.hpp"
#include "reference/field.hpp"
#include "reference/random.hpp"

#include <algorithm>
#include <array>
#include <memory>
#include <utility>
#include <vector>

namespace nearfield::property {

/// Li's exterior blends with H_order, epsilon / delta = ratio.
template <class S>
struct BlendKernel {
  int order;
  Real ratio;
  Table<S, 32> table;
};

template <class S>
const std::array<BlendKernel<S>, 6>& blend_kernels() {
  static const std::array<BlendKernel<S>, 6> kernels = {{
      {1, 0.25L, bake<S>(exterior(step::polynomial<1>, 0.25))},
      {1, 1, bake<S>(exterior(step::polynomial<1>, 1.0))},
      {2, 0.25L, bake<S>(exterior(step::polynomial<2>, 0.25))},
      {2, 1, bake<S>(exterior(step::polynomial<2>, 1.0))},
      {3, 0.25L, bake<S>(exterior(step::polynomial<3>, 0.25))},
      {3, 1, bake<S>(exterior(step::polynomial<3>, 1.0))},
  }};
  return kernels;
}

/// What a random field may hold.
struct FieldTaste {
  int greatest_depth = 5;
  bool unions_only = false;
  bool sharp_only = false;
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
        kernels_[i] = &blend_kernels<S>()[static_cast<std::size_t>(random_.integer(0, 5))];
        tables_[i] = image_.table(kernels_[i]->table);
      }
    }
    field_.node = node(static_cast<int>(random_.integer(0, taste_.greatest_depth)), 0);
  }

 private:
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
      const reference::UnitStep step{reference::StepKind::polynomial, kernel.order, 0};
      blend = reference::exterior_blend(step, delta, delta * kernel.ratio);
      const ArgumentScale<S> scale =
          ArgumentScale<S>::of(narrow<S>(product(rounded<S>(delta), kernel.table.range)));
      if (operation == 0) image_.operation(AdditiveUnion<S>{scale}, tables_[which]);
      if (operation == 1) image_.operation(AdditiveIntersection<S>{scale}, tables_[which]);
      if (operation == 2) image_.operation(AdditiveSubtraction<S>{scale}, tables_[which]);
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
