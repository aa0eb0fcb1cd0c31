// Fields as pictures see them: what is proved to be free is, rays do not jump over thin walls, boxes hold
// surfaces.
#include "render/ray_stepping.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "unit/render/scene_text.hpp"

namespace nearfield::host {
namespace {

double distance_to_segment(const Vector3d& p, const Vector3d& a, const Vector3d& b) {
  const Vector3d along = b - a;
  const double t = std::min(1.0, std::max(0.0, dot(p - a, along) / dot(along, along)));
  return length(p - (a + t * along));
}

TEST(SceneField, LevelsAndSides) {
  EXPECT_TRUE(field_of_text(ball_text)->inside({0.4, 0.0, 0.0}));
  EXPECT_FALSE(field_of_text(ball_text)->inside({0.6, 0.0, 0.0}));
  const auto soft = field_of_text(soft_text), ray = field_of_text(ray_text),
             torus = field_of_text(torus_text);
  EXPECT_EQ(soft->level(), 0.5);
  EXPECT_EQ(ray->level(), 0.5);
  EXPECT_EQ(torus->level(), 0.0);
  EXPECT_TRUE(soft->inside({}));
  EXPECT_TRUE(ray->inside({}));
  EXPECT_FALSE(torus->inside({}));
  EXPECT_TRUE(torus->inside({0.5, 0.0, 0.0}));
  // f rises outwards in every kind, per metre.
  for (const SceneField* field : {soft.get(), ray.get(), torus.get()}) {
    const Vector3d p{0.1, -0.28, 0.03}, step{1e-4, 2e-4, -1e-4};
    const FieldAnswer answer = field->at(p);
    EXPECT_NEAR(field->outward(p + step) - field->outward(p - step), 2.0 * dot(answer.gradient, step), 2e-6);
    EXPECT_EQ(answer.outward, field->outward(p));
  }
}

// Against the sign at random places within the ball.
TEST(SceneField, FreeBallsHaveOneSign) {
  std::mt19937 random(17);
  SCOPED_TRACE("seed 17");
  std::uniform_real_distribution<double> uniform(-1.0, 1.0);
  for (const std::string& text : {ball_text, soft_text, ray_text, blend_text}) {
    const auto field = field_of_text(text);
    ASSERT_TRUE(field->certified()) << text;
    int free = 0;
    for (int i = 0; i < 300; ++i) {
      const Vector3d p{1.2 * uniform(random), 1.2 * uniform(random), 1.2 * uniform(random)};
      const double radius = field->free_radius(p, 0.1);
      if (radius > 0.0) ++free;
      for (int k = 0; k < 20; ++k) {
        const Vector3d direction{uniform(random), uniform(random), uniform(random)};
        const double size = length(direction);
        if (!(size > 0.1)) continue;
        ASSERT_EQ(field->inside(p + radius / size * direction), field->inside(p)) << text << i;
      }
    }
    EXPECT_GT(free, 250) << text;
  }
}

TEST(SceneField, ClearanceOfABallIsNearlyAllOfIt) {
  const auto ball = field_of_text(ball_text),
             soft = field_of_text(R"({"type": "soft_point", "influence_radius": 0.6})");
  EXPECT_NEAR(ball->free_radius({1.5, 0.0, 0.0}, 1.0), 1.0, 1e-6);
  // The default potential is 1/2 at half of the influence radius.
  EXPECT_GT(soft->free_radius({2.3, 0.0, 0.0}, 1.9), 1.89);
  EXPECT_LE(soft->free_radius({2.3, 0.0, 0.0}, 1.9), 2.0);
}

TEST(RayStepping, NeverJumpsOverAThinPlate) {
  const auto plate = field_of_text(R"({"type": "box", "size": [2, 0.0005, 2]})");
  SteppingSettings settings;
  settings.stepping = stepping_for(*plate, 1e-4);
  ASSERT_EQ(settings.stepping, Stepping::certified);
  std::mt19937 random(18);
  SCOPED_TRACE("seed 18");
  std::uniform_real_distribution<double> uniform(-0.9, 0.9);
  for (int i = 0; i < 3000; ++i) {
    const Vector3d from{uniform(random), -1.0 - uniform(random), uniform(random)},
        at{uniform(random), 0.0, uniform(random)};
    const Ray ray{from, 1.0 / length(at - from) * (at - from)};
    const RayHit hit = first_hit(*plate, ray, stretch_within(ray, domain_box(*plate)), settings);
    ASSERT_TRUE(hit.hit) << i;
    ASSERT_EQ(hit.stepping, Stepping::certified);
    const Vector3d p = ray.at(hit.t);
    ASSERT_LE(p.y, -0.00025);
    ASSERT_GE(p.y, -0.00035);
  }
  // Fixed steps miss it: the test would notice.
  settings.stepping = Stepping::bisection;
  settings.fixed_step = 0.01;
  const Ray across{{0.003, -1.0, 0.0}, {0.0, 1.0, 0.0}};
  EXPECT_FALSE(first_hit(*plate, across, {0.0034, 2.0}, settings).hit);
}

TEST(RayStepping, RaysPastASolidMiss) {
  const auto ball = field_of_text(ball_text);
  SteppingSettings settings;
  for (const double off : {0.5001, 0.51, 1.0}) {
    const Ray ray{{off, -2.0, 0.0}, {0.0, 1.0, 0.0}};
    EXPECT_FALSE(first_hit(*ball, ray, stretch_within(ray, domain_box(*ball)), settings).hit) << off;
  }
  const Ray through{{0.3, -2.0, 0.0}, {0.0, 1.0, 0.0}};
  const RayHit hit = first_hit(*ball, through, stretch_within(through, domain_box(*ball)), settings);
  ASSERT_TRUE(hit.hit);
  EXPECT_NEAR(hit.t, 1.6, 1e-4);
  EXPECT_LE(hit.t, 1.6);
}

TEST(RayStepping, BisectionOfAFieldWithoutARate) {
  const auto torus = field_of_text(torus_text);
  ASSERT_EQ(stepping_for(*torus, 1e-3), Stepping::bisection);
  SteppingSettings settings;
  settings.stepping = Stepping::bisection;
  const Ray ray{{2.0, 0.0, 0.0}, {-1.0, 0.0, 0.0}};
  const RayHit hit = first_hit(*torus, ray, stretch_within(ray, domain_box(*torus)), settings);
  ASSERT_TRUE(hit.hit);
  EXPECT_EQ(hit.stepping, Stepping::bisection);
  EXPECT_NEAR(hit.t, 1.3, 1e-5);
}

TEST(RayStepping, LightIsWholeFarFromAndNoneBehindASolid) {
  const auto ball = field_of_text(ball_text);
  const auto light = [&](const Vector3d& from) {
    const Ray ray{from, {0.0, 0.0, 1.0}};
    return light_along(*ball, ray, stretch_within(ray, domain_box(*ball)), 0.05, {});
  };
  EXPECT_EQ(light({0.0, 0.0, -1.0}), 0.0);
  EXPECT_EQ(light({0.45, 0.0, -1.0}), 0.0);
  EXPECT_EQ(light({0.7, 0.0, -1.0}), 1.0);
  const double beside = light({0.52, 0.0, -1.0});
  EXPECT_GT(beside, 0.1);
  EXPECT_LT(beside, 0.9);
}

TEST(SurfaceBox, IsAboutTheSurface) {
  struct Known {
    std::string text;
    Vector3d low, high;
  };
  const Known all[] = {
      {ball_text, {-0.5, -0.5, -0.5}, {0.5, 0.5, 0.5}},
      {torus_text, {-0.7, -0.7, -0.2}, {0.7, 0.7, 0.2}},
      {R"({"type": "box", "size": [0.1, 0.001, 0.05], "position": [1, 2, 3]})",
       {0.95, 1.9995, 2.975},
       {1.05, 2.0005, 3.025}},
      {R"({"type": "soft_point", "influence_radius": 0.6, "position": [0, 0, 1]})",
       {-0.3, -0.3, 0.7},
       {0.3, 0.3, 1.3}},
      // A thin straw beside a ball, with a potential that tells nothing a little way off.
      {R"({"type": "soft_sum", "operands": [
                            {"type": "soft_point", "influence_radius": 1},
                            {"type": "potential_of_distance", "influence_radius": 0.16,
                             "potential": {"curve": "arctangent", "c1": 49}, "operands": [
                             {"type": "capsule", "from": [1, 0, 0], "to": [1, 0, 2], "radius": 0}]}]})",
       {-0.5, -0.5, -0.5},
       {1.08, 0.5, 2.08}},
      {R"({"type": "superquadric", "exponents": [1.2, 20], "semi_axes": [0.8, 0.4, 2.4]})",
       {-0.4, -0.2, -1.2},
       {0.4, 0.2, 1.2}},
      {R"({"type": "half_space", "normal": [0, 0, 1]})", {-4.0, -4.0, 0.0}, {4.0, 4.0, 0.0}}};
  for (const Known& known : all) {
    const auto field = field_of_text(known.text);
    const auto box = surface_box(*field, domain_box(*field));
    ASSERT_TRUE(box) << known.text;
    const double slack = (field->certified() ? 1.0 / 128.0 : 1.0 / 48.0) *
                         std::max({box->size().x, box->size().y, box->size().z});
    for (double Vector3d::*x : {&Vector3d::x, &Vector3d::y, &Vector3d::z}) {
      EXPECT_LE(box->low.*x, known.low.*x + 1e-9) << known.text;
      EXPECT_GE(box->low.*x, known.low.*x - slack) << known.text;
      EXPECT_GE(box->high.*x, known.high.*x - 1e-9) << known.text;
      EXPECT_LE(box->high.*x, known.high.*x + slack) << known.text;
    }
  }
  const auto none =
      field_of_text(R"({"type": "offset", "radius": -1, "operands": [{"type": "sphere", "radius": 0.5}]})");
  EXPECT_FALSE(surface_box(*none, domain_box(*none)));
}

