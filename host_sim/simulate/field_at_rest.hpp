// A scene's field, compiled for a scalar, where the robots of the scene carry it at rest.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "compile/field_compiler.hpp"
#include "compile/quantise.hpp"
#include "model/rest_pose.hpp"
#include "model/scene_description.hpp"
#include "text/input_error.hpp"

namespace nearfield::host {

// A robot at rest (rest_pose.hpp), read when the first node asks for one of its links.
class RestingRobot {
 public:
  explicit RestingRobot(std::optional<std::string> file) : file_(std::move(file)) {}

  bool exists() const { return file_.has_value(); }
  // Nothing when it has no such link.
  std::optional<Placement> placement_of(const std::string& link);
  std::string link_names();

 private:
  void read();

  std::optional<std::string> file_;
  std::optional<RobotDescription> robot_;
  std::vector<Placement> placements_;
};

// Where a link of the scene's arm or person (`person/LINK`) lies at rest. InputError at the node's `link` for
// a robot or link that the scene does not have.
class RestingLinks {
 public:
  explicit RestingLinks(const SceneDescription& scene);

  Placement placement_of(const FieldNode& node, const std::string& link);
  [[noreturn]] void fail(const FieldNode& node, const std::string& message, const std::string& allowed) const;

 private:
  std::string file_;
  RestingRobot arm_, person_;
};

// Numbers the links that a field names, and knows the pose of each.
template <class S>
class RestingSlots {
 public:
  explicit RestingSlots(const SceneDescription& scene) : links_(scene) {}

  std::uint32_t slot_of(const FieldNode& node, const std::string& link) {
    const auto known = numbers_.find(link);
    if (known != numbers_.end()) return known->second;
    const auto number = static_cast<std::uint32_t>(poses_.size());
    if (number == kSlotLimit) {
      links_.fail(node, "the field names too many links",
                  "at most " + std::to_string(kSlotLimit) + " are allowed");
    }
    poses_.push_back(quantise<S>(links_.placement_of(node, link)));
    if (!valid_pose(poses_.back()))
      links_.fail(node, "the link lies outside the number range", "another --scalar holds more");
    return numbers_[link] = number;
  }
  const std::vector<nearfield::Pose<S>>& poses() const { return poses_; }

 private:
  RestingLinks links_;
  std::map<std::string, std::uint32_t> numbers_;
  std::vector<nearfield::Pose<S>> poses_;
};

// A scene's field in a scalar, its links at rest. InputError when it does not fit the scalar, takes more
// parameters than are given, or names links that the scene does not have. Several threads may evaluate it at
// once.
template <class S>
class FieldAtRest {
 public:
  FieldAtRest(const SceneDescription& scene, const std::vector<double>& parameters) : links_(scene) {
    compiled_ = compile_field<S>(
        scene.field, scene.file,
        [this](const FieldNode& node, const std::string& link) { return links_.slot_of(node, link); });
    program = Program<S>(compiled_.image.data(), compiled_.inspection);
    if (program.parameter_count() > parameters.size()) {
      throw InputError(scene.file, scene.field.position, scene.field.path,
                       "takes " + std::to_string(program.parameter_count()) + " parameters, of which " +
                           std::to_string(parameters.size()) + " are given",
                       "--parameters with as many numbers from 0 to 1");
    }
    for (const double parameter : parameters) parameters_.push_back(quantise<S>(parameter));
    slots = nearfield::Slots<S>(links_.poses().data(), static_cast<std::uint32_t>(links_.poses().size()),
                                parameters_.data(), static_cast<std::uint32_t>(parameters_.size()));
  }
  FieldAtRest(const FieldAtRest&) = delete;
  FieldAtRest& operator=(const FieldAtRest&) = delete;

  Sample<S> at(const nearfield::Vector3<S>& p) const {
    return program.template evaluate<Sample<S>>(p, slots);
  }

  Program<S> program;
  nearfield::Slots<S> slots;

 private:
  RestingSlots<S> links_;
  CompiledField<S> compiled_;
  std::vector<S> parameters_;
};

}  // namespace nearfield::host
