#include "simulate/evaluation.hpp"

#include <map>
#include <optional>

#include <nearfield/query/soft_clearance.hpp>

#include "compile/field_compiler.hpp"
#include "compile/quantise.hpp"
#include "model/rest_pose.hpp"
#include "model/urdf.hpp"
#include "simulate/saturation.hpp"
#include "text/input_error.hpp"
#include "text/names.hpp"
#include "text/number.hpp"

namespace nearfield::host {
namespace {

// A robot at rest, read when the first node asks for one of its links.
class RestingRobot {
 public:
  explicit RestingRobot(std::optional<std::string> file) : file_(std::move(file)) {}

  bool exists() const { return file_.has_value(); }
  // Nothing when it has no such link.
  std::optional<Placement> placement_of(const std::string& link) {
    read();
    const auto index = robot_->find_link(link);
    if (!index) return std::nullopt;
    return placements_[*index];
  }
  std::string link_names() {
    read();
    std::vector<std::string_view> names;
    for (const Link& link : robot_->links) names.push_back(link.name);
    return joined(names);
  }

 private:
  void read() {
    if (robot_) return;
    robot_ = read_urdf(*file_);
    placements_ = rest_placements(*robot_);
  }

  std::optional<std::string> file_;
  std::optional<RobotDescription> robot_;
  std::vector<Placement> placements_;
};

// Numbers the links that a field names, and knows the pose of each.
template <class S>
class RestingSlots {
 public:
  explicit RestingSlots(const SceneDescription& scene)
      : file_(scene.file), arm_(scene.robot), person_(person_file(scene)) {}

  std::uint32_t slot_of(const FieldNode& node, const std::string& link) {
    const auto known = numbers_.find(link);
    if (known != numbers_.end()) return known->second;
    const auto number = static_cast<std::uint32_t>(poses_.size());
    if (number == kSlotLimit) {
      fail(node, "the field names too many links", "at most " + std::to_string(kSlotLimit) + " are allowed");
    }
    poses_.push_back(quantise<S>(placement_of(node, link)));
    if (!valid_pose(poses_.back()))
      fail(node, "the link lies outside the number range", "another --scalar holds more");
    return numbers_[link] = number;
  }
  const std::vector<nearfield::Pose<S>>& poses() const { return poses_; }

 private:
  static std::optional<std::string> person_file(const SceneDescription& scene) {
    if (!scene.person) return std::nullopt;
    return scene.person->robot;
  }

  Placement placement_of(const FieldNode& node, const std::string& link) {
    const std::string prefix = "person/";
    const bool of_person = link.rfind(prefix, 0) == 0;
    RestingRobot& robot = of_person ? person_ : arm_;
    if (!robot.exists()) {
      fail(node, "link of a robot, but the scene has none", "name one with the scene's key \"robot\"");
    }
    const auto placement = robot.placement_of(of_person ? link.substr(prefix.size()) : link);
    if (!placement)
      fail(node, unknown(link),
           std::string(of_person ? "person/ and one of " : "one of ") + robot.link_names());
    return *placement;
  }
  static std::string unknown(const std::string& link) { return "no link " + in_quotes(link); }
  [[noreturn]] void fail(const FieldNode& node, const std::string& message,
                         const std::string& allowed) const {
    throw InputError(file_, node.position, node.path + ".link", message, allowed);
  }