// The soft surface of a lone segment is all within half of the influence radius of it.
TEST(RayStepping, MeetsSoftAndRaySurfaces) {
  const Vector3d from{-0.2, 0.0, 0.1}, to{0.3, 0.1, 0.0};
  const std::string ends = R"("from": [-0.2, 0, 0.1], "to": [0.3, 0.1, 0], "influence_radius": 0.4})";
  for (const std::string& text :
       {R"({"type": "soft_segment", )" + ends, R"({"type": "ray_segment", )" + ends}) {
    const auto field = field_of_text(text);
    SteppingSettings settings;
    settings.stepping = stepping_for(*field, 1e-4);
    ASSERT_EQ(settings.stepping, Stepping::certified) << text;
    for (double x = -0.15; x < 0.3; x += 0.05) {
      const Ray ray{{x, -2.0, 0.05}, {0.0, 1.0, 0.0}};
      const RayHit hit = first_hit(*field, ray, stretch_within(ray, domain_box(*field)), settings);
      ASSERT_TRUE(hit.hit) << text << x;
      EXPECT_EQ(hit.stepping, Stepping::certified) << text << x;
      EXPECT_NEAR(distance_to_segment(ray.at(hit.t), from, to), 0.2, 2e-4) << text << x;
    }
  }
}

}  // namespace
}  // namespace nearfield::host
