#include "model/scene_reader.hpp"

#include <array>
#include <filesystem>
#include <utility>

#include "model/field_reader.hpp"
#include "model/json_values.hpp"
#include "model/limits.hpp"
#include "text/input_error.hpp"
#include "text/json.hpp"
#include "text/json_node.hpp"
#include "text/read_file.hpp"

namespace nearfield::host {
namespace {

constexpr NumberRange time_range{0.0, 3600.0, "s"};
constexpr NumberRange duration_range{0.0, 3600.0, "s", true};
constexpr NumberRange distance_range{0.0, 16.0, "m"};
constexpr NumberRange speed_range{0.0, 10.0, "m/s"};
constexpr NumberRange delay_range{0.0, 60.0, "s"};
constexpr NumberRange share_range{0.0, 1.0, {}};
constexpr std::size_t most_waypoints = 10000;

std::string read_file_name(const JsonNode& node) {
  const std::filesystem::path scene_folder = std::filesystem::path(node.file()).parent_path();
  return (scene_folder / node.string(longest_path)).string();
}

enum class Events { refused, allowed };

Waypoint read_waypoint(const JsonNode& node, Events events) {
  if (events == Events::allowed) {
    node.reject_unknown_keys({"time", "joints", "event"});
  } else {
    node.reject_unknown_keys({"time", "joints"});
  }
  Waypoint waypoint;
  waypoint.position = node.position();
  waypoint.time = node.required("time", "a number in s").number(time_range);
  waypoint.joints = read_joint_values(node.required("joints", "joint values by name"));
  if (const auto event = node.optional("event")) waypoint.event = event->string(longest_name);
  return waypoint;
}

bool same_joints(const Waypoint& a, const Waypoint& b) {
  if (a.joints.size() != b.joints.size()) return false;
  for (const auto& [name, value] : a.joints) {
    if (b.joints.count(name) == 0) return false;
  }
  return true;
}

std::vector<Waypoint> read_waypoints(const JsonNode& array, Events events) {
  std::vector<Waypoint> waypoints;
  for (const JsonNode& node : array.elements(2, most_waypoints)) {
    Waypoint waypoint = read_waypoint(node, events);
    if (!waypoints.empty()) {
      const double last = waypoints.back().time;
      if (waypoint.time <= last) {
        node.required("time").fail(format_number(waypoint.time) + " is not later than the one before",
                                   "above " + format_number(last) + " s");
      }
      if (!same_joints(waypoints.front(), waypoint)) {
        node.required("joints").fail("other joints than in the first waypoint", "the same joints in each");
      }
    }
    waypoints.push_back(std::move(waypoint));
  }
  return waypoints;
}

PersonDescription read_person(const JsonNode& node) {
  node.reject_unknown_keys({"robot", "path"});
  return {read_file_name(node.required("robot", "a URDF file")),
          read_waypoints(node.required("path", "an array of waypoints"), Events::refused)};
}

CycleDescription read_cycle(const JsonNode& node) {
  node.reject_unknown_keys({"waypoints"});
  const JsonNode array = node.required("waypoints", "an array of waypoints");
  CycleDescription cycle{read_waypoints(array, Events::allowed)};
  const std::vector<JsonNode> nodes = array.elements(2, most_waypoints);
  if (cycle.waypoints.front().time != 0.0) {
    nodes.front().required("time").fail("the cycle does not start at 0", "0 s");
  }
  if (cycle.waypoints.back().joints != cycle.waypoints.front().joints) {
    nodes.back().required("joints").fail("the cycle does not end where it starts",
                                         "the joint values of the first waypoint");
  }
  return cycle;
}

struct SeparationKey {
  std::string_view key;
  double SeparationDescription::*member;
  NumberRange range;
};

constexpr std::array<SeparationKey, 12> separation_keys{{
    {"human_speed", &SeparationDescription::human_speed, speed_range},
    {"robot_speed", &SeparationDescription::robot_speed, speed_range},
    {"reaction_time", &SeparationDescription::reaction_time, delay_range},
    {"stopping_time", &SeparationDescription::stopping_time, delay_range},
    {"stopping_distance", &SeparationDescription::stopping_distance, distance_range},
    {"intrusion_distance", &SeparationDescription::intrusion_distance, distance_range},
    {"human_uncertainty", &SeparationDescription::human_uncertainty, distance_range},
    {"robot_uncertainty", &SeparationDescription::robot_uncertainty, distance_range},
    {"slow_override", &SeparationDescription::slow_override, share_range},
    {"slow_margin", &SeparationDescription::slow_margin, distance_range},
    {"cell_stop", &SeparationDescription::cell_stop, distance_range},
    {"cell_slow", &SeparationDescription::cell_slow, distance_range},
}};

SeparationDescription read_separation(const JsonNode& node) {
  SeparationDescription separation;
  std::vector<std::string_view> keys;
  for (const SeparationKey& key : separation_keys) keys.push_back(key.key);
  node.reject_unknown_keys(keys);
  for (const SeparationKey& key : separation_keys) {
    separation.*key.member = node.required(key.key, "a number " + describe(key.range)).number(key.range);
  }
  if (separation.cell_slow <= separation.cell_stop) {
    node.required("cell_slow")
        .fail(format_number(separation.cell_slow) + " is not above cell_stop",
              "above " + format_number(separation.cell_stop) + " m");
  }
  return separation;
}

// A link of the person can only be meant where there is a person.
void check_person_links(const FieldNode& field, const SceneDescription& scene) {
  if (field.link && field.link->rfind("person/", 0) == 0 && !scene.person) {
    throw InputError(scene.file, field.position, field.path + ".link",
                     "link of a person, but the scene has none",
                     "a \"person\" in the scene, or a link of the arm");
  }
  for (const FieldNode& operand : field.operands) check_person_links(operand, scene);
}

enum class Use { simulation, evaluation };

SceneDescription read(std::string_view text, const std::string& file, Use use) {
  const JsonDocument document = parse_json(text, file);
  const JsonNode root(document);
  root.required("format", "\"nearfield-scene-1\"").choice({"nearfield-scene-1"});
  root.reject_unknown_keys({"format", "name", "field", "soft", "robot", "tool_link", "person", "cycle",
                            "separation", "duration"});
  SceneDescription scene;
  scene.file = file;
  scene.name = root.required("name", "the scene's name").string(longest_name);
  if (use == Use::simulation || root.has("duration")) {
    scene.duration = root.required("duration", "a number " + describe(duration_range)).number(duration_range);
  }
  if (use == Use::simulation) {
    scene.field = read_field(root.required("field", "a node that yields a distance"), FieldKind::distance);
  } else {
    scene.field = read_field(root.required("field", "a node"), std::nullopt);
  }
  if (const auto node = root.optional("soft")) scene.soft = read_field(*node, FieldKind::intensity);
  if (const auto node = root.optional("robot")) scene.robot = read_file_name(*node);
  if (const auto node = root.optional("tool_link")) scene.tool_link = node->string(longest_name);
  if (const auto node = root.optional("person")) scene.person = read_person(*node);
  if (const auto node = root.optional("cycle")) scene.cycle = read_cycle(*node);
  if (const auto node = root.optional("separation")) scene.separation = read_separation(*node);
  check_person_links(scene.field, scene);
  if (scene.soft) check_person_links(*scene.soft, scene);
  return scene;
}

}  // namespace

SceneDescription parse_scene(std::string_view text, const std::string& file) {
  return read(text, file, Use::simulation);
}
SceneDescription parse_scene_of_any_kind(std::string_view text, const std::string& file) {
  return read(text, file, Use::evaluation);
}

SceneDescription read_scene(const std::string& path) { return parse_scene(read_file(path), path); }
SceneDescription read_scene_of_any_kind(const std::string& path) {
  return parse_scene_of_any_kind(read_file(path), path);
}

}  // namespace nearfield::host
