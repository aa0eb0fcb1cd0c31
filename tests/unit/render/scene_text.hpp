// Fields of scenes, for tests of pictures and meshes.
#pragma once

#include <memory>
#include <string>

#include "model/scene_reader.hpp"
#include "render/scene_field.hpp"

namespace nearfield::host {

// Of the text of a field's node.
inline std::unique_ptr<SceneField> field_of_text(const std::string& node,
                                                 FieldScalar scalar = FieldScalar::q27,
                                                 const std::vector<double>& parameters = {}) {
  const std::string text = R"({"format": "nearfield-scene-1", "name": "test", "field": )" + node + "}";
  return scene_field(parse_scene_of_any_kind(text, "test.json"), scalar, parameters);
}

inline const std::string ball_text = R"({"type": "sphere", "radius": 0.5})";
inline const std::string soft_text =
    R"({"type": "soft_sum", "operands": [{"type": "soft_point", "influence_radius": 0.6},
        {"type": "soft_segment", "from": [0.3, 0, 0.1], "to": [0.7, 0.2, 0.1], "influence_radius": 0.3}]})";
inline const std::string ray_text =
    R"({"type": "scale_union", "r1": 0.5, "r2": 0.5, "operands": [
        {"type": "ray_point", "influence_radius": 0.6},
        {"type": "ray_segment", "from": [0, 0, 0], "to": [0, 0.5, 0.5], "influence_radius": 0.3}]})";
inline const std::string torus_text =
    R"({"type": "algebraic_torus", "ring_radius": 0.5, "tube_radius": 0.2, "size": 0.4})";
inline const std::string blend_text =
    R"({"type": "exterior_union", "blend_radius": 0.1, "rising_range": 0.05, "operands": [
        {"type": "box", "size": [1, 0.6, 0.2]},
        {"type": "capsule", "from": [0.1, 0, 0], "to": [0.3, 0.1, 0.5], "radius": 0.1},
        {"type": "torus", "ring_radius": 0.2, "tube_radius": 0.08, "position": [-0.25, 0, 0.2]}]})";

}  // namespace nearfield::host
