// Fields of the scenes that the gallery draws, and of parts of them.
#pragma once

#include <gtest/gtest.h>

#include <filesystem>
#include <initializer_list>
#include <memory>
#include <string>
#include <vector>

#include "model/scene_reader.hpp"
#include "render/scene_field.hpp"
#include "render/surface_mesh.hpp"

namespace nearfield::host {

using FieldPointer = std::unique_ptr<SceneField>;

// A scene as the gallery's commands name it, `li/teapot.json`, found from this file's own place in the source
// tree.
inline SceneDescription gallery_scene(const std::string& name) {
  const std::filesystem::path folder =
      std::filesystem::path(__FILE__).parent_path() / "../../../host_sim/scenes/gallery";
  return read_scene_of_any_kind((folder / name).string());
}

inline FieldPointer gallery_field(const std::string& name, const std::vector<double>& parameters = {}) {
  return scene_field(gallery_scene(name), FieldScalar::q27, parameters);
}

// The field of one operand of a scene's outermost node.
inline FieldPointer gallery_operand(const std::string& name, std::size_t index) {
  SceneDescription scene = gallery_scene(name);
  FieldNode operand = scene.field.operands.at(index);
  scene.field = std::move(operand);
  return scene_field(scene, FieldScalar::q27);
}

// A blend of two operands and the operands.
struct GalleryBlend {
  FieldPointer blend, first, second;
  double error;  // m: greater than the certified ones of all three together

  explicit GalleryBlend(const std::string& name)
      : blend(gallery_field(name)),
        first(gallery_operand(name, 0)),
        second(gallery_operand(name, 1)),
        error(blend->proof().error + first->proof().error + second->proof().error) {}

  double of_union(const Vector3d& p) const { return std::min(first->outward(p), second->outward(p)); }
  double of_intersection(const Vector3d& p) const { return std::max(first->outward(p), second->outward(p)); }
  double of_subtraction(const Vector3d& p) const { return std::max(first->outward(p), -second->outward(p)); }
};

// How far from `from`, which is inside, the surface lies in a direction of length 1; m.
inline double surface_along(const SceneField& field, const Vector3d& from, const Vector3d& direction,
                            double reach = 1.5) {
  double low = 0.0, high = reach;
  EXPECT_TRUE(field.inside(from));
  EXPECT_FALSE(field.inside(from + high * direction));
  for (int i = 0; i < 40; ++i)
    (field.inside(from + 0.5 * (low + high) * direction) ? low : high) = 0.5 * (low + high);
  return low;
}

// Places of a grid in the plane z = 0, `step` m apart, within `reach` m of the origin each way.
inline std::vector<Vector3d> plane_points(double reach, double step) {
  std::vector<Vector3d> points;
  for (double x = -reach; x <= reach; x += step) {
    for (double y = -reach; y <= reach; y += step) points.push_back({x, y, 0.0});
  }
  return points;
}

// The surface within a box, by `resolution` cells along its longest edge.
inline SurfaceMesh gallery_mesh(const SceneField& field, const Box3& box, std::size_t resolution) {
  MeshSettings settings;
  settings.box = box;
  settings.resolution = resolution;
  settings.threads = 1;
  return mesh_of(field, settings).mesh;
}

}  // namespace nearfield::host
