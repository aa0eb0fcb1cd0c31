// The gallery's chapter on robots: its poses are those of the simulation, its morph goes from soft to hard.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "unit/gallery/gallery_field.hpp"
#include "unit/render/mesh_checks.hpp"

namespace nearfield::host {
namespace {

const char* const moment = "robotics/moment.json";

struct Rod {
  Vector3d from, to;
  double radius;
};

// The spheres and capsules of an operand.
std::vector<Rod> rods_of(std::size_t operand) {
  const SceneDescription scene = gallery_scene(moment);
  std::vector<Rod> rods;
  for (const FieldNode& node : scene.field.operands.at(operand).operands) {
    const bool ball = node.parameters.count("from") == 0;
    rods.push_back({ball ? node.placement.position : node.vector("from"),
                    ball ? node.placement.position : node.vector("to"), node.number("radius")});
  }
  return rods;
}

// The least of a field less a rod's radius along the rod's axis, by 2000 places.
double clearance_of(const Rod& rod, const SceneField& field) {
  double least = 1e9;
  for (int i = 0; i <= 2000; ++i) {
    const double t = i / 2000.0;
    least = std::min(least, field.outward((1.0 - t) * rod.from + t * rod.to) - rod.radius);
  }
  return least;
}

double clearance_of(const std::vector<Rod>& rods, const SceneField& field) {
  double least = 1e9;
  for (const Rod& rod : rods) least = std::min(least, clearance_of(rod, field));
  return least;
}

// What the README prints of `./run sim`: 233.367 mm to the person at 13.000 s.
TEST(GalleryRobotics, ArmAndPersonAreWhereTheSimulationHasThem) {
  ASSERT_EQ(rods_of(1).size(), 10U);
  ASSERT_EQ(rods_of(2).size(), 7U);
  EXPECT_NEAR(clearance_of(rods_of(1), *gallery_operand(moment, 2)), 0.233367, 2e-5);
}

TEST(GalleryRobotics, ItsCellIsThatOfTheSimulation) {
  const FieldPointer cell = gallery_operand(moment, 0), original = gallery_field("../work_cell.json");
  double worst = 0.0;
  for (const Vector3d& p : plane_points(1.5, 0.05)) {
    const Vector3d at{p.x, p.y, 0.2 * p.x + 0.1};
    worst = std::max(worst, std::abs(cell->outward(at) - original->outward(at)));
  }
  EXPECT_EQ(worst, 0.0);
}

TEST(GalleryRobotics, TheFieldIsTheLeastOfItsParts) {
  const FieldPointer all = gallery_field(moment);
  std::vector<FieldPointer> parts;
  for (std::size_t i = 0; i < 3; ++i) parts.push_back(gallery_operand(moment, i));
  for (const Vector3d& p : plane_points(1.5, 0.25)) {
    const Vector3d at{p.x, p.y, 0.3};
    double least = 1e9;
    for (const FieldPointer& part : parts) least = std::min(least, part->outward(at));
    EXPECT_NEAR(all->outward(at), least, 1e-7);
  }
  EXPECT_TRUE(all->certified());
}

TEST(GalleryRobotics, TheMorphGoesFromSoftToHard) {
  const std::vector<double> frames = {0.0, 0.15, 0.3, 0.45, 0.6, 0.75, 0.9, 1.0};
  std::vector<Vector3d> places;
  for (double x = -0.3; x <= 0.75; x += 0.035) {
    for (double y = -0.35; y <= 0.35; y += 0.035) {
      for (double z = -0.75; z <= 1.15; z += 0.035) places.push_back({x, y, z});
    }
  }
  std::vector<double> before(places.size(), -1e9);
  std::size_t inside_before = places.size();
  for (const double x : frames) {
    const FieldPointer field = gallery_field("robotics/morph.json", {x});
    std::size_t inside = 0;
    for (std::size_t i = 0; i < places.size(); ++i) {
      const double f = field->outward(places[i]);
      ASSERT_GE(f, before[i] - 1e-6) << x;  // nowhere does it grow
      before[i] = f;
      inside += f < 0.0 ? 1 : 0;
    }
    EXPECT_LT(inside, inside_before) << x;
    inside_before = inside;
  }
  EXPECT_GT(inside_before, 1000U);
}

TEST(GalleryRobotics, EndsOfTheMorphAreItsOperands) {
  const FieldPointer soft = gallery_field("robotics/morph.json", {0.0}),
                     hard = gallery_field("robotics/morph.json", {1.0});
  const FieldPointer sum = gallery_operand("robotics/morph.json", 0),
                     most = gallery_operand("robotics/morph.json", 1);
  for (const Vector3d& p : plane_points(0.4, 0.05)) {
    const Vector3d at{p.x, 0.3 * p.y, 0.6 + p.y};
    EXPECT_NEAR(soft->outward(at), sum->outward(at), 1e-7);
    EXPECT_NEAR(hard->outward(at), most->outward(at), 1e-7);
  }
  // The neck: filled by the sum, free between head and torso.
  const Vector3d neck{0.11, 0.0, 0.745};
  EXPECT_TRUE(soft->inside(neck));
  EXPECT_FALSE(hard->inside(neck));
}

TEST(GalleryRobotics, SurfacesAreClosed) {
  const FieldPointer soft = gallery_field("robotics/morph.json", {0.0});
  const SurfaceMesh mesh = gallery_mesh(*soft, {{-0.35, -0.45, -0.95}, {0.8, 0.45, 1.25}}, 48);
  EXPECT_GT(mesh.triangles.size(), 1000U);
  expect_closed(mesh);
  expect_on_surface(*soft, mesh);
  const FieldPointer cell = gallery_field("../work_cell.json");
  const SurfaceMesh of_cell = gallery_mesh(*cell, {{-0.7, -1.0, -0.9}, {1.1, 1.0, 0.9}}, 64);
  EXPECT_GT(of_cell.triangles.size(), 1000U);
  expect_closed(of_cell);
  expect_on_surface(*cell, of_cell);
}

}  // namespace
}  // namespace nearfield::host
