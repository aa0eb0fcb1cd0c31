#include "simulate/evaluation.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <memory>
#include <optional>

#include <nearfield/query/soft_clearance.hpp>
#include <nearfield/shape/algebraic_bounds.hpp>

#include "compile/field_compiler.hpp"
#include "compile/quantise.hpp"
#include "model/rest_pose.hpp"
#include "model/urdf.hpp"
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

// Whether rounding to the scalar leaves a number where it is, but for that.
template <class S>
bool in_domain(const Vector3d& point) {
  const double limit = ScalarTraits<S>::to_double(ScalarTraits<S>::domain());
  const auto within_limit = [limit](double x) { return x >= -limit && x <= limit; };
  return within_limit(point.x) && within_limit(point.y) && within_limit(point.z);
}

// A scene's field in a scalar, its links at rest.
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

  Sample<S> at(const nearfield::Vector3<S>& p) const { return program.template evaluate<Sample<S>>(p, slots); }

  Program<S> program;
  nearfield::Slots<S> slots;

 private:
  RestingSlots<S> links_;
  CompiledField<S> compiled_;
  std::vector<S> parameters_;
};

using Numbers = std::array<double, 4>;  // value and gradient
template <class S>
Numbers numbers_of(const Sample<S>& sample) {
  return {real(sample.value), real(sample.gradient.x), real(sample.gradient.y), real(sample.gradient.z)};
}

// The same field in float, whose numbers end far beyond those of Fixed: what differs grossly has saturated on the way.
class WideField {
 public:
  WideField(const SceneDescription& scene, const std::vector<double>& parameters) {
    try {
      field_ = std::make_unique<FieldAtRest<float>>(scene, parameters);
    } catch (const InputError&) {
      // It fits the scalar asked for, but not float: there is nothing to compare with.
    }
  }
  bool differs(const Numbers& narrow, const Vector3d& point) const {
    if (!field_ || !in_domain<float>(point)) return false;
    const Numbers wide = numbers_of(field_->at(quantise<float>(point)));
    for (std::size_t i = 0; i < wide.size(); ++i) {
      const double allowed = (std::abs(wide[i]) + 1.0) / 64.0;
      // A gradient may be that of another operand where several are equal; what saturates is smaller.
      const double missing = i == 0 ? std::abs(wide[i] - narrow[i]) : std::abs(wide[i]) - std::abs(narrow[i]);
      if (missing > allowed) return true;
    }
    return false;
  }

 private:
  std::unique_ptr<FieldAtRest<float>> field_;
};

// What comes after the point in its line.
template <class S>
std::string answer(const FieldAtRest<S>& field, const WideField& wide, const Vector3d& point) {
  const nearfield::Vector3<S> p = quantise<S>(point);
  const Kind kind = field.program.kind();
  const Sample<S> sample = field.at(p);
  const Numbers numbers = numbers_of(sample);
  const double per_metre = kind == Kind::distance ? 1.0 : 1.0 / detail::power_of_two(kGradientLengthLog2);
  const std::string values = format_number(numbers[0]) + "," +
                             list_of(per_metre * Vector3d{numbers[1], numbers[2], numbers[3]});
  Clearance<S> found;
  if (kind == Kind::distance)
    found = clearance(field.program, p, field.slots);
  else if (kind == Kind::intensity)
    found = soft_clearance(field.program, p, field.slots);
  // Point and slots are acceptable: it is the field that has none.
  if (found.status == ClearanceStatus::invalid) {
    const double end = real(algebraic_limit<S>()) * (1.0 - 1e-6);
    const bool at_end = std::any_of(numbers.begin(), numbers.end(), [end](double x) { return !(std::abs(x) < end); });
    return values + (at_end || wide.differs(numbers, point) ? ",,saturated" : ",,no_clearance");
  }
  return values + "," + format_number(real(found.distance)) + "," + name_of(found.status);
}

template <class S>
std::string csv(const SceneDescription& scene, const std::vector<Vector3d>& points,
                const std::vector<double>& parameters) {
  const FieldAtRest<S> field(scene, parameters);
  const WideField wide(scene, parameters);
  std::string text = "x,y,z,value,gradient_x,gradient_y,gradient_z,clearance,status\n";
  for (const Vector3d& point : points) {
    text += list_of(point) + "," + (in_domain<S>(point) ? answer(field, wide, point) : ",,,,,invalid") + "\n";
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
