#include "compile/field_compiler.hpp"

#include <algorithm>
#include <map>
#include <memory>
#include <stdexcept>
#include <utility>

#include <nearfield/curve/kernel.hpp>
#include <nearfield/curve/potential.hpp>
#include <nearfield/curve/tabulated_form.hpp>
#include <nearfield/field/builder.hpp>

#include "compile/quantise.hpp"
#include "text/input_error.hpp"

namespace nearfield::host {
namespace {

constexpr std::uint32_t largest_image = 1U << 14U;  // words

bool is_rotated(const Placement& placement) { return placement.rotation != Placement{}.rotation; }

std::string reason(LoadStatus status) {
  switch (status) {
    case LoadStatus::wrong_size: return "the field is too large";
    case LoadStatus::stack_too_deep: return "operands are nested too deeply";
    case LoadStatus::frames_too_deep: return "placements are nested too deeply";
    case LoadStatus::bad_table: return "the blend is too steep for its table";
    default: return "a size or position does not fit the number range";
  }
}

template <class S> class FieldCompiler {
 public:
  FieldCompiler(std::string file, const SlotOfLink& slot_of_link)
      : file_(std::move(file)), slot_of_link_(slot_of_link), builder_(std::make_unique<Builder>()) {}

  CompiledField<S> compile(const FieldNode& root) {
    add_tables(root);
    add(root);
    return finish(root);
  }

  CompiledField<S> compile(const std::vector<CollisionShape>& solids, const std::string& path) {
    std::vector<std::uint32_t> starts;
    for (std::size_t i = 0; i < solids.size(); ++i) {
      starts.push_back(builder_->size());
      place(solids[i].origin, [&](const Vector3d& at) { add_solid(solids[i], at); });
      if (i != 0) builder_->operation(SharpUnion<S>{});
    }
    CompiledField<S> compiled;
    compiled.inspection = builder_->finish();
    if (compiled.inspection.status != LoadStatus::ok) {
      const auto after = std::upper_bound(starts.begin() + 1, starts.end(), compiled.inspection.at_word);
      const auto culprit = static_cast<std::size_t>(after - starts.begin()) - 1;
      fail(solids[culprit].position, path + "[" + std::to_string(culprit) + "]", compiled.inspection.status);
    }
    return with_image(std::move(compiled));
  }

 private:
  using Builder = ImageBuilder<S, largest_image>;

  CompiledField<S> finish(const FieldNode& root) {
    CompiledField<S> compiled;
    compiled.inspection = builder_->finish();
    if (compiled.inspection.status != LoadStatus::ok) {
      // The node whose operation was being added when the image grew past the failing word.
      const FieldNode* culprit = &root;
      for (const auto& [word, node] : added_) {
        if (word <= compiled.inspection.at_word) culprit = node;
      }
      fail(culprit->position, culprit->path, compiled.inspection.status);
    }
    return with_image(std::move(compiled));
  }

  [[noreturn]] void fail(SourcePosition position, const std::string& path, LoadStatus status) const {
    throw InputError(file_, position, path, reason(status),
                     "everything must lie within " +
                         std::to_string(ScalarTraits<S>::to_double(ScalarTraits<S>::domain())) +
                         " m of its frame's origin, " + std::to_string(kStackDepth) + " operands and " +
                         std::to_string(kFrameDepth) + " frames deep");
  }

  CompiledField<S> with_image(CompiledField<S> compiled) const {
    compiled.image.assign(builder_->words(), builder_->words() + builder_->size());
    return compiled;
  }

  // Tables come first in an image: one for each different curve.
  void add_tables(const FieldNode& node) {
    if (const auto step = node.choices.find("step"); step != node.choices.end()) {
      const auto key = std::make_pair(step->second, ratio_of(node));
      if (kernels_.count(key) == 0) kernels_[key] = bake_kernel(key.first, key.second);
    }
    if (node.choices.count("potential") != 0 && potential_ == 0) {
      potential_ = builder_->table(bake<S, 2>(over_square(potential::wyvill)));
    }
    for (const FieldNode& operand : node.operands) add_tables(operand);
  }
  static double ratio_of(const FieldNode& node) { return node.number("rising_range") / node.number("blend_radius"); }

  struct Kernel {
    std::uint32_t reference = 0;
    S range{};  // per blend radius
  };
  template <class Step> Kernel bake_steps(Step step, double ratio) {
    const Table<S, 64> table = bake<S, 64>(exterior(step, ratio));
    return {builder_->table(table), table.range};
  }
  Kernel bake_kernel(const std::string& step, double ratio) {
    if (step == "polynomial1") return bake_steps(step::polynomial<1>, ratio);
    if (step == "polynomial2") return bake_steps(step::polynomial<2>, ratio);
    return bake_steps(step::polynomial<3>, ratio);
  }

  // Adds what `shape` adds at a place: shifted where that is enough, otherwise in a frame of its own.
  template <class Shape> void place(const Placement& placement, const Shape& shape) {
    if (!is_rotated(placement)) return shape(placement.position);
    builder_->enter(quantise<S>(placement));
    shape(Vector3d{});
    builder_->leave();
  }

  void add_solid(const CollisionShape& solid, const Vector3d& at) {
    const nearfield::Vector3<S> center = quantise<S>(at);
    const Vector3d half{0.0, 0.0, 0.5 * solid.length};
    switch (solid.kind) {
      case CollisionKind::sphere: builder_->operation(Sphere<S>{center, quantise<S>(solid.radius)}); break;
      case CollisionKind::box: builder_->operation(Box<S>{center, quantise<S>(0.5 * solid.size)}); break;
      case CollisionKind::cylinder:
        builder_->operation(Cylinder<S>{center, quantise<S>(solid.radius), quantise<S>(0.5 * solid.length)});
        break;
      case CollisionKind::capsule:
        builder_->operation(quantise_capsule<S>(at - half, at + half, solid.radius));
        break;
    }
  }

  void add(const FieldNode& node) {
    added_.emplace_back(builder_->size(), &node);
    if (node.link) builder_->enter_slot(slot_of_link_(node, *node.link));
    if (node.operands.empty()) add_shape(node);
    else if (node.operator_->name == "place") place_operand(node);
    else add_blend(node);
    if (node.link) builder_->leave();
  }

  void place_operand(const FieldNode& node) {
    builder_->enter(quantise<S>(node.placement));
    add(node.operands.front());
    builder_->leave();
  }

  void add_shape(const FieldNode& node) {
    const std::string_view name = node.operator_->name;
    const auto end = [&node](const char* key) { return transform_point(node.placement, node.vector(key)); };
    const auto influence = [&node] {
      return Influence<S>(quantise<S>(node.number("influence_radius")), quantise<S>(node.number("weight")));
    };
    if (name == "sphere") {
      builder_->operation(Sphere<S>{quantise<S>(node.placement.position), quantise<S>(node.number("radius"))});
    } else if (name == "capsule") {
      builder_->operation(quantise_capsule<S>(end("from"), end("to"), node.number("radius")));
    } else if (name == "box") {
      place(node.placement, [&](const Vector3d& at) {
        builder_->operation(Box<S>{quantise<S>(at), quantise<S>(0.5 * node.vector("size"))});
      });
    } else if (name == "cylinder") {
      place(node.placement, [&](const Vector3d& at) {
        builder_->operation(Cylinder<S>{quantise<S>(at), quantise<S>(node.number("radius")),
                                        quantise<S>(0.5 * node.number("height"))});
      });
    } else if (name == "soft_point") {
      builder_->operation(SoftPoint<S>{quantise<S>(node.placement.position), influence()}, potential_);
    } else if (name == "soft_segment") {
      builder_->operation(SoftSegment<S>{quantise_capsule<S>(end("from"), end("to"), 0.0), influence()}, potential_);
    } else {
      throw std::logic_error("an operator of the scene format without an operation");
    }
  }

  void add_blend(const FieldNode& node) {
    for (std::size_t i = 0; i < node.operands.size(); ++i) {
      add(node.operands[i]);
      added_.emplace_back(builder_->size(), &node);
      if (i != 0) add_blend_operation(node);
    }
  }
  void add_blend_operation(const FieldNode& node) {
    const std::string_view name = node.operator_->name;
    if (name == "union") builder_->operation(SharpUnion<S>{});
    else if (name == "intersection") builder_->operation(SharpIntersection<S>{});
    else if (name == "subtraction") builder_->operation(SharpSubtraction<S>{});
    else if (name == "soft_sum") builder_->operation(SoftSum<S>{});
    else if (name == "exterior_union") add_exterior<AdditiveUnion<S>>(node);
    else if (name == "exterior_intersection") add_exterior<AdditiveIntersection<S>>(node);
    else if (name == "exterior_subtraction") add_exterior<AdditiveSubtraction<S>>(node);
    else throw std::logic_error("an operator of the scene format without an operation");
  }
  template <class Blend> void add_exterior(const FieldNode& node) {
    const Kernel& kernel = kernels_.at({node.choices.at("step"), ratio_of(node)});
    Blend blend;
    blend.scale = ArgumentScale<S>::of(narrow<S>(product(quantise<S>(node.number("blend_radius")), kernel.range)));
    builder_->operation(blend, kernel.reference);
  }

  std::string file_;
  const SlotOfLink& slot_of_link_;
  std::unique_ptr<Builder> builder_;
  std::map<std::pair<std::string, double>, Kernel> kernels_;
  std::uint32_t potential_ = 0;
  std::vector<std::pair<std::uint32_t, const FieldNode*>> added_;
};

}  // namespace

template <class S>
CompiledField<S> compile_field(const FieldNode& root, const std::string& file, const SlotOfLink& slot_of_link) {
  return FieldCompiler<S>(file, slot_of_link).compile(root);
}

template <class S>
CompiledField<S> compile_obstacles(const std::vector<CollisionShape>& solids, const std::string& file,
                                   const std::string& path) {
  const SlotOfLink none;
  return FieldCompiler<S>(file, none).compile(solids, path);
}

#define NEARFIELD_INSTANTIATE(S)                                                                         \
  template CompiledField<S> compile_field(const FieldNode&, const std::string&, const SlotOfLink&);      \
  template CompiledField<S> compile_obstacles(const std::vector<CollisionShape>&, const std::string&, const std::string&);
NEARFIELD_INSTANTIATE(Fixed<27>)
NEARFIELD_INSTANTIATE(Fixed<16>)
NEARFIELD_INSTANTIATE(float)
#undef NEARFIELD_INSTANTIATE

}  // namespace nearfield::host
