// A node of every operator of the scene format. A new operator is a row here.
#pragma once

#include <map>
#include <string>
#include <string_view>

#include "model/operators.hpp"
#include "model/scene_reader.hpp"
#include "text/number.hpp"

namespace nearfield::host {

// Parameters of a node, as its object has them; its operands are made from what it takes.
inline const std::map<std::string_view, std::string> operator_rows = {
    {"sphere", "\"radius\": 0.3, \"position\": [0.1, 0, 0]"},
    {"capsule",
     "\"from\": [0, 0, 0], \"to\": [0.2, 0, 0.4], \"radius\": 0.2, "
     "\"rpy\": [0.1, 0.2, 0.3]"},
    {"box", "\"size\": [0.4, 0.5, 0.6], \"rpy\": [0.1, 0.2, 0.3]"},
    {"cylinder", "\"radius\": 0.3, \"height\": 0.4, \"position\": [0, 0.1, 0]"},
    {"polyline",
     "\"points\": [[0, 0, 0], [0.2, 0, 0.1], [0.2, 0.3, -0.4]], \"radius\": 0.1, "
     "\"rpy\": [0.1, 0.2, 0.3]"},
    {"polygon",
     "\"vertices\": [[0, 0], [0.5, 0], [0.5, 0.3], [0.1, 0.2]], \"position\": [-0.3, 0, 0]"},
    {"tapered_capsule",
     "\"from\": [0, 0, 0], \"to\": [0.2, 0, 0.4], \"radius_from\": 0.2, \"radius_to\": 0.1, "
     "\"rpy\": [0.1, 0.2, 0.3]"},
    {"cone_frustum", "\"radius_below\": 0.3, \"radius_above\": 0.1, \"height\": 0.4, \"rpy\": [0.1, 0.2, 0.3]"},
    {"torus", "\"ring_radius\": 0.4, \"tube_radius\": 0.1, \"rpy\": [0.1, 0.2, 0.3]"},
    {"disc", "\"radius\": 0.2, \"thickness\": 0.1, \"rpy\": [0.1, 0.2, 0.3]"},
    {"half_space", "\"normal\": [1, 2, 3], \"position\": [0, 0, -0.5]"},
    {"infinite_cylinder", "\"radius\": 0.2, \"position\": [0.1, 0, 0], \"rpy\": [0.1, 0.2, 0.3]"},
    {"infinite_cone", "\"half_angle\": 0.5, \"position\": [0, 0.1, 0], \"rpy\": [0.1, 0.2, 0.3]"},
    {"offset", "\"radius\": 0.1"},
    {"rounded_box", "\"size\": [0.4, 0.5, 0.6], \"radius\": 0.1, \"rpy\": [0.1, 0.2, 0.3]"},
    {"cubic_curve",
     "\"control_points\": [[0, 0, 0], [0.2, 0, 0.1], [0.3, 0.1, 0.2], [0.5, 0, 0]], \"halvings\": 1, "
     "\"radius\": 0.1, \"position\": [-0.2, 0.1, 0]"},
    {"bicubic_patch",
     "\"control_points\": [[0, 0, 0], [0, 0.2, 0], [0, 0.4, 0.1], [0, 0.6, 0.05], "
     "[0.2, 0, 0.1], [0.2, 0.2, 0.1], [0.2, 0.4, 0.2], [0.2, 0.6, 0.15], "
     "[0.4, 0, 0.05], [0.4, 0.2, 0.05], [0.4, 0.4, 0.15], [0.4, 0.6, 0.1], "
     "[0.6, 0, 0], [0.6, 0.2, 0], [0.6, 0.4, 0.1], [0.6, 0.6, 0.05]], \"radius\": 0.1, \"rpy\": [0.1, 0.2, 0.3]"},
    {"union", ""},
    {"intersection", ""},
    {"subtraction", ""},
    {"exterior_union", "\"blend_radius\": 0.3, \"rising_range\": 0.2"},
    {"exterior_intersection",
     "\"blend_radius\": 0.3, \"rising_range\": 0.2, "
     "\"step\": \"rising_cutoff\""},
    {"exterior_subtraction", "\"blend_radius\": 0.3, \"rising_range\": 0.2"},
    {"interior_union", "\"rising_range\": 0.4"},
    {"interior_intersection", "\"rising_range\": 0.4"},
    {"interior_subtraction", "\"rising_range\": 0.4, \"step\": \"rising_cutoff\""},
    {"log_sum_exp_union", "\"sharpness\": 20"},
    {"log_sum_exp_intersection", "\"sharpness\": 20"},
    {"log_sum_exp_subtraction", "\"sharpness\": 20"},
    {"quadratic_union", "\"blend_radius\": 0.4"},
    {"quadratic_intersection", "\"blend_radius\": 0.4"},
    {"quadratic_subtraction", "\"blend_radius\": 0.4"},
    {"cubic_union", "\"blend_radius\": 0.4"},
    {"cubic_intersection", "\"blend_radius\": 0.4"},
    {"cubic_subtraction", "\"blend_radius\": 0.4"},
    {"place", "\"position\": [0.1, 0, 0], \"rpy\": [0, 0, 1], \"scale\": 1.25"},
    {"soft_point", "\"influence_radius\": 1, \"weight\": 0.75"},
    {"soft_segment", "\"influence_radius\": 1, \"from\": [0, 0, 0], \"to\": [0.2, 0, 0.1]"},
    {"soft_sum", ""},
    {"intensity_union", ""},
    {"intensity_intersection", ""},
    {"ray_union", ""},
    {"ray_intersection", ""},
    {"potential_of_distance", "\"influence_radius\": 1"},
    {"potential_of_ray", "\"potential\": \"cubic\""},
    {"ray_point", "\"influence_radius\": 0.9, \"position\": [0.1, 0, 0]"},
    {"ray_segment", "\"influence_radius\": 0.9, \"from\": [0, 0, 0], \"to\": [0.2, 0, 0.1]"},
    {"ray_plane",
     "\"influence_radius\": 0.9, \"normal\": [1, 2, 3], "
     "\"position\": [0, 0, -0.5]"},
    {"lp_distance", "\"exponent\": 3, \"semi_axes\": [0.8, 0.9, 1], \"rpy\": [0.1, 0.2, 0.3]"},
    {"ray_slab", "\"influence_radius\": 0.9, \"normal\": [1, 2, 3], \"position\": [0, 0, -0.5]"},
    {"ray_of_distance", "\"influence_radius\": 0.9"},
    {"box_metric", "\"semi_axes\": [0.8, 0.9, 1], \"rpy\": [0.1, 0.2, 0.3]"},
    {"generalised_distance",
     "\"exponent\": 4, \"influence_radius\": 0.9, \"normals\": [[1, 0, 0], [0, 1, 1], [-1, 1, 0.5]]"},
    {"superquadric", "\"exponents\": [0.6, 3], \"semi_axes\": [1.8, 1.9, 1], \"rpy\": [0.1, 0.2, 0.3]"},
    {"ray_sweep",
     "\"exponents\": [4, 2], \"semi_axes\": [0.8, 0.9, 1], \"length\": 0.5, \"twist\": 0.7, "
     "\"end_scale\": 0.8, \"position\": [0.1, 0, 0], \"rpy\": [0.1, 0.2, 0.3]"},
    {"algebraic_sphere", "\"radius\": 0.3, \"position\": [0.1, 0.2, 0]"},
    {"algebraic_cylinder", "\"radius\": 0.3, \"size\": 0.6, \"position\": [0.1, 0, 0], \"rpy\": [0.1, 0.2, 0.3]"},
    {"algebraic_cone", "\"half_angle\": 0.6, \"position\": [0.1, 0, 0], \"rpy\": [0.1, 0.2, 0.3]"},
    {"algebraic_torus", "\"ring_radius\": 0.5, \"tube_radius\": 0.2, \"rpy\": [0.1, 0.2, 0.3]"},
    {"variable_influence", "\"inner_range\": 0.5"},
    {"super_ellipsoidal_union", "\"exponent\": 3"},
    {"super_ellipsoidal_intersection", "\"exponent\": 3"},
    {"super_ellipsoidal_difference", "\"exponent\": 3"},
    {"scale_union", "\"r1\": 0.5, \"r2\": 0.6, \"p\": 0.1"},
    {"scale_intersection", "\"r1\": 0.5, \"r2\": 0.6, \"p\": 0.1"},
    {"algebraic_plane", "\"normal\": [1, 0.5, 0.25], \"offset\": 0.5"},
    {"quadric",
     "\"diagonal\": [1, 1, 0.5], \"off_diagonal\": [0.1, 0, 0], "
     "\"constant\": -1"},
    {"declared_box", "\"size\": [3, 3, 3]"},
    {"algebraic_of_distance", "\"factor\": 2"},
    {"algebraic_of_ray", ""},
    {"algebraic_union", ""},
    {"algebraic_intersection", ""},
    {"hoffmann_hopcroft_union", "\"r1\": 0.5, \"r2\": 0.6, \"p\": 0.1"},
    {"hoffmann_hopcroft_intersection", "\"r1\": 0.5, \"r2\": 0.6, \"p\": 0.1"},
    {"hoffmann_hopcroft_difference", "\"r1\": 0.5, \"r2\": 0.6, \"p\": 0.1"},
    {"liming", "\"lambda\": 0.5"},
    {"functional_spline", "\"lambda\": 0.5, \"primaries\": 1"},
    {"morph", "\"parameter_slot\": 0"},
    {"intensity_morph", "\"parameter_slot\": 0"},
    {"ray_morph", "\"parameter_slot\": 0"},
    {"swell", "\"radius\": 0.25, \"parameter_slot\": 0"},
    {"fade", "\"parameter_slot\": 0"},
    {"ribbon_patch", "\"side_weights\": [1, 0.5], \"centre_weight\": 0.25"},
    {"corner_patch", "\"side_weights\": [1, 0.5, 0.75], \"exponent\": 3"},
    {"noise_distance", "\"amplitude\": 0.05, \"frequency\": 2.5, \"octaves\": 3, \"seed\": 7"},
    {"noise_intensity", "\"amplitude\": 0.5, \"frequency\": 2.5"},
    {"scale_along", "\"from\": [0, 0, -0.5], \"to\": [0.1, 0, 0.5], \"values\": [1, 0.8, 1.3, 1.1]"},
    {"scale_about", "\"values\": [1, 1.2, 0.9, 1.1, 1], \"core\": 0.2, \"twist\": 1.5"},
    {"scale_from_axis", "\"limit\": 0.75, \"values\": [1, 1.4, 0.9]"},
};

// A leaf of a kind, one of several different ones.
inline std::string leaf(FieldKind kind, std::size_t which) {
  const std::string at = "\"position\": [" + format_number(0.4 * static_cast<double>(which % 3)) + ", " +
                         format_number(0.1 * static_cast<double>(which)) + ", 0]";
  switch (kind) {
    case FieldKind::distance:
      return "{\"type\": \"sphere\", \"radius\": 0.3, " + at + "}";
    case FieldKind::intensity:
      return "{\"type\": \"soft_point\", \"influence_radius\": 1, " + at + "}";
    case FieldKind::ray:
      return "{\"type\": \"ray_point\", \"influence_radius\": 0.8, " + at + "}";
    case FieldKind::algebraic:
      break;
  }
  return "{\"type\": \"algebraic_plane\", \"normal\": [1, " +
         format_number(0.5 * static_cast<double>(which)) + ", -1], \"offset\": 0.2}";
}

inline std::string node_text(const OperatorDescription& row, std::size_t operand_count,
                             FieldKind operand_kind) {
  std::string text = "{\"type\": \"" + std::string(row.name) + "\"";
  if (const std::string& parameters = operator_rows.at(row.name); !parameters.empty())
    text += ", " + parameters;
  if (row.most_operands > 0) {
    text += ", \"operands\": [";
    for (std::size_t i = 0; i < operand_count; ++i) text += (i > 0 ? ",\n" : "\n") + leaf(operand_kind, i);
    text += "]";
  }
  return text + "}";
}

inline std::string scene_of(const std::string& node) {
  return "{\"format\": \"nearfield-scene-1\", \"name\": \"a\", \"field\":\n" + node + "}";
}

inline FieldNode field_of(const std::string& node) {
  return parse_scene_of_any_kind(scene_of(node), "scene").field;
}

}  // namespace nearfield::host
