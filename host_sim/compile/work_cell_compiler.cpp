#include "compile/work_cell_compiler.hpp"

#include <algorithm>
#include <cmath>

#include "compile/quantise.hpp"
#include "model/srdf.hpp"
#include "model/urdf.hpp"
#include "text/input_error.hpp"
#include "text/names.hpp"

namespace nearfield::host {
namespace {

template <class T> work_cell::Span<T> span_of(const std::vector<T>& v) {
  return {v.data(), static_cast<std::uint32_t>(v.size())};
}

std::string list_of(const std::vector<std::string>& names) {
  std::string text;
  for (const std::string& name : names) text += (text.empty() ? "" : ", ") + name;
  return text;
}

// One waypoint's joint values in the order of the robot's variables, each within its limits.
std::vector<Q> row_of(const Waypoint& waypoint, const CompiledRobot<Q>& robot, const std::string& file,
                      const std::string& path) {
  for (const auto& [name, value] : waypoint.joints) {
    if (std::find(robot.variable_names.begin(), robot.variable_names.end(), name) == robot.variable_names.end()) {
      throw InputError(file, waypoint.position, path + ".joints." + name, "no such moving joint",
                       "joints are " + list_of(robot.variable_names));
    }
  }
  std::vector<Q> row;
  for (std::size_t i = 0; i < robot.variable_names.size(); ++i) {
    const std::string& name = robot.variable_names[i];
    const auto found = waypoint.joints.find(name);
    if (found == waypoint.joints.end()) {
      throw InputError(file, waypoint.position, path + ".joints", "the joint " + name + " is missing",
                       "every moving joint needs a value: " + list_of(robot.variable_names));
    }
    row.push_back(quantise<Q>(found->second));
    for (const nearfield::Joint<Q>& joint : robot.joints) {
      if (joint.kind == nearfield::JointKind::fixed || joint.variable != i) continue;
      const Q value = narrow<Q>(product(joint.multiplier, row.back())) + joint.offset;
      if (value < joint.lower || value > joint.upper) {
        throw InputError(file, waypoint.position, path + ".joints." + name,
                         std::to_string(found->second) + " is outside the joint's limits",
                         "allowed are " + std::to_string(joint.lower.to_double()) + " to " +
                             std::to_string(joint.upper.to_double()));
      }
    }
  }
  return row;
}

CompiledTrack compile_track(const std::vector<Waypoint>& waypoints, const CompiledRobot<Q>& robot,
                            const std::string& file, const std::string& path) {
  CompiledTrack track;
  track.variables = static_cast<std::uint32_t>(robot.variable_names.size());
  for (std::size_t i = 0; i < waypoints.size(); ++i) {
    const std::string place = path + "[" + std::to_string(i) + "]";
    const std::vector<Q> row = row_of(waypoints[i], robot, file, place);
    const auto time = static_cast<std::uint32_t>(std::llround(waypoints[i].time * 1e6));
    if (!track.times.empty() && time <= track.times.back()) {
      throw InputError(file, waypoints[i].position, place + ".time", "not later than the waypoint before",
                       "at least 0.000001 s apart");
    }
    track.times.push_back(time);
    track.values.insert(track.values.end(), row.begin(), row.end());
  }
  return track;
}

std::uint32_t slot_of(const FieldNode& node, const std::string& link, const CompiledRobot<Q>& person,
                      const std::string& file) {
  const std::string prefix = "person/";
  const std::size_t number = link.rfind(prefix, 0) == 0 ? person.find_link(link.substr(prefix.size())) : person.link_names.size();
  if (number >= person.link_names.size()) {
    throw InputError(file, node.position, node.path + ".link", "no link `" + link + "` that moves in this field",
                     person.link_names.empty() ? "the scene has no person"
                                               : "allowed are person/ and one of " + list_of(person.link_names));
  }
  return static_cast<std::uint32_t>(number);
}

void compile_separation(const SeparationDescription& d, const std::string& file, work_cell::WorkCell& settings) {
  nearfield::Separation<Q> s;
  s.human_speed = quantise<Q>(d.human_speed);
  s.robot_speed = quantise<Q>(d.robot_speed);
  s.reaction_time = quantise<Q>(d.reaction_time);
  s.stopping_time = quantise<Q>(d.stopping_time);
  s.stopping_distance = quantise<Q>(d.stopping_distance);
  s.intrusion_distance = quantise<Q>(d.intrusion_distance);
  s.human_uncertainty = quantise<Q>(d.human_uncertainty);
  s.robot_uncertainty = quantise<Q>(d.robot_uncertainty);
  const Q full = ScalarTraits<Q>::one();
  settings.person_stop = s.protective_distance(quantise<Q>(d.slow_override));
  settings.person_free = s.protective_distance(full) + quantise<Q>(d.slow_margin);
  settings.cell_stop = quantise<Q>(d.cell_stop);
  settings.cell_free = quantise<Q>(d.cell_slow);
  const auto require = [&file](bool ok, const std::string& key, const std::string& what, const std::string& allowed) {
    if (!ok) throw InputError(file, {}, "separation." + key, what, allowed);
  };
  require(settings.person_free < ScalarTraits<Q>::domain(), "slow_margin", "the protective distance leaves the domain",
          "it must stay below 4 m");
  require(settings.person_stop < settings.person_free, "slow_override", "the arm would stop and never slow down",
          "the protective distance at full speed, with slow_margin, must exceed the one at slow_override");
  require(settings.cell_stop < settings.cell_free && settings.cell_free < ScalarTraits<Q>::domain(), "cell_slow",
          "not above cell_stop, or out of range", "cell_stop < cell_slow < 4 m");
  // The ramp may allow a speed only where the person is far enough for it.
  const nearfield::SpeedRamp<Q> ramp(settings.person_stop, settings.person_free);
  const Q step = Q::from_raw((settings.person_free - settings.person_stop).raw() / 1024 + 1);
  for (Q c = settings.person_stop; c < settings.person_free; c = c + step) {
    const Q allowed = ramp.override_for({ClearanceStatus::clear, c, {}});
    require(s.protective_distance(allowed) <= c, "slow_margin",
            "too small: at " + std::to_string(c.to_double()) + " m the arm would be faster than the distance allows",
            "the protective distance at the speed allowed must never exceed the clearance");
  }
}

}  // namespace

work_cell::WorkCell CompiledWorkCell::view() const {
  work_cell::WorkCell view = settings;
  view.arm = {span_of(arm.joints), span_of(arm.bodies),
              {span_of(arm_track.times), span_of(arm_track.values), arm_track.variables}};
  view.person = {span_of(person.joints), span_of(person.bodies),
                 {span_of(person_track.times), span_of(person_track.values), person_track.variables}};
  view.checked_against_cell = span_of(checked_against_cell);
  view.self_pairs = span_of(arm.self_pairs);
  view.cell_image = span_of(cell.image);
  view.soft_image = span_of(soft.image);
  return view;
}

CompiledWorkCell compile_work_cell(const SceneDescription& scene, const std::string& robot_file,
                                   const std::string& srdf_file) {
  const auto missing = [&scene](const std::string& key, const std::string& why) {
    throw InputError(scene.file, {}, key, "missing", why);
  };
  if (!scene.cycle) missing("cycle", "a simulation needs what the arm does");
  if (!scene.separation) missing("separation", "a simulation needs the distances to keep");

  CompiledWorkCell cell;
  RobotDescription robot = read_urdf(robot_file);
  if (!srdf_file.empty()) read_srdf(srdf_file, robot);
  cell.arm = compile_robot<Q>(robot, robot_file, !srdf_file.empty());
  if (cell.arm.bodies.empty()) {
    throw InputError(robot_file, {}, "robot", "no collision shapes", "at least one link needs one");
  }
  cell.arm_track = compile_track(scene.cycle->waypoints, cell.arm, scene.file, "cycle.waypoints");
  if (scene.person) {
    const RobotDescription person = read_urdf(scene.person->robot);
    cell.person = compile_robot<Q>(person, scene.person->robot, false);
    cell.person_track = compile_track(scene.person->path, cell.person, scene.file, "person.path");
  }

  // What stands on the table cannot keep clear of it.
  for (const nearfield::Body<Q>& body : cell.arm.bodies) {
    cell.checked_against_cell.push_back(cell.arm.fixed_to_root[body.link] ? 0 : 1);
  }
  const std::string tool = scene.tool_link.value_or(cell.arm.link_names.back());
  const std::size_t tool_link = cell.arm.find_link(tool);
  if (tool_link >= cell.arm.link_names.size()) {
    throw InputError(scene.file, {}, "tool_link", "the robot has no link `" + tool + "`",
                     "its links are " + list_of(cell.arm.link_names));
  }
  cell.settings.tool_link = static_cast<std::uint16_t>(tool_link);

  const SlotOfLink no_slots = [&scene](const FieldNode& node, const std::string&) -> std::uint32_t {
    throw InputError(scene.file, node.position, node.path + ".link", "the cell's field does not move",
                     "links are allowed below `soft`");
  };
  cell.cell = compile_field<Q>(scene.field, scene.file, no_slots);
  if (scene.soft) {
    cell.soft = compile_field<Q>(*scene.soft, scene.file, [&](const FieldNode& node, const std::string& link) {
      return slot_of(node, link, cell.person, scene.file);
    });
  }
  const auto refuse_parameters = [&scene](const CompiledField<Q>& field, const FieldNode& node) {
    if (field.inspection.parameter_count == 0) return;
    throw InputError(scene.file, node.position, node.path, "takes parameters", "a field of a work cell has none");
  };
  refuse_parameters(cell.cell, scene.field);
  if (scene.soft) refuse_parameters(cell.soft, *scene.soft);
  compile_separation(*scene.separation, scene.file, cell.settings);
  cell.settings.refinements = 12;
  cell.settings.tolerance = quantise<Q>(0.0001);
  cell.settings.ticks = static_cast<std::uint32_t>(std::llround(scene.duration * 1000.0));
  return cell;
}

}  // namespace nearfield::host
