// Pictures: a ball's outline and normals, the same bytes by any number of threads, what is cut off.
#include "render/renderer.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "render/view.hpp"
#include "unit/render/scene_text.hpp"

namespace nearfield::host {
namespace {

constexpr double pi = 3.14159265358979323846;
constexpr Colour red{0.8, 0.05, 0.05};  // the sky and the ground are not

RenderSettings settings_for(const SceneField& field, std::size_t width, std::size_t height) {
  RenderSettings settings;
  settings.width = width;
  settings.height = height;
  settings.colour = red;
  settings.drawn = domain_box(field);
  settings.surface = surface_box(field, settings.drawn).value_or(settings.drawn);
  settings.camera = camera_framing(settings.surface, 35.0, width, height);
  settings.threads = 1;
  return settings;
}

bool is_red(const draw::RgbImage& image, std::size_t x, std::size_t y) {
  const std::uint8_t* pixel = image.bytes.data() + 3 * (y * image.width + x);
  return pixel[0] > pixel[2] + 12;
}
std::size_t red_pixels(const draw::RgbImage& image) {
  std::size_t count = 0;
  for (std::size_t y = 0; y < image.height; ++y) {
    for (std::size_t x = 0; x < image.width; ++x) count += is_red(image, x, y) ? 1U : 0U;
  }
  return count;
}

void expect_circle(const std::string& text, Stepping stepping) {
  const auto field = field_of_text(text);
  RenderSettings settings = settings_for(*field, 160, 120);
  settings.camera = {{0.3, -1.9, 0.5}, {}, 36.0};
  const Rendering rendering = render(*field, settings);
  EXPECT_EQ(rendering.stepping, stepping) << text;
  EXPECT_EQ(rendering.bisected_rays == 0, stepping == Stepping::certified) << text;
  const double distance = length(settings.camera.from);
  const double pixels_a_tangent = 60.0 / std::tan(18.0 * pi / 180.0);
  const double radius = pixels_a_tangent * std::tan(std::asin(0.5 / distance));
  EXPECT_NEAR(static_cast<double>(red_pixels(rendering.image)) / (pi * radius * radius), 1.0, 0.01) << text;
}

TEST(Renderer, OutlineOfABallIsACircle) { expect_circle(ball_text, Stepping::certified); }
TEST(Renderer, OutlineOfASoftBallIsACircle) {
  expect_circle(R"({"type": "soft_point", "influence_radius": 1})", Stepping::certified);
}
TEST(Renderer, OutlineOfARayBallIsACircle) {
  expect_circle(R"({"type": "ray_point", "influence_radius": 1})", Stepping::certified);
}
// Its values saturate in the domain, so that no rate is known.
TEST(Renderer, OutlineOfAnAlgebraicBallIsACircle) {
  expect_circle(R"({"type": "algebraic_sphere", "radius": 0.5, "size": 1})", Stepping::bisection);
}

TEST(Renderer, NormalsAreThoseOfTheSolid) {
  const auto field =
      field_of_text(R"({"type": "capsule", "from": [0, 0, 0], "to": [0, 0, 1], "radius": 0.25})");
  std::mt19937 random(31);
  SCOPED_TRACE("seed 31");
  std::uniform_real_distribution<double> uniform(0.0, 1.0);
  for (int i = 0; i < 200; ++i) {
    const double angle = 2.0 * pi * uniform(random), height = uniform(random);
    const Vector3d normal{std::cos(angle), std::sin(angle), 0.0};
    const Vector3d found = surface_normal(*field, 0.25 * normal + Vector3d{0.0, 0.0, height}, 1e-4).direction;
    ASSERT_LT(length(found - normal), 1e-6);
  }
}

// A ball times 256, 4 for each of four planes far away: the gradient's components saturate on its surface.
const std::string steep_text = [] {
  const std::string plane = R"({"type": "algebraic_plane", "normal": [0, 0, 1], "offset": -4}, )";
  return R"({"type": "functional_spline", "lambda": 0.0001, "primaries": 5, "operands": [
             {"type": "algebraic_sphere", "radius": 0.5, "size": 0.25}, )" +
         plane + plane + plane + plane + R"({"type": "algebraic_plane", "normal": [0, 0, 1], "offset": 0}]})";
}();

TEST(Renderer, SaturatedGradientsAreFoundAndReplaced) {
  const auto steep = field_of_text(steep_text), wide = field_of_text(steep_text, FieldScalar::single);
  std::size_t saturated = 0;
  for (int i = 0; i < 100; ++i) {
    const double z = -0.99 + 0.02 * i, r = std::sqrt(1.0 - z * z), angle = 2.4 * i;
    const Vector3d normal{r * std::cos(angle), r * std::sin(angle), z};
    const SurfaceNormal found = surface_normal(*steep, 0.5 * normal, 1e-3);
    saturated += found.gradient_saturated ? 1U : 0U;
    EXPECT_GT(dot(found.direction, normal), 0.999) << i;
    EXPECT_FALSE(surface_normal(*wide, 0.5 * normal, 1e-3).gradient_saturated) << i;
  }
  EXPECT_GT(saturated, 90U);
  RenderSettings settings = settings_for(*field_of_text(ball_text), 32, 24);
  EXPECT_EQ(render(*field_of_text(ball_text), settings).saturated_gradients, 0U);
  const Rendering rendering = render(*steep, settings);
  EXPECT_GT(rendering.saturated_gradients, rendering.surface_rays / 2);
}

TEST(Renderer, SameBytesWithAnyNumberOfThreads) {
  for (const std::string& text : {blend_text, soft_text}) {
    const auto field = field_of_text(text);
    RenderSettings settings = settings_for(*field, 32, 24);
    settings.ground = settings.surface.low.z;
    const Rendering one = render(*field, settings);
    for (const unsigned threads : {2U, 3U}) {
      settings.threads = threads;
      const Rendering other = render(*field, settings);
      EXPECT_EQ(other.image.bytes, one.image.bytes) << threads;
      EXPECT_EQ(other.rays, one.rays);
    }
  }
}

TEST(Renderer, FramesAllOfTheSurface) {
  for (const std::string& text : {ball_text, torus_text, ray_text, blend_text}) {
    const auto field = field_of_text(text);
    const RenderSettings settings = settings_for(*field, 40, 30);
    const draw::RgbImage image = render(*field, settings).image;
    const std::size_t red_count = red_pixels(image);
    EXPECT_GT(red_count, 40U * 30U / 12U) << text;
    for (std::size_t x = 0; x < image.width; ++x)
      EXPECT_FALSE(is_red(image, x, 0) || is_red(image, x, 29)) << text;
    for (std::size_t y = 0; y < image.height; ++y)
      EXPECT_FALSE(is_red(image, 0, y) || is_red(image, 39, y)) << text;
  }
}

TEST(Renderer, ThinPlateCoversWhatIsBehindIt) {
  const auto field = field_of_text(R"({"type": "box", "size": [1, 0.0005, 1]})");
  RenderSettings settings = settings_for(*field, 50, 50);
  settings.camera = {{0.7, -2.0, 0.4}, {0.0, 0.0, 0.0}, 12.0};  // the picture is within the plate
  const Rendering rendering = render(*field, settings);
  EXPECT_EQ(red_pixels(rendering.image), 2500U);
  EXPECT_EQ(rendering.bisected_rays, 0U);
}

TEST(Renderer, GroundShowsTheShadow) {
  const auto field = field_of_text(R"({"type": "sphere", "radius": 0.3, "position": [0, 0, 0.6]})");
  RenderSettings settings = settings_for(*field, 120, 90);
  settings.ground = 0.0;
  settings.camera = {{0.0, -0.01, 4.0}, {0.0, 0.0, 0.0}, 40.0};
  const auto darkest = [&](const Rendering& rendering) {
    int least = 255;
    for (std::size_t i = 0; i < rendering.image.bytes.size(); i += 3) {
      if (rendering.image.bytes[i] < rendering.image.bytes[i + 2] + 13)
        least = std::min<int>(least, rendering.image.bytes[i]);
    }
    return least;
  };
  EXPECT_LT(darkest(render(*field, settings)), 180);
  settings.ground = -40.0;  // too far away for a shadow
  EXPECT_GT(darkest(render(*field, settings)), 200);
}

// Of a ball cut through its middle, the face shows.
TEST(Renderer, CutFacesShowLayers) {
  const auto field = field_of_text(ball_text);
  RenderSettings settings = settings_for(*field, 80, 60);
  settings.drawn = {{-1.0, 0.0, -1.0}, {1.0, 1.0, 1.0}};
  settings.camera = {{0.0, -3.0, 0.0}, {0.0, 0.0, 0.0}, 30.0};
  const draw::RgbImage plain = render(*field, settings).image;
  settings.bands = even_bands(0.1);
  const draw::RgbImage bands = render(*field, settings).image;
  EXPECT_NE(plain.bytes, bands.bytes);
  // Six layers from the middle outwards: the shade rises and falls.
  int turns = 0, last = 0;
  for (std::size_t x = 41; x < 60; ++x) {
    const int step = bands.bytes[3 * (30 * 80 + x) + 2] - bands.bytes[3 * (30 * 80 + x - 1) + 2];
    if (step * last < 0) ++turns;
    if (step != 0) last = step;
  }
  EXPECT_GE(turns, 6);
}

TEST(View, MiddleAndCorners) {
  const View view({{1.0, 2.0, 3.0}, {1.0, 5.0, 3.0}, 90.0}, 200, 100);
  EXPECT_LT(length(view.ray(100.0, 50.0).direction - Vector3d{0.0, 1.0, 0.0}), 1e-12);
  EXPECT_LT(length(view.ray(100.0, 0.0).direction - std::sqrt(0.5) * Vector3d{0.0, 1.0, 1.0}), 1e-12);
  EXPECT_LT(length(view.ray(150.0, 50.0).direction - std::sqrt(0.5) * Vector3d{1.0, 1.0, 0.0}), 1e-12);
  const View down({{0.0, 0.0, 2.0}, {}, 40.0}, 100, 100);
  EXPECT_LT(length(down.right() - Vector3d{1.0, 0.0, 0.0}), 1e-12);
}

TEST(Colour, RoundTrips) {
  for (const char* text : {"#000000", "#FFFFFF", "#95aeca", "#01027f"}) {
    const auto colour = colour_of(text);
    ASSERT_TRUE(colour);
    char back[32];
    std::snprintf(back, sizeof back, "#%02x%02x%02x", srgb_byte(colour->red), srgb_byte(colour->green),
                  srgb_byte(colour->blue));
    EXPECT_STRCASEEQ(back, text);
  }
  for (const char* text : {"", "#12345", "#1234567", "123456#", "#12345g"})
    EXPECT_FALSE(colour_of(text)) << text;
}

TEST(Bands, AreEven) {
  const Bands bands({{1.0, 2.0 * pi / 0.05}});
  for (int k = 0; k < 10; ++k) {
    EXPECT_NEAR(bands.shade(0.05 * k), 1.0, 1e-9);
    EXPECT_NEAR(bands.shade(0.05 * k + 0.025), 0.0, 1e-9);
    EXPECT_NEAR(bands.shade(0.05 * k + 0.0125), 0.5, 1e-9);
  }
  const Bands two({{3.0, 1.0}, {1.0, 7.0}});
  EXPECT_NEAR(two.shade(0.4), (3.0 * (std::cos(0.4) + 1.0) + std::cos(2.8) + 1.0) / 8.0, 1e-12);
}

}  // namespace
}  // namespace nearfield::host
