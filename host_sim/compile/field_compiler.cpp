#include "compile/field_compiler.hpp"

#include <algorithm>
#include <map>
#include <memory>
#include <utility>

#include <nearfield/field/builder.hpp>
#include <nearfield/field/program.hpp>

#include "compile/quantise.hpp"
#include "compile/table_baker.hpp"
#include "operators/list.hpp"
#include "text/input_error.hpp"

namespace nearfield::host {
namespace {

constexpr std::uint32_t largest_image = 1U << 16U;  // words

bool is_rotated(const Placement& placement) { return placement.rotation != Placement{}.rotation; }

std::string reason(LoadStatus status) {
  switch (status) {
    case LoadStatus::wrong_size:
      return "the field is too large";
    case LoadStatus::stack_too_deep:
      return "operands are nested too deeply";
    case LoadStatus::frames_too_deep:
      return "placements are nested too deeply";
    default:
      return "a size or position does not fit the number range";
  }
}

// Collects what a field is made of; see operators/list.hpp. Tables are baked and written at once; operations
// wait, since they come after all tables.
template <class S>
class FieldCompiler {
 public:
  using Scalar = S;

  FieldCompiler(std::string file, const SlotOfLink& slot_of_link)
      : file_(std::move(file)), slot_of_link_(slot_of_link), builder_(std::make_unique<Builder>()) {}

  CompiledField<S> compile(const FieldNode& root) {
    operand(root);
    std::vector<std::uint32_t> starts;
    for (const Step& step : steps_) {
      starts.push_back(builder_->size());
      step.add(*builder_);
    }
    return finish([&](std::uint32_t word, LoadStatus status) {
      const FieldNode* culprit = &root;
      for (std::size_t i = 0; i < steps_.size() && starts[i] <= word; ++i) culprit = steps_[i].node;
      fail(culprit->position, culprit->path, status);
    });
  }

  CompiledField<S> compile(const std::vector<CollisionShape>& solids, const std::string& path) {
    std::vector<std::uint32_t> starts;
    for (std::size_t i = 0; i < solids.size(); ++i) {
      const std::size_t first_step = steps_.size();
      placed(solids[i].origin, [&](const Vector3d& at) { add_solid(solids[i], at); });
      if (i != 0) operation(SharpUnion<S>{});
      starts.push_back(builder_->size());
      for (std::size_t step = first_step; step < steps_.size(); ++step) steps_[step].add(*builder_);
    }
    return finish([&](std::uint32_t word, LoadStatus status) {
      const auto after = std::upper_bound(starts.begin() + 1, starts.end(), word);
      const auto culprit = static_cast<std::size_t>(after - starts.begin()) - 1;
      fail(solids[culprit].position, path + "[" + std::to_string(culprit) + "]", status);
    });
  }

  // A table of the image; `range`: of the function's argument, in units of its own parameter.
  struct Reference {
    std::uint32_t reference = 0;
    S range{};
  };

  template <class T>
  void operation(const T& payload) {
    add_step([payload](Builder& builder) { builder.operation(payload); });
  }
  template <class T>
  void operation(const T& payload, std::uint32_t table) {
    add_step([payload, table](Builder& builder) { builder.operation(payload, table); });
  }

  Reference table(const FieldNode& node, const char* key, const TableFunction& function) {
    const auto known = tables_.find(function.identity);
    if (known != tables_.end()) return known->second;
    const ImageTable<S> table = bake_table<S>(function);
    if (!table.usable()) {
      refuse(node, key, "too steep for a table of 256 segments",
             "a table may err by 1/64 at most, and climb by at most 16 over its range");
    }
    return tables_[function.identity] = {write(table), table.range};
  }

