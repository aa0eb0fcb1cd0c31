// Skeletons with exact distances, each with a radius that rounds it.
#pragma once

#include <nearfield/shape/bicubic_patch.hpp>
#include <nearfield/shape/cubic_curve.hpp>
#include <nearfield/shape/polygon.hpp>
#include <nearfield/shape/polyline.hpp>

#include "compile/field_emitter.hpp"
#include "model/field_node.hpp"
#include "operators/description.hpp"

namespace nearfield::host::operators {

inline ParameterDescription optional_radius() {
  return fitting(Fit::number, {"radius", 1, {0.0, 16.0, "m"}, {0.0}});
}
// `fewest` to `most` arrays of `dimensions` coordinates.
inline ParameterDescription required_points(std::string_view key, std::size_t dimensions, std::size_t fewest,
                                            std::size_t most) {
  ParameterDescription points{key, dimensions, position_range};
  points.most_points = most;
  points.fewest_points = fewest;
  return points;
}

// Points of a skeleton in the frame of the operation, as payloads have them.
struct SkeletonPoints {
  std::vector<Vector3d> points;

  // Those of a node as `key`, refused where one does not fit the scalar.
  SkeletonPoints(const FieldEmitter& emitter, const FieldNode& node, const std::string& key) {
    for (const Vector3d& point : node.points(key)) {
      const std::string place = key + "[" + std::to_string(points.size()) + "]";
      points.push_back(transform_point(node.placement, point));
      emitter.require_coordinates(node, place, points.back());
    }
  }
  template <class S>
  std::vector<nearfield::Vector3<S>> in() const {
    std::vector<nearfield::Vector3<S>> rounded;
    for (const Vector3d& point : points) rounded.push_back(quantise<S>(point));
    return rounded;
  }
  int count() const { return static_cast<int>(points.size()); }
};

// Control points that follow each other: refused where a coordinate differs by more than half the domain.
inline void require_near(const FieldEmitter& emitter, const FieldNode& node, const Vector3d& a,
                         const Vector3d& b) {
  const double longest = emitter.limits().domain / 2.0;
  const Vector3d edge = b - a;
  for (const double difference : {edge.x, edge.y, edge.z}) {
    if (difference <= longest && difference >= -longest) continue;
    emitter.refuse(node, "control_points",
                   emitter.misfit(difference) + " between the coordinates of two that follow",
                   "at most " + format_number(longest) + " m");
  }
}

struct PolylineOperator {
  static constexpr std::size_t most_points = kGreatestSegmentCount + 1;
  static OperatorDescription description() {
    return shape("polyline", FieldKind::distance,
                 {required_points("points", 3, 2, most_points), optional_radius()},
                 PlacementParts::position_and_orientation);
  }
  static void add(FieldEmitter& emitter, const FieldNode& node) {
    const SkeletonPoints points(emitter, node, "points");
    const double radius = node.number("radius");
    emitter.operation([&](auto zero) {
      using S = decltype(zero);
      return Polyline<S>(points.in<S>().data(), points.count(), quantise<S>(radius));
    });
  }
};

// In the local xy plane.
struct PolygonOperator {
  static constexpr std::size_t most_vertices = kGreatestVertexCount;
  static OperatorDescription description() {
    ParameterDescription vertices = fitting(Fit::number, required_points("vertices", 2, 3, most_vertices));
    return shape("polygon", FieldKind::distance, {std::move(vertices), optional_radius()},
                 PlacementParts::position_and_orientation);
  }
  static void add(FieldEmitter& emitter, const FieldNode& node) {
    const std::vector<double>& vertices = node.parameters.at("vertices");
    const int count = static_cast<int>(vertices.size() / 2);
    const double radius = node.number("radius");
    emitter.placed(node.placement, [&](const Vector3d& at) {
      emitter.operation([&](auto zero) {
        using S = decltype(zero);
        S x[kGreatestVertexCount] = {}, y[kGreatestVertexCount] = {};
        for (int i = 0; i < count; ++i) {
          const auto first = static_cast<std::size_t>(2 * i);
          x[i] = quantise<S>(at.x + vertices[first]);
          y[i] = quantise<S>(at.y + vertices[first + 1]);
          emitter.require_coordinates(node, "vertices[" + std::to_string(i) + "]",
                                      {at.x + vertices[first], at.y + vertices[first + 1], at.z});
        }
        const Polygon<S> polygon(x, y, count, quantise<S>(at.z), quantise<S>(radius));
        if (!polygon.is_simple()) {
          emitter.refuse(node, "vertices",
                         "two edges meet, or one has no length, once rounded to the number type",
                         "a simple polygon of an area above 0");
        }
        return polygon;
      });
    });
  }
};

// A chain of Bezier segments or a uniform cubic B-spline. The certified error is proportional to how much
// segments bend: `halvings` of all segments make it 4 and 16 times less.
struct CubicCurveOperator {
  static constexpr std::size_t most_points = CubicCurve<float>::greatest_control_count;
  static constexpr int most_segments = kGreatestCurveSegmentCount;
  static OperatorDescription description() {
    OperatorDescription description = shape("cubic_curve", FieldKind::distance,
                                            {required_points("control_points", 3, 4, most_points),
                                             optional_radius(),
                                             {"halvings", 1, {0.0, 2.0, {}}, {0.0}, {}, true}},
                                            PlacementParts::position_and_orientation);
    description.choices = {{"form", {"bezier", "b_spline"}}};
    return description;
  }
  static void add(FieldEmitter& emitter, const FieldNode& node) {
    SkeletonPoints points(emitter, node, "control_points");
    if (node.choices.at("form") == "b_spline") {
      require_count(emitter, node, points, points.count() - 3, "4 to 7 points of a B-spline");
      points.points = bezier_of_spline(points.points);
    } else if (points.count() % 3 != 1) {
      require_count(emitter, node, points, 0, "4, 7, 10 or 13 points of Bezier segments");
    }
    const int halvings = static_cast<int>(node.number("halvings"));
    require_count(emitter, node, points, (points.count() / 3) << halvings,
                  "at most 4 segments, halved ones counted twice");
    for (int i = 0; i < halvings; ++i) points.points = halved(points.points);
    for (std::size_t i = 1; i < points.points.size(); ++i)
      require_near(emitter, node, points.points[i - 1], points.points[i]);
    const double radius = node.number("radius");
    emitter.operation([&](auto zero) {
      using S = decltype(zero);
      return CubicCurve<S>(points.in<S>().data(), points.count(), quantise<S>(radius));
    });
  }

