#include "compile/work_cell_source.hpp"

#include <set>

#include <nearfield/field/image.hpp>

namespace nearfield::host {
namespace {

std::string text_of(std::int64_t number) { return std::to_string(number); }

template <int F> std::string text_of(Fixed<F> number) {
  return "Fixed<" + std::to_string(F) + ">::from_raw(" + std::to_string(number.raw()) + ")";
}
template <class T> std::string text_of(const nearfield::Vector3<T>& v) {
  return "{" + text_of(v.x) + ", " + text_of(v.y) + ", " + text_of(v.z) + "}";
}
std::string text_of(const nearfield::Pose<Q>& pose) {
  return "{{{" + text_of(pose.rotation.row[0]) + ", " + text_of(pose.rotation.row[1]) + ", " +
         text_of(pose.rotation.row[2]) + "}}, " + text_of(pose.translation) + "}";
}
std::string text_of(const nearfield::Joint<Q>& joint) {
  return "{static_cast<JointKind>(" + std::to_string(static_cast<int>(joint.kind)) + "), " + std::to_string(joint.parent) +
         ", " + std::to_string(joint.variable) + ",\n    " + text_of(joint.origin) + ",\n    " + text_of(joint.axis) + ", " +
         text_of(joint.multiplier) + ", " + text_of(joint.offset) + ", " + text_of(joint.lower) + ", " +
         text_of(joint.upper) + "}";
}
std::string text_of(const nearfield::Body<Q>& body) {
  const nearfield::Capsule<Q>& c = body.capsule;
  return "{" + std::to_string(body.link) + ", Capsule<Q>(Vector3<Q>" + text_of(c.from) + ", Vector3<Fixed<30>>" +
         text_of(c.axis) + ", " + text_of(c.length) + ", " + text_of(c.radius) + ")}";
}
std::string text_of(const nearfield::BodyPair& pair) {
  return "{" + std::to_string(pair.first) + ", " + std::to_string(pair.second) + "}";
}

// A constant array and, for the aggregate, the span that refers to it.
class Source {
 public:
  template <class T> std::string span(const std::string& type, const std::string& name, const std::vector<T>& values) {
    if (values.empty()) return "{}";
    text_ += "inline constexpr " + type + " " + name + "[] = {\n";
    for (const T& value : values) text_ += "  " + text_of(value) + ",\n";
    text_ += "};\n";
    return "{" + name + ", " + std::to_string(values.size()) + "}";
  }
  std::string robot(const std::string& name, const CompiledRobot<Q>& robot, const CompiledTrack& track) {
    const std::string joints = span("Joint<Q>", "k" + name + "Joints", robot.joints);
    const std::string bodies = span("Body<Q>", "k" + name + "BodyList", robot.bodies);
    const std::string times = span("uint32_t", "k" + name + "Times", track.times);
    const std::string values = span("Q", "k" + name + "Values", track.values);
    text_ += "inline constexpr int k" + name + "Links = " + std::to_string(robot.joints.size() + 1) + ", k" + name +
             "Bodies = " + std::to_string(robot.bodies.empty() ? 1 : robot.bodies.size()) + ";\n";
    return "{" + joints + ", " + bodies + ", {" + times + ", " + values + ", " + std::to_string(track.variables) + "}}";
  }
  void line(const std::string& text) { text_ += text + "\n"; }
  const std::string& text() const { return text_; }

 private:
  std::string text_;
};

const char* name_of(Operation operation) {
  switch (operation) {
#define NEARFIELD_NAME(code, name, type) \
  case Operation::name: return #name;
    NEARFIELD_OPERATIONS(NEARFIELD_NAME)
#undef NEARFIELD_NAME
    case Operation::enter_scale: return "enter_scale";
    default: return nullptr;  // of a frame
  }
}

void add_operations(const std::vector<std::uint32_t>& image, std::set<std::string>& names) {
  if (image.empty()) return;
  for (std::size_t at = image_format::header_words + image[image_format::table_words]; at < image.size();
       at += 1 + (image[at] >> 8)) {
    if (const char* name = name_of(static_cast<Operation>(image[at] & 0xffU))) names.insert(name);
  }
}
// Those of both images, so that the target links no others.
std::string operations_of(const CompiledWorkCell& cell) {
  std::set<std::string> names;
  add_operations(cell.cell.image, names);
  add_operations(cell.soft.image, names);
  std::string text;
  for (const std::string& name : names) text += (text.empty() ? "" : ", ") + ("Operation::" + name);
  return "OnlyOperations<" + text + ">";
}

}  // namespace

std::string work_cell_source(const CompiledWorkCell& cell, const std::string& made_from) {
  Source source;
  source.line("// Made by `nearfield bake` from " + made_from + ". Not to be edited.");
  source.line("#pragma once\n\nnamespace nearfield::work_cell {\n");
  const std::string arm = source.robot("Arm", cell.arm, cell.arm_track);
  const std::string person = source.robot("Person", cell.person, cell.person_track);
  const std::string checked = source.span("uint8_t", "kCheckedAgainstCell", cell.checked_against_cell);
  const std::string pairs = source.span("BodyPair", "kSelfPairs", cell.arm.self_pairs);
  const std::string cell_image = source.span("uint32_t", "kCellImage", cell.cell.image);
  const std::string soft_image = source.span("uint32_t", "kSoftImage", cell.soft.image);
  source.line("using Operations = " + operations_of(cell) + ";");
  const work_cell::WorkCell& s = cell.settings;
  source.line("\ninline constexpr WorkCell kWorkCell = {");
  for (const std::string& part : {arm, person, checked, pairs, cell_image, soft_image}) source.line("  " + part + ",");
  source.line("  " + std::to_string(s.tool_link) + ", " + std::to_string(s.refinements) + ", " + text_of(s.tolerance) + ",");
  source.line("  " + text_of(s.person_stop) + ", " + text_of(s.person_free) + ", " + text_of(s.cell_stop) + ", " +
              text_of(s.cell_free) + ",");
  source.line("  " + std::to_string(s.ticks) + "};\n\n}  // namespace nearfield::work_cell");
  return source.text();
}

}  // namespace nearfield::host
