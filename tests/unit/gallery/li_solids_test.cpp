// The gallery's figures 12 to 15 after Li: what their captions say, and that their surfaces are closed.
#include <gtest/gtest.h>

#include <cmath>

#include "unit/gallery/gallery_field.hpp"
#include "unit/render/mesh_checks.hpp"

namespace nearfield::host {
namespace {

double surface_near(const SceneField& field, const Vector3d& from, const Vector3d& direction) {
  return surface_along(field, from, direction, 0.4);
}

TEST(GalleryLi, TheBulgeSticksOutAndTheContractionGoesIn) {
  const FieldPointer bulge = gallery_field("li/bulge.json"),
                     contraction = gallery_field("li/contraction.json");
  const double radius = 0.13, half = std::sqrt(0.5);
  const Vector3d up{0.0, 0.0, 1.0}, corner{half, half, 0.0};
  // Above the crossing and in the corner between the rods, where both are equally near.
  EXPECT_GT(surface_near(*bulge, {}, up), radius + 0.05);
  EXPECT_GT(surface_near(*bulge, {}, corner), radius / half + 0.05);
  EXPECT_NEAR(surface_near(*contraction, {}, up), radius, 1e-6);
  EXPECT_NEAR(surface_near(*contraction, {}, corner), radius / half, 1e-6);
  // Beside the crossing, on a rod.
  const Vector3d beside{0.2, 0.0, 0.0};
  EXPECT_GT(surface_near(*bulge, beside, up), radius + 0.005);
  EXPECT_LT(surface_near(*contraction, beside, up), radius - 0.01);
  // Far from it both are the rod.
  const Vector3d far{0.54, 0.0, 0.0};
  EXPECT_NEAR(surface_near(*bulge, far, up), radius, 1e-6);
  EXPECT_NEAR(surface_near(*contraction, far, up), radius, 1e-6);
}

TEST(GalleryLi, TheDigitIsAStrokeWithHalfTheRipplesOfItsBalls) {
  const FieldPointer stroke = gallery_field("li/digit.json"), balls = gallery_field("li/digit_balls.json");
  const SceneDescription scene = gallery_scene("li/digit.json");
  const std::vector<FieldNode>& operands = scene.field.operands;
  ASSERT_EQ(operands.size(), 30U);
  double least_valley = 1.0, greatest_ripple = 0.0, sharp_valley = 1.0;
  const Vector3d away{0.0, -1.0, 0.0};  // the curve lies in the plane y = 0
  for (std::size_t i = 0; i + 1 < operands.size(); ++i) {
    const Vector3d here = operands[i].placement.position, next = operands[i + 1].placement.position;
    EXPECT_EQ(operands[i].number("radius"), 0.045);
    if (i < 13 || i > 17) {  // the two arcs meet there, and more than two balls
      const double crest = surface_near(*stroke, here, away),
                   valley = surface_near(*stroke, 0.5 * (here + next), away);
      greatest_ripple = std::max(greatest_ripple, std::abs(crest - valley));
      least_valley = std::min(least_valley, valley);
      sharp_valley = std::min(sharp_valley, surface_near(*balls, 0.5 * (here + next), away));
    }
  }
  EXPECT_LT(sharp_valley, 0.031);
  EXPECT_GT(least_valley, 0.045);
  EXPECT_LT(greatest_ripple, 0.5 * (0.045 - sharp_valley));
  std::printf("stroke at least %.4f m with ripples of %.4f m, balls down to %.4f m of 0.045 m\n", least_valley,
              greatest_ripple, sharp_valley);
  for (const Vector3d& p : plane_points(0.4, 0.1)) {
    const Vector3d q{p.x, 0.02, p.y};
    EXPECT_LE(stroke->outward(q), balls->outward(q) + stroke->proof().error + balls->proof().error);
  }
}

struct Solid {
  const char* name;
  Box3 box;
  long euler;  // characteristic
};

TEST(GalleryLi, SolidsAreClosedAndOnTheSurface) {
  const std::vector<Solid> all = {{"bulge", {{-0.8, -0.8, -0.3}, {0.8, 0.8, 0.3}}, 2},
                                  {"contraction", {{-0.8, -0.8, -0.3}, {0.8, 0.8, 0.3}}, 2},
                                  {"digit", {{-0.4, -0.1, -0.6}, {0.4, 0.1, 0.6}}, 2}};
  for (const Solid& solid : all) {
    SCOPED_TRACE(solid.name);
    const FieldPointer field = gallery_field(std::string("li/") + solid.name + ".json");
    ASSERT_TRUE(field->certified());
    const SurfaceMesh mesh = gallery_mesh(*field, solid.box, 40);
    EXPECT_GT(mesh.triangles.size(), 1000U);
    EXPECT_EQ(expect_closed(mesh), solid.euler);
    expect_on_surface(*field, mesh);
  }
}

TEST(GalleryLi, TheTeapotIsClosedAndHasOneHandle) {
  const FieldPointer field = gallery_field("li/teapot.json");
  const SurfaceMesh mesh = gallery_mesh(*field, {{-0.75, -0.5, -0.1}, {0.95, 0.5, 1.1}}, 72);
  EXPECT_EQ(expect_closed(mesh), 0);  // of a solid with one hole
  expect_on_surface(*field, mesh);
  // One can pour through the spout.
  EXPECT_FALSE(field->inside({0.69, 0.0, 0.6}));
}

TEST(GalleryLi, TheSnailIsClosed) {
  const FieldPointer field = gallery_field("li/snail.json");
  const SurfaceMesh mesh = gallery_mesh(*field, {{-0.7, -0.8, -0.4}, {0.7, 0.6, 0.8}}, 48);
  EXPECT_GT(mesh.triangles.size(), 1000U);
  expect_closed(mesh);
  expect_on_surface(*field, mesh);
}

}  // namespace
}  // namespace nearfield::host