  void operand(const FieldNode& node) {
    const FieldNode* const outer = node_;
    node_ = &node;
    const auto add_inside = [&] {
      operators::All::add(static_cast<std::size_t>(node.operator_ - all_operators().data()), *this, node);
    };
    if (node.link) {
      const std::uint32_t slot = slot_of_link_(node, *node.link);
      inside([slot](Builder& builder) { builder.enter_slot(slot); }, add_inside);
    } else {
      add_inside();
    }
    node_ = outer;
  }

  Certificate<S> certified_operand(const FieldNode& node) {
    const std::size_t first = steps_.size();
    operand(node);
    return trial(open_frames_, first)->finish().certificate;
  }

  void in_declared_box(const FieldNode& node, const nearfield::Vector3<S>& half) {
    const std::size_t first = steps_.size();
    add_step([half](Builder& builder) { builder.enter_box(half); });
    operand(node.operands.front());
    const auto leave_box = [half](Rate lipschitz) {
      return [half, lipschitz](Builder& builder) { builder.leave_box(DeclaredBox<S>(half, lipschitz)); };
    };
    add_step(leave_box(kUnitRate));
    const Certificate<S> inside = trial(open_frames_, first)->finish().boxed;
    if (!inside.valid) return;  // finish() says why
    if (inside.lipschitz == kNoRateBound || !(inside.magnitude < algebraic_limit<S>())) {
      refuse(node, "size", "the field's gradient has no bound in this box",
             "a smaller box, or a field of smaller values; patches have none at all");
    }
    steps_.back().add = leave_box(inside.lipschitz);
  }

  template <class Blend>
  double trial_value(const FieldNode& node, const Vector3d& point, const Blend& blend) {
    const std::size_t first = steps_.size();
    for (const FieldNode& below : node.operands) operand(below);
    blend();
    const auto image = trial({}, first);
    steps_.resize(first);
    const Program<S> program(image->words(), image->finish());
    if (!program.valid() || program.slot_count() != 0) return 0.0;
    const nearfield::Vector3<S> at = quantise<S>(point);
    if (!coordinates_in_domain(at)) return 0.0;
    return ScalarTraits<S>::to_double(program.template evaluate<Value<S>>(at, nullptr).value);
  }

  [[noreturn]] void refuse(const FieldNode& node, const char* key, const std::string& message,
                           const std::string& allowed) const {
    throw InputError(file_, node.position, node.path + "." + key, message, allowed);
  }

  template <class AddOperation>
  void fold(const FieldNode& node, const AddOperation& add_operation) {
    for (std::size_t i = 0; i < node.operands.size(); ++i) {
      operand(node.operands[i]);
      if (i != 0) add_operation();
    }
  }

  template <class Inside>
  void in_frame(const Placement& placement, const Inside& add_inside) {
    const nearfield::Pose<S> pose = quantise<S>(placement);
    inside([pose](Builder& builder) { builder.enter(pose); }, add_inside);
  }

  template <class Shape>
  void placed(const Placement& placement, const Shape& shape) {
    if (!is_rotated(placement)) return shape(placement.position);
    in_frame(placement, [&] { shape(Vector3d{}); });
  }

 private:
  using Builder = ImageBuilder<S, largest_image>;
  struct Step {
    const FieldNode* node;
    std::function<void(Builder&)> add;
  };

  template <class Enter, class Inside>
  void inside(const Enter& enter, const Inside& add_inside) {
    open_frames_.push_back(steps_.size());
    add_step(enter);
    add_inside();
    add_step([](Builder& builder) { builder.leave(); });
    open_frames_.pop_back();
  }

  // The tables so far, and within frames of their own what has been added since a step.
  std::unique_ptr<Builder> trial(const std::vector<std::size_t>& frames, std::size_t first) const {
    auto image = std::make_unique<Builder>(*builder_);
    for (const std::size_t frame : frames) steps_[frame].add(*image);
    for (std::size_t i = first; i < steps_.size(); ++i) steps_[i].add(*image);
    for (std::size_t i = 0; i < frames.size(); ++i) image->leave();
    return image;
  }