  std::string file_;
  RestingRobot arm_, person_;
  std::map<std::string, std::uint32_t> numbers_;
  std::vector<nearfield::Pose<S>> poses_;
};

const char* name_of(ClearanceStatus status) {
  switch (status) {
    case ClearanceStatus::touching:
      return "touching";
    case ClearanceStatus::undecided:
      return "undecided";
    case ClearanceStatus::clear:
      return "clear";
    case ClearanceStatus::invalid:
      break;
  }
  return "invalid";
}

std::string list_of(const Vector3d& v) {
  return format_number(v.x) + "," + format_number(v.y) + "," + format_number(v.z);
}

// Zeros without a sign.
template <class S>
double real(S value) {
  return ScalarTraits<S>::to_double(value) + 0.0;
}

// What comes after the point in its line.
template <class S>
std::string answer(const Program<S>& field, const SaturationWatch<S>& watch, const nearfield::Vector3<S>& p,
                   const nearfield::Slots<S>& slots) {
  const Sample<S> sample = field.template evaluate<Sample<S>>(p, slots);
  const double per_metre =
      field.kind() == Kind::distance ? 1.0 : 1.0 / detail::power_of_two(kGradientLengthLog2);
  const Vector3d gradient{real(sample.gradient.x), real(sample.gradient.y), real(sample.gradient.z)};
  const std::string values = format_number(real(sample.value)) + "," + list_of(per_metre * gradient);
  Clearance<S> found;
  if (field.kind() == Kind::distance)
    found = clearance(field, p, slots);
  else if (field.kind() == Kind::intensity)
    found = soft_clearance(field, p, slots);
  // Point and slots are acceptable: it is the field that has none.
  if (found.status == ClearanceStatus::invalid) {
    return values + (watch.saturated(sample, p, slots) ? ",,saturated" : ",,no_clearance");
  }
  return values + "," + format_number(real(found.distance)) + "," + name_of(found.status);
}

// Whether rounding to the scalar leaves a number where it is, but for that.
template <class S>
bool in_domain(const Vector3d& point) {
  const double limit = ScalarTraits<S>::to_double(ScalarTraits<S>::domain());
  const auto within_limit = [limit](double x) { return x >= -limit && x <= limit; };
  return within_limit(point.x) && within_limit(point.y) && within_limit(point.z);
}

template <class S>
std::string csv(const SceneDescription& scene, const std::vector<Vector3d>& points,
                const std::vector<double>& parameters) {
  RestingSlots<S> links(scene);
  const SlotOfLink slot_of_link = [&links](const FieldNode& node, const std::string& link) {
    return links.slot_of(node, link);
  };
  const CompiledField<S> compiled = compile_field<S>(scene.field, scene.file, slot_of_link);
  const SaturationWatch<S> watch(scene.field, scene.file, slot_of_link);
  const Program<S> field(compiled.image.data(), compiled.inspection);
  if (field.parameter_count() > parameters.size()) {
    throw InputError(scene.file, scene.field.position, scene.field.path,
                     "takes " + std::to_string(field.parameter_count()) + " parameters, of which " +
                         std::to_string(parameters.size()) + " are given",
                     "--parameters with as many numbers from 0 to 1");
  }
  std::vector<S> rounded;
  for (const double parameter : parameters) rounded.push_back(quantise<S>(parameter));
  const std::vector<nearfield::Pose<S>>& poses = links.poses();
  const nearfield::Slots<S> slots(poses.data(), static_cast<std::uint32_t>(poses.size()), rounded.data(),
                                  static_cast<std::uint32_t>(rounded.size()));
  std::string text = "x,y,z,value,gradient_x,gradient_y,gradient_z,clearance,status\n";
  for (const Vector3d& point : points) {
    text += list_of(point) + ",";
    text += in_domain<S>(point) ? answer(field, watch, quantise<S>(point), slots) : ",,,,,invalid";
    text += "\n";
  }
  return text;
}

}  // namespace

std::string evaluation_csv(const SceneDescription& scene, const std::vector<Vector3d>& points,
                           FieldScalar scalar, const std::vector<double>& parameters) {
  switch (scalar) {
    case FieldScalar::q27:
      return csv<Fixed<27>>(scene, points, parameters);
    case FieldScalar::q24:
      return csv<Fixed<24>>(scene, points, parameters);
    case FieldScalar::q16:
      return csv<Fixed<16>>(scene, points, parameters);
    case FieldScalar::single:
      return csv<float>(scene, points, parameters);
  }
  return "";
}

}  // namespace nearfield::host
