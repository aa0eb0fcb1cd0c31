// Where a field's surface lies, so that pictures and meshes show all of it.
#pragma once

#include <optional>

#include "render/scene_field.hpp"

namespace nearfield::host {

// An upright box, m.
struct Box3 {
  Vector3d low, high;

  Vector3d middle() const { return 0.5 * (low + high); }
  Vector3d size() const { return high - low; }
  bool contains(const Vector3d& p) const {
    return p.x >= low.x && p.x <= high.x && p.y >= low.y && p.y <= high.y && p.z >= low.z && p.z <= high.z;
  }
};

Box3 grown(const Box3& box, double by);
Box3 intersection(const Box3& a, const Box3& b);
// All points that the field accepts.
Box3 domain_box(const SceneField& field);

// A box about the field's surface within `search`, as large as the surface or larger by up to 1/128 of its
// longest edge, 1/48 without a proof; nothing when no surface is found. What is proved to be free of it is
// passed over. Where nothing is proved the first-order distance and signs at corners decide, so that it may
// miss what is smaller than 1/64 of the search's longest edge, of rays and algebraic fields 1/16. Cost: a few
// 100 000 evaluations.
std::optional<Box3> surface_box(const SceneField& field, const Box3& search);

}  // namespace nearfield::host
