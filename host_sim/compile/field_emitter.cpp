#include "compile/field_emitter.hpp"

#include <algorithm>
#include <limits>
#include <memory>
#include <utility>

#include "operators/list.hpp"
#include "text/input_error.hpp"
#include "text/number.hpp"

namespace nearfield::host {
namespace {

bool is_rotated(const Placement& placement) { return placement.rotation != Placement{}.rotation; }

bool has_declared_box(const FieldNode& node) {
  if (node.operator_->name == "declared_box") return true;
  return node.kind == FieldKind::distance &&
         std::any_of(node.operands.begin(), node.operands.end(), has_declared_box);
}

Operation leave_of(Operation enter) {
  return enter == Operation::enter_scale ? Operation::leave_scale : Operation::leave;
}

struct Misfit {
  std::string what, allowed;
};

// What is wrong when every parameter fits by itself.
Misfit misfit_of(const FieldNode* node, const ScalarLimits& limits) {
  const std::string type(limits.name);
  const std::string within = "everything must lie within " + format_number(limits.domain) + " m of its frame's origin";
  if (node == nullptr || node->operands.empty()) return {"position and size together do not fit " + type, within};
  if (std::any_of(node->operands.begin(), node->operands.end(), has_declared_box)) {
    return {"a declared box below it", "it is an operand of sharp set operations and placements only"};
  }
  switch (node->kind) {
    case FieldKind::distance:
      return {"the distance, as blended, changes too fast or reaches too far for " + type, within};
    case FieldKind::ray:
      return {"the ray value changes too fast for " + type, "greater influence radii, or blends that are less steep"};
    case FieldKind::intensity:
      return {"what the operands amount to does not fit " + type,
              "smaller weights: where some are negative, and where intensities morph or fade, all together must be less than " +
                  format_number(limits.end)};
    case FieldKind::algebraic:
      break;
  }
  return {"what the operands amount to does not fit " + type, "smaller operands"};
}

Misfit misfit_of(LoadStatus status, const FieldNode* node, const ScalarLimits& limits) {
  switch (status) {
    case LoadStatus::wrong_size:
      return {"the field is too large", "65536 words of image"};
    case LoadStatus::stack_too_deep:
      return {"operands are nested too deeply", std::to_string(kStackDepth) + " deep"};
    case LoadStatus::frames_too_deep:
      return {"placements are nested too deeply", std::to_string(kFrameDepth) + " deep"};
    default:
      return misfit_of(node, limits);
  }
}

}  // namespace

FieldEmitter::FieldEmitter(FieldScalar scalar, std::string file, const SlotOfLink& slot_of_link)
    : scalar_(scalar), limits_(limits_of(scalar)), file_(std::move(file)), slot_of_link_(slot_of_link) {}

std::uint32_t FieldEmitter::table(const FieldNode& node, const std::string& key,
                                  const TableFunction& function) {
  const auto known = references_.find(function.identity);
  if (known != references_.end()) return known->second;
  ImageTable table = with_scalar(scalar_, [&](auto zero) { return bake_table<decltype(zero)>(function); });
  if (!table.usable()) {
    refuse(node, key, "too steep for a table of 256 segments",
           "a table may err by 1/64 at most, and climb by at most 16 over its "
           "range");
  }
  const std::uint32_t reference = table_reference(tables_, tables_.size());
  tables_.push_back(std::move(table));
  return references_[function.identity] = reference;
}

void FieldEmitter::operand(const FieldNode& node) {
  const FieldNode* const outer = std::exchange(node_, &node);
  check_parameters(node);
  const auto add = [&] {
    operators::All::add(static_cast<std::size_t>(node.operator_ - all_operators().data()), *this, node);
  };
  if (node.link) {
    const std::uint32_t slot = slot_of_link_(node, *node.link);
    open_frames_.push_back(steps_.size());
    add_words(Operation::enter_slot, &slot, 1);
    inside(add);
  } else {
    add();
  }
  node_ = outer;
}

void FieldEmitter::fold(const FieldNode& node, const std::function<void()>& add_operation) {
  for (std::size_t i = 0; i < node.operands.size(); ++i) {
    operand(node.operands[i]);
    if (i != 0) add_operation();
  }
}

void FieldEmitter::in_frame(const Placement& placement, const std::function<void()>& add) {
  open_frames_.push_back(steps_.size());
  with_scalar(scalar_, [&](auto zero) {
    const auto pose = quantise<decltype(zero)>(placement);
    add_words(Operation::enter_pose, &pose, payload_words<decltype(pose)>);
  });
  inside(add);
}

void FieldEmitter::placed(const Placement& placement, const std::function<void(const Vector3d& at)>& shape) {
  if (!is_rotated(placement)) return shape(placement.position);
  in_frame(placement, [&] { shape(Vector3d{}); });
}

void FieldEmitter::scaled(double factor, const std::function<void()>& add) {
  const std::size_t first = steps_.size();
  open_frames_.push_back(first);
  with_scalar(scalar_, [&](auto zero) {
    using S = decltype(zero);
    struct {
      UniformScale<S> scale;
      std::uint32_t kind;
    } const entered{UniformScale<S>(quantise<S>(factor)), static_cast<std::uint32_t>(node_->kind)};
    add_words(Operation::enter_scale, &entered, payload_words<decltype(entered)>);
  });
  inside(add);
}

void FieldEmitter::inside(const std::function<void()>& add) {
  add();
  add_words(leave_of(steps_[open_frames_.back()].operation), nullptr, 0);
  open_frames_.pop_back();
}

void FieldEmitter::in_declared_box(const FieldNode& node, const Vector3d& half) {
  const std::size_t first = steps_.size();
  with_scalar(scalar_, [&](auto zero) {
    const auto extents = quantise<decltype(zero)>(half);
    add_words(Operation::enter_box, &extents, payload_words<decltype(extents)>);
  });
  operand(node.operands.front());
  with_scalar(scalar_, [&](auto zero) {
    using S = decltype(zero);
    const auto box_with = [&](Rate lipschitz) { return DeclaredBox<S>(quantise<S>(half), lipschitz); };
    const auto add = [&](const DeclaredBox<S>& box) {
      add_words(Operation::leave_box, &box, payload_words<DeclaredBox<S>>);
    };
    // The rate is not known before the image has been walked once.
    add(box_with(kUnitRate));
    const Certificate<S> inside = write_image<S>(tables_, within_open_frames(first)).inspection.boxed;
    if (!inside.valid) return;  // finish() says why
    if (inside.lipschitz == kNoRateBound || !(inside.magnitude < algebraic_limit<S>())) {
      refuse(node, "size", "the field's gradient has no bound in this box",
             "a smaller box, or a field of smaller values; patches have none "
             "at all");
    }
    steps_.pop_back();
    add(box_with(inside.lipschitz));
  });
}

const std::vector<FieldStep>& FieldEmitter::steps_of(const FieldNode& below) {
  const auto known = steps_below_.find(&below);
  if (known != steps_below_.end()) return known->second;
  const std::size_t first = steps_.size();
  operand(below);
  std::vector<FieldStep> steps(steps_.begin() + static_cast<std::ptrdiff_t>(first), steps_.end());
  steps_.resize(first);
  return steps_below_[&below] = std::move(steps);
}

std::vector<FieldStep> FieldEmitter::seen_from_outside(const std::vector<FieldStep>& inside, FieldKind kind) const {
  std::vector<FieldStep> steps;
  for (const std::size_t frame : open_frames_) {
    steps.push_back(steps_[frame]);
    // What the scale ends with is this field here, not what the node makes of it.
    if (steps.back().operation == Operation::enter_scale) steps.back().words.back() = static_cast<std::uint32_t>(kind);
  }
  steps.insert(steps.end(), inside.begin(), inside.end());
  for (std::size_t i = open_frames_.size(); i-- > 0;) {
    steps.push_back({node_, leave_of(steps_[open_frames_[i]].operation), {}});
  }
  return steps;
}

std::optional<RayField> FieldEmitter::ray_field(const FieldNode& below) {
  if (inside_ray_field_) return std::nullopt;
  inside_ray_field_ = true;
  const bool on_a_link = std::any_of(open_frames_.begin(), open_frames_.end(), [this](std::size_t frame) {
    return steps_[frame].operation == Operation::enter_slot;
  });
  const std::vector<FieldStep> steps =
      on_a_link ? steps_of(below) : seen_from_outside(steps_of(below), below.kind);
  inside_ray_field_ = false;
  return with_scalar(scalar_, [&](auto zero) -> std::optional<RayField> {
    using S = decltype(zero);
    const auto field = std::make_shared<const CompiledField<S>>(inspected<S>(steps));
    const Program<S> program(field->image.data(), field->inspection);
    if (program.slot_count() != 0 || program.parameter_count() != 0) return std::nullopt;
    const Certificate<S>& certificate = program.certificate();
    RayField result;
    result.value = [field, program](const Vector3d& point) {
      return ScalarTraits<S>::to_double(program.template evaluate<Value<S>>(quantise<S>(point), nullptr).value);
    };
    result.rate = certificate.lipschitz == kNoRateBound ? std::numeric_limits<double>::infinity()
                                                        : certificate.lipschitz.to_double() * (1 << -kGradientLengthLog2);
    result.error = ScalarTraits<S>::to_double(certificate.error);
    result.steps = steps.size();
    return result;
  });
}

std::vector<double> FieldEmitter::values_of(const FieldNode& node, const std::string& key,
                                            const FieldNode& below, const std::vector<Vector3d>& points) {
  const std::vector<FieldStep>& steps = steps_of(below);
  return with_scalar(scalar_, [&](auto zero) {
    using S = decltype(zero);
    const CompiledField<S> field = inspected<S>(steps);
    const Program<S> program(field.image.data(), field.inspection);
    if (program.slot_count() != 0) {
      refuse(node, key, "an operand moves with a link", "operands that stay where the node is");
    }
    if (program.parameter_count() != 0) {
      refuse(node, key, "an operand changes with a parameter", "operands without a `parameter_slot`");
    }
    std::vector<double> values;
    for (const Vector3d& point : points) {
      const Value<S> value = program.template evaluate<Value<S>>(quantise<S>(point), nullptr);
      values.push_back(ScalarTraits<S>::to_double(value.value));
    }
    return values;
  });
}

void FieldEmitter::require(const FieldNode& node, const std::string& key, double value,
                           const NumberRange& range) const {
  if (!contains(range, value)) refuse(node, key, misfit(value), describe(range));
}

void FieldEmitter::require_coordinates(const FieldNode& node, const std::string& key,
                                       const Vector3d& point) const {
  const double coordinates[3] = {point.x, point.y, point.z};
  const NumberRange range = fitting_range(limits_, Fit::number, position_range);
  for (std::size_t i = 0; i < 3; ++i) {
    if (contains(range, coordinates[i])) continue;
    refuse(node, key + "[" + std::to_string(i) + "]", misfit(coordinates[i]), describe(range));
  }
}

void FieldEmitter::refuse(const FieldNode& node, const std::string& key, const std::string& message,
                          const std::string& allowed) const {
  throw InputError(file_, node.place_of(key.substr(0, key.find('['))), node.path + "." + key, message,
                   allowed);
}

void FieldEmitter::refuse(const FieldNode& node, const std::string& message, const std::string& allowed) const {
  throw InputError(file_, node.position, node.path, message, allowed);
}

std::string FieldEmitter::misfit(double value) const {
  return format_number(value) + " does not fit " + std::string(limits_.name);
}

void FieldEmitter::fail(SourcePosition position, const std::string& path, LoadStatus status) const {
  const Misfit misfit = misfit_of(status, nullptr, limits_);
  throw InputError(file_, position, path, misfit.what, misfit.allowed);
}

void FieldEmitter::fail(const FieldNode& root, std::size_t step, LoadStatus status) const {
  if (status != LoadStatus::wrong_size) fail_in(steps_, step, status);
  fail(root.position, root.path, status);
}

void FieldEmitter::fail_in(const std::vector<FieldStep>& steps, std::size_t step, LoadStatus status) const {
  const FieldNode& node = *steps[step].node;
  if (steps[step].operation == Operation::enter_scale && status != LoadStatus::frames_too_deep) {
    refuse(node, "scale", "what is around does not fit " + std::string(limits_.name) + " at that size",
           "a greater scale, or fewer frames around it: points inside must lie within " + format_number(limits_.end) + " m");
  }
  if (status == LoadStatus::bad_table) {
    refuse(node, "step", "has not risen from 0 to 1 at its ends", "within 2^-24; a logistic step with a greater alpha does");
  }
  const Misfit misfit = misfit_of(status, &node, limits_);
  throw InputError(file_, node.position, node.path, misfit.what, misfit.allowed);
}

void FieldEmitter::add_words(Operation operation, const void* payload, std::uint32_t words) {
  FieldStep step{node_, operation, std::vector<std::uint32_t>(words)};
  if (words != 0) std::memcpy(step.words.data(), payload, words * sizeof(std::uint32_t));
  steps_.push_back(std::move(step));
}

void FieldEmitter::check_parameters(const FieldNode& node) const {
  for (const ParameterDescription& parameter : node.operator_->parameters) {
    if (parameter.fit == Fit::any) continue;
    const std::string key(parameter.key);
    const std::vector<double>& values = node.parameters.at(key);
    for (std::size_t i = 0; i < values.size(); ++i) {
      if (fits(limits_, parameter.fit, values[i])) continue;
      std::string place = key;
      if (parameter.most_points > 0) place += "[" + std::to_string(i / parameter.count) + "]";
      if (parameter.count > 1 || parameter.most > 0) place += "[" + std::to_string(i % parameter.count) + "]";
      refuse(node, place, misfit(values[i]), describe_fitting(limits_, parameter.fit, parameter.range));
    }
  }
  require_coordinates(node, "position", node.placement.position);
}

std::vector<FieldStep> FieldEmitter::within_open_frames(std::size_t first) const {
  std::vector<FieldStep> steps;
  for (const std::size_t frame : open_frames_) steps.push_back(steps_[frame]);
  steps.insert(steps.end(), steps_.begin() + static_cast<std::ptrdiff_t>(first), steps_.end());
  return steps;
}

}  // namespace nearfield::host
