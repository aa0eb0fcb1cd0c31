#include "compile/robot_compiler.hpp"

#include <algorithm>
#include <cmath>

#include "compile/quantise.hpp"
#include "text/input_error.hpp"

namespace nearfield::host {
namespace {

constexpr std::size_t most_bodies = 1000;

struct RealCapsule {
  Vector3d from, to;
  double radius = 0.0;
};

struct Cover {
  std::vector<RealCapsule> capsules;
  double stands_out = 0.0;  // m
};

// The box's two shorter edges span its cross-section; square-ish cells of it are covered by one capsule each, along
// the longest edge.
Cover cover_box(const Vector3d& size) {
  const double edges[3] = {size.x, size.y, size.z};
  int order[3] = {0, 1, 2};
  std::sort(order, order + 3, [&edges](int a, int b) { return edges[a] < edges[b]; });
  const double thin = edges[order[0]], wide = edges[order[1]], tall = edges[order[2]];
  const int cells = std::min(8, static_cast<int>(std::ceil(wide / thin)));
  const double cell = wide / cells;
  Cover cover;
  const double radius = 0.5 * std::hypot(thin, cell);
  for (int i = 0; i < cells; ++i) {
    double from[3] = {}, to[3] = {};
    from[order[1]] = to[order[1]] = (i + 0.5) * cell - 0.5 * wide;
    from[order[2]] = -0.5 * tall;
    to[order[2]] = 0.5 * tall;
    cover.capsules.push_back({{from[0], from[1], from[2]}, {to[0], to[1], to[2]}, radius});
  }
  cover.stands_out = radius;
  return cover;
}

Cover cover(const CollisionShape& shape) {
  const Vector3d half{0.0, 0.0, 0.5 * shape.length};
  switch (shape.kind) {
    case CollisionKind::sphere: return {{{{}, {}, shape.radius}}, 0.0};
    case CollisionKind::capsule: return {{{-1.0 * half, half, shape.radius}}, 0.0};
    case CollisionKind::cylinder: return {{{-1.0 * half, half, shape.radius}}, shape.radius};
    case CollisionKind::box: return cover_box(shape.size);
  }
  return {};
}

class Variables {
 public:
  explicit Variables(const RobotDescription& robot) : numbers_(robot.joints.size(), 0) {
    for (std::size_t i = 0; i < robot.joints.size(); ++i) {
      const Joint& joint = robot.joints[i];
      if (joint.kind == JointKind::fixed || joint.mimic) continue;
      numbers_[i] = names.size();
      names.push_back(joint.name);
    }
  }
  std::size_t of(const RobotDescription& robot, std::size_t joint) const {
    const std::optional<Mimic>& mimic = robot.joints[joint].mimic;
    return numbers_[mimic ? mimic->joint : joint];
  }
  std::vector<std::string> names;

