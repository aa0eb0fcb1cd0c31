// Nodes of a scene as operations and tables, for a scalar chosen while the program runs.
#pragma once

#include <cstring>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <type_traits>
#include <vector>

#include <nearfield/field/program.hpp>

#include "compile/contour_cut.hpp"
#include "compile/field_steps.hpp"
#include "compile/quantise.hpp"
#include "compile/scalar_limits.hpp"

namespace nearfield::host {

// The slot whose pose carries a link, by the name that a node gives; InputError's text when there is none.
using SlotOfLink = std::function<std::uint32_t(const FieldNode& node, const std::string& link)>;

// Collects steps and tables. Payloads are what `make(zero)` returns, zero a number of the scalar: a generic
// lambda, compiled for each scalar, which should do no more than quantise numbers. Every function throws
// InputError at the node, or at its key, that does not fit the scalar.
class FieldEmitter {
 public:
  FieldEmitter(FieldScalar scalar, std::string file, const SlotOfLink& slot_of_link);

  const ScalarLimits& limits() const { return limits_; }

  // An operation of nearfield/field/operations.hpp; `table` is what table() returned.
  template <class Make>
  void operation(const Make& make) {
    with_scalar(scalar_, [&](auto zero) { add_payload(make(zero)); });
  }
  template <class Make>
  void operation(const Make& make, std::uint32_t table) {
    with_scalar(scalar_, [&](auto zero) { add_payload(make(zero), table); });
  }

  // The reference of a function's table, which equal functions share; blames node.key when no table holds it.
  std::uint32_t table(const FieldNode& node, const std::string& key, const TableFunction& function);

  // A node below, checked and added.
  void operand(const FieldNode& node);
  // All nodes below, from the second on each followed by what add_operation() adds.
  void fold(const FieldNode& node, const std::function<void()>& add_operation);
  // What inside() adds, in a frame of its own; or what shape(at) adds, at the position, or turned in a frame
  // of its own.
  void in_frame(const Placement& placement, const std::function<void()>& inside);
  void placed(const Placement& placement, const std::function<void(const Vector3d& at)>& shape);
  // What inside() adds, so many times as large. Blames `scale` of the node that is being added.
  void scaled(double factor, const std::function<void()>& inside);
  // The one node below within a declared box of these half extents, in m.
  void in_declared_box(const FieldNode& node, const Vector3d& half);

  // The certificate of what has been added since there were `first` steps, in the frames that are open.
  std::size_t step_count() const { return steps_.size(); }
  template <class S>
  Certificate<S> certificate_since(std::size_t first) {
    return inspected<S>(within_open_frames(first), !open_frames_.empty()).inspection.certificate;
  }
  // A node below by itself, as it is seen from outside of all frames; within a link's, from that of the node that is being
  // added. Nothing if it moves with a link or changes with
  // a parameter, nor within another one: a node that asks for it asks again when it is added for good.
  std::optional<RayField> ray_field(const FieldNode& below);
  // Of such fields, as long as there are evaluations left, which all nodes share.
  std::optional<ContourCut> contour_cut(const RayField& object, const RayField& contour) {
    return host::contour_cut(object, contour, limits_.domain, contour_evaluations_);
  }
  // The values of a node below at points of the frame of the node that is being added. Blames node.key when
  // it moves with a link.
  std::vector<double> values_of(const FieldNode& node, const std::string& key, const FieldNode& below,
                                const std::vector<Vector3d>& points);

  // Refuses node.key unless the value is in the range, saying what does not fit.
  void require(const FieldNode& node, const std::string& key, double value, const NumberRange& range) const;
  // A point given in the node's frame, as the payload will have it.
  void require_coordinates(const FieldNode& node, const std::string& key, const Vector3d& point) const;
  [[noreturn]] void refuse(const FieldNode& node, const std::string& key, const std::string& message,
                           const std::string& allowed) const;
  [[noreturn]] void refuse(const FieldNode& node, const std::string& message, const std::string& allowed) const;
  // `... does not fit q27`, for messages.
  std::string misfit(double value) const;

  // The image of all that has been added. `blame` throws for the step that keeps it from being loaded.
  template <class S>
  CompiledField<S> finish(const std::function<void(std::size_t step, LoadStatus status)>& blame) const {
    CompiledField<S> field = write_image<S>(tables_, steps_);
    const nearfield::Inspection<S>& found = field.inspection;
    if (found.status != LoadStatus::ok) blame(step_at(tables_, steps_, found.at_word), found.status);
    return field;
  }
  // InputError at a node or place; `root` for fields that are too large.
  [[noreturn]] void fail(SourcePosition position, const std::string& path, LoadStatus status) const;
  [[noreturn]] void fail(const FieldNode& root, std::size_t step, LoadStatus status) const;

 private:
  template <class T>
  void add_payload(const T& payload) {
    static_assert(!nearfield::detail::uses_table<T>, "this operation needs a table's reference");
    add_words(OperationOf<T>::value, &payload, payload_words<T>);
  }
  template <class T>
  void add_payload(const T& payload, std::uint32_t table) {
    static_assert(nearfield::detail::uses_table<T>, "this operation has no table");
    add_words(OperationOf<T>::value, &payload, payload_words<T>);
    steps_.back().words.push_back(table);
  }
  void add_words(Operation operation, const void* payload, std::uint32_t words);
  void check_parameters(const FieldNode& node) const;
  void inside(const std::function<void()>& add);
  std::vector<FieldStep> within_open_frames(std::size_t first) const;
  // What a node below is made of; of the same node made once, as nodes that ask for it may be nested deeply.
  const std::vector<FieldStep>& steps_of(const FieldNode& below);
  // The open frames, what is within them, and their ends: a field as it is seen from outside.
  std::vector<FieldStep> seen_from_outside(const std::vector<FieldStep>& inside, FieldKind kind) const;

  // Steps that must load, but for frames that may be left open at the end; what keeps them from it is blamed.
  template <class S>
  CompiledField<S> inspected(const std::vector<FieldStep>& steps, bool open_frames = false) const {
    CompiledField<S> field = write_image<S>(tables_, steps);
    const nearfield::Inspection<S>& found = field.inspection;
    const bool as_expected = open_frames && found.status == LoadStatus::frames_unbalanced;
    if (found.status != LoadStatus::ok && !as_expected) fail_in(steps, step_at(tables_, steps, found.at_word), found.status);
    return field;
  }
  [[noreturn]] void fail_in(const std::vector<FieldStep>& steps, std::size_t step, LoadStatus status) const;

  FieldScalar scalar_;
  ScalarLimits limits_;
  std::string file_;
  const SlotOfLink& slot_of_link_;
  std::map<std::string, std::uint32_t> references_;  // of tables, by identity
  std::vector<ImageTable> tables_;
  std::vector<FieldStep> steps_;
  std::vector<std::size_t> open_frames_;  // the steps that entered them
  const FieldNode* node_ = nullptr;       // to blame for what is being added
  std::map<const FieldNode*, std::vector<FieldStep>> steps_below_;  // by steps_of()
  bool inside_ray_field_ = false;
  std::size_t contour_evaluations_ = 10000000;  // steps that may still be evaluated to compare contours
};

}  // namespace nearfield::host