 private:
  static void require_count(const FieldEmitter& emitter, const FieldNode& node, const SkeletonPoints& points,
                            int segments, const std::string& allowed) {
    if (segments >= 1 && segments <= most_segments) return;
    emitter.refuse(node, "control_points", std::to_string(points.count()) + " of them", allowed);
  }
  static std::vector<Vector3d> bezier_of_spline(const std::vector<Vector3d>& spline) {
    std::vector<Vector3d> bezier;
    for (std::size_t i = 0; i + 2 < spline.size(); ++i) {
      const Vector3d &a = spline[i], &b = spline[i + 1], &c = spline[i + 2];
      bezier.push_back((1.0 / 6.0) * (a + 4.0 * b + c));
      if (i + 3 == spline.size()) break;
      bezier.push_back((1.0 / 3.0) * (2.0 * b + c));
      bezier.push_back((1.0 / 3.0) * (b + 2.0 * c));
    }
    return bezier;
  }
  // Each segment as two.
  static std::vector<Vector3d> halved(const std::vector<Vector3d>& bezier) {
    std::vector<Vector3d> finer{bezier.front()};
    const auto middle = [](const Vector3d& a, const Vector3d& b) { return 0.5 * (a + b); };
    for (std::size_t i = 0; i + 3 < bezier.size(); i += 3) {
      const Vector3d ab = middle(bezier[i], bezier[i + 1]), bc = middle(bezier[i + 1], bezier[i + 2]),
                     cd = middle(bezier[i + 2], bezier[i + 3]);
      const Vector3d abc = middle(ab, bc), bcd = middle(bc, cd);
      finer.insert(finer.end(), {ab, abc, middle(abc, bcd), bcd, cd, bezier[i + 3]});
    }
    return finer;
  }
};

// A Bezier patch of 4 by 4 control points, those of one row after the other.
struct BicubicPatchOperator {
  static constexpr std::size_t point_count = BicubicPatch<float>::control_count;
  static OperatorDescription description() {
    return shape("bicubic_patch", FieldKind::distance,
                 {required_points("control_points", 3, point_count, point_count), optional_radius()},
                 PlacementParts::position_and_orientation);
  }
  static void add(FieldEmitter& emitter, const FieldNode& node) {
    const SkeletonPoints control(emitter, node, "control_points");
    const std::vector<Vector3d>& points = control.points;
    for (std::size_t i = 0; i < point_count; ++i) {
      if (i % 4 != 0) require_near(emitter, node, points[i - 1], points[i]);
      if (i >= 4) require_near(emitter, node, points[i - 4], points[i]);
    }
    const double radius = node.number("radius");
    emitter.operation([&](auto zero) {
      using S = decltype(zero);
      return BicubicPatch<S>(control.in<S>().data(), quantise<S>(radius));
    });
  }
};

}  // namespace nearfield::host::operators
