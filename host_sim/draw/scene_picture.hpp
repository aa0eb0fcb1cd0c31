#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "draw/contour.hpp"
#include "draw/page_transform.hpp"
#include "draw/style.hpp"

namespace nearfield::host::draw {

/// A point or vector of the world, metres; z up.
using Vec3 = std::array<double, 3>;

/// All points within `radius` (metres) of the segment from `start` to `end`; a ball when they coincide.
struct PictureCapsule {
  Vec3 start{};
  Vec3 end{};
  double radius = 0.0;
};

/// The two points that are nearest to each other, and the clearance to write beside them, metres.
struct NearestPair {
  Vec3 on_robot{};
  Vec3 on_other{};
  double clearance = 0.0;
  Vec3 away{};  ///< direction in which the robot's point gets clear, any length; zero: from on_other to
                ///< on_robot
};

/// An arrow from `at` to `at + vector`, metres.
struct RepulsionArrow {
  Vec3 at{};
  Vec3 vector{};
};

/// What one panel shows of the field: its values (metres, negative inside) on the cutting plane, over the
/// panel's own two axes, and the part of the plane to show. Without samples the panel has no field.
struct SceneView {
  std::string title;
  WorldWindow window;
  SampledGrid field;
};

/// One clearance of the caption; `to` as in "to the person". Not finite: written as "unknown".
struct NamedClearance {
  std::string to;
  double clearance = 0.0;
};

/// One moment of a run: a top view (x right, y up) beside a side view (x right, z up), at the same scale.
struct ScenePicture {
  std::string title;
  std::string letter;  ///< the marker on the timeline; may be empty
  double time = 0.0;   ///< seconds
  Zone zone = Zone::free;
  double speed_override = 1.0;  ///< 0..1
  std::vector<NamedClearance> clearances;
  std::string note;  ///< one more sentence of the caption; may be empty

  SceneView top;
  SceneView side;
  double contour_spacing = 0.1;    ///< metres between contour lines, above zero
  std::size_t contour_count = 6;   ///< contour lines outside the surface, at most 40
  std::size_t labelled_every = 2;  ///< every how many lines one is labelled, at least 1
  std::string field_name = "cell";

  std::vector<PictureCapsule> arm;
  std::vector<Vec3> joints;
  std::vector<PictureCapsule> person;
  std::optional<NearestPair> nearest;
  std::optional<RepulsionArrow> repulsion;
  std::vector<Vec3> tool_path;
  std::string id_prefix = "scene";  ///< letters and digits, different for each picture of a page
};

/// The picture as an SVG document 1000 pixels wide. Throws std::invalid_argument when a window is empty, a
/// number is not finite (samples of a field may be) or a setting is out of its range.
std::string scene_picture_svg(const ScenePicture& picture);

}  // namespace nearfield::host::draw
