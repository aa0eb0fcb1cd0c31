#include "model/problems.hpp"

#include "model/json_values.hpp"
#include "model/limits.hpp"
#include "text/json.hpp"
#include "text/json_node.hpp"
#include "text/read_file.hpp"

namespace nearfield::host {
namespace {

constexpr std::size_t most_problems = 100000;
constexpr std::size_t most_objects = 1000;
constexpr std::int64_t largest_index = 1000000000;

CollisionShape read_object(const JsonNode& node) {
  CollisionShape shape;
  shape.position = node.position();
  const std::size_t kind = node.required("type").choice({"box", "cylinder", "sphere"});
  if (kind == 0) {
    node.reject_unknown_keys({"name", "type", "position", "orientation_xyzw", "size"});
    shape.kind = CollisionKind::box;
    const std::vector<double> size = node.required("size").numbers(3, size_range);
    shape.size = {size[0], size[1], size[2]};
  } else if (kind == 1) {
    node.reject_unknown_keys({"name", "type", "position", "orientation_xyzw", "height", "radius"});
    shape.kind = CollisionKind::cylinder;
    shape.length = node.required("height").number(size_range);
    shape.radius = node.required("radius").number(size_range);
  } else {
    node.reject_unknown_keys({"name", "type", "position", "orientation_xyzw", "radius"});
    shape.kind = CollisionKind::sphere;
    shape.radius = node.required("radius").number(size_range);
  }
  if (const auto name = node.optional("name")) shape.name = name->string(longest_name);
  node.required("position", "three numbers in m");
  shape.origin = read_placement(node, PlacementParts::position_and_orientation);
  return shape;
}

Problem read_problem(const JsonNode& node) {
  node.reject_unknown_keys({"set", "index", "objects", "start", "goal"});
  Problem problem;
  problem.set = node.required("set").string(longest_name);
  problem.index = node.required("index").integer(0, largest_index);
  for (const JsonNode& object : node.required("objects").elements(0, most_objects)) {
    problem.objects.push_back(read_object(object));
  }
  const JsonNode start = node.required("start"), goal = node.required("goal");
  problem.start = read_joint_values(start);
  problem.start_position = start.position();
  problem.goal = read_joint_values(goal);
  problem.goal_position = goal.position();
  return problem;
}

}  // namespace

std::vector<Problem> parse_problems(std::string_view text, const std::string& file) {
  const JsonDocument document = parse_json(text, file);
  std::vector<Problem> problems;
  for (const JsonNode& node : JsonNode(document).elements(0, most_problems)) {
    problems.push_back(read_problem(node));
  }
  return problems;
}

std::vector<Problem> read_problems(const std::string& path) { return parse_problems(read_file(path), path); }

}  // namespace nearfield::host