 private:
  std::vector<std::size_t> numbers_;
};

template <class S>
nearfield::Joint<S> compile_joint(const Joint& joint, std::size_t parent, std::size_t variable) {
  nearfield::Joint<S> compiled;
  compiled.parent = static_cast<std::uint16_t>(parent);
  compiled.origin = quantise<S>(joint.origin);
  if (joint.kind == JointKind::fixed) return compiled;
  compiled.kind = joint.kind == JointKind::prismatic ? nearfield::JointKind::prismatic : nearfield::JointKind::revolute;
  compiled.variable = static_cast<std::uint16_t>(variable);
  compiled.axis = quantise_unit<S>(joint.axis);
  if (joint.mimic) {
    compiled.multiplier = quantise<S>(joint.mimic->multiplier);
    compiled.offset = quantise<S>(joint.mimic->offset);
  }
  if (joint.lower) compiled.lower = quantise<S>(*joint.lower);
  if (joint.upper) compiled.upper = quantise<S>(*joint.upper);
  return compiled;
}

}  // namespace

template <class S> std::size_t CompiledRobot<S>::find_link(const std::string& name) const {
  return static_cast<std::size_t>(std::find(link_names.begin(), link_names.end(), name) - link_names.begin());
}

template <class S>
CompiledRobot<S> compile_robot(const RobotDescription& robot, const std::string& file, bool checks_neighbours) {
  CompiledRobot<S> compiled;
  const Variables variables(robot);
  compiled.variable_names = variables.names;

  std::vector<std::size_t> number_of(robot.links.size(), 0);  // link number by index in the description
  compiled.link_names.push_back(robot.links[robot.root_link].name);
  compiled.fixed_to_root.push_back(true);
  std::vector<std::size_t> index_of{robot.root_link};
  std::set<std::pair<std::size_t, std::size_t>> unchecked = robot.unchecked_pairs;
  for (std::size_t i = 0; i < robot.joints.size(); ++i) {
    const Joint& joint = robot.joints[i];
    number_of[joint.child] = i + 1;
    index_of.push_back(joint.child);
    compiled.link_names.push_back(robot.links[joint.child].name);
    compiled.fixed_to_root.push_back(joint.kind == JointKind::fixed && compiled.fixed_to_root[number_of[joint.parent]]);
    compiled.joints.push_back(compile_joint<S>(joint, number_of[joint.parent], variables.of(robot, i)));
    if (!checks_neighbours) unchecked.insert(std::minmax(joint.parent, joint.child));
  }

  for (std::size_t number = 0; number < index_of.size(); ++number) {
    const Link& link = robot.links[index_of[number]];
    for (std::size_t i = 0; i < link.shapes.size(); ++i) {
      const CollisionShape& shape = link.shapes[i];
      const Cover covered = cover(shape);
      compiled.greatest_cover = std::max(compiled.greatest_cover, covered.stands_out);
      for (const RealCapsule& capsule : covered.capsules) {
        nearfield::Body<S> body;
        body.link = static_cast<std::uint16_t>(number);
        body.capsule = quantise_capsule<S>(transform_point(shape.origin, capsule.from),
                                           transform_point(shape.origin, capsule.to), capsule.radius);
        compiled.bodies.push_back(body);
      }
    }
  }

  // The same checks that firmware makes, so that a message can name the place.
  nearfield::Chain<S, most_links + 1, most_bodies> chain;
  const auto refuse = [&](const std::string& path, SourcePosition position, const std::string& what) {
    throw InputError(file, position, path, what,
                     "positions and lengths up to " +
                         std::to_string(ScalarTraits<S>::to_double(ScalarTraits<S>::domain())) + " m are allowed");
  };
  for (std::size_t i = 0; i < compiled.joints.size(); ++i) {
    chain.add_joint(compiled.joints[i]);
    const Joint& joint = robot.joints[i];
    if (!chain.valid()) refuse("robot/joint[" + joint.name + "]", joint.position, "does not fit the number range");
  }
  if (compiled.bodies.size() > most_bodies) {
    throw InputError(file, {}, "robot", std::to_string(compiled.bodies.size()) + " bodies",
                     "at most " + std::to_string(most_bodies) + " are allowed");
  }
  for (const nearfield::Body<S>& body : compiled.bodies) {
    chain.add_body(body);
    if (!chain.valid()) {
      const Link& link = robot.links[index_of[body.link]];
      refuse("robot/link[" + link.name + "]", link.position, "a collision shape does not fit the number range");
    }
  }

  for (std::size_t i = 0; i < compiled.bodies.size(); ++i) {
    for (std::size_t j = i + 1; j < compiled.bodies.size(); ++j) {
      const std::size_t a = compiled.bodies[i].link, b = compiled.bodies[j].link;
      if (a == b || unchecked.count(std::minmax(index_of[a], index_of[b])) != 0) continue;
      compiled.self_pairs.push_back({static_cast<std::uint16_t>(i), static_cast<std::uint16_t>(j)});
    }
  }
  return compiled;
}

template struct CompiledRobot<Fixed<27>>;
template CompiledRobot<Fixed<27>> compile_robot(const RobotDescription&, const std::string&, bool);

}  // namespace nearfield::host