  template <class Add>
  void add_step(const Add& add) {
    steps_.push_back({node_, add});
  }

  std::uint32_t write(const ImageTable<S>& table) { return write_sized<0>(table); }
  template <std::uint32_t index_bits>
  std::uint32_t write_sized(const ImageTable<S>& table) {
    if constexpr (index_bits < image_format::greatest_index_bits) {
      if (table.index_bits != static_cast<int>(index_bits)) return write_sized<index_bits + 1>(table);
    }
    Table<S, 1 << index_bits> sized;
    std::copy(table.coefficients.begin(), table.coefficients.end(), sized.coefficients);
    sized.slope_headroom = table.slope_headroom;
    sized.range = table.range;
    sized.facts = table.facts;
    return builder_->table(sized);
  }

  template <class Blame>
  CompiledField<S> finish(const Blame& blame) {
    CompiledField<S> compiled;
    compiled.inspection = builder_->finish();
    if (compiled.inspection.status != LoadStatus::ok) {
      blame(compiled.inspection.at_word, compiled.inspection.status);
    }
    compiled.image.assign(builder_->words(), builder_->words() + builder_->size());
    return compiled;
  }

  [[noreturn]] void fail(SourcePosition position, const std::string& path, LoadStatus status) const {
    throw InputError(file_, position, path, reason(status),
                     "everything must lie within " +
                         std::to_string(ScalarTraits<S>::to_double(ScalarTraits<S>::domain())) +
                         " m of its frame's origin, " + std::to_string(kStackDepth) + " operands and " +
                         std::to_string(kFrameDepth) + " frames deep");
  }

  void add_solid(const CollisionShape& solid, const Vector3d& at) {
    const nearfield::Vector3<S> center = quantise<S>(at);
    const Vector3d half{0.0, 0.0, 0.5 * solid.length};
    switch (solid.kind) {
      case CollisionKind::sphere:
        operation(Sphere<S>{center, quantise<S>(solid.radius)});
        break;
      case CollisionKind::box:
        operation(Box<S>{center, quantise<S>(0.5 * solid.size)});
        break;
      case CollisionKind::cylinder:
        operation(Cylinder<S>{center, quantise<S>(solid.radius), quantise<S>(0.5 * solid.length)});
        break;
      case CollisionKind::capsule:
        operation(quantise_capsule<S>(at - half, at + half, solid.radius));
        break;
    }
  }

  std::string file_;
  const SlotOfLink& slot_of_link_;
  std::unique_ptr<Builder> builder_;
  std::map<std::string, Reference> tables_;
  std::vector<Step> steps_;
  std::vector<std::size_t> open_frames_;  // the steps that entered them
  const FieldNode* node_ = nullptr;       // to blame for what is being added
};

}  // namespace

template <class S>
CompiledField<S> compile_field(const FieldNode& root, const std::string& file,
                               const SlotOfLink& slot_of_link) {
  return FieldCompiler<S>(file, slot_of_link).compile(root);
}

template <class S>
CompiledField<S> compile_obstacles(const std::vector<CollisionShape>& solids, const std::string& file,
                                   const std::string& path) {
  const SlotOfLink none;
  return FieldCompiler<S>(file, none).compile(solids, path);
}

#define NEARFIELD_INSTANTIATE(S)                                                                      \
  template CompiledField<S> compile_field(const FieldNode&, const std::string&, const SlotOfLink&);   \
  template CompiledField<S> compile_obstacles(const std::vector<CollisionShape>&, const std::string&, \
                                              const std::string&);
NEARFIELD_INSTANTIATE(Fixed<27>)
NEARFIELD_INSTANTIATE(Fixed<24>)
NEARFIELD_INSTANTIATE(Fixed<16>)
NEARFIELD_INSTANTIATE(float)
#undef NEARFIELD_INSTANTIATE

}  // namespace nearfield::host
