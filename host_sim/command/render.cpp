#include <cstdio>

#include "command/command.hpp"
#include "command/drawing.hpp"
#include "command/field_options.hpp"
#include "command/progress.hpp"
#include "draw/number_text.hpp"
#include "draw/png.hpp"
#include "render/renderer.hpp"
#include "text/input_error.hpp"
#include "text/read_file.hpp"

namespace nearfield::host {
namespace {

const char* const usage = "nearfield render SCENE --output FILE.png";

void print_help() {
  std::printf(
      "usage: %s [OPTION...]\n\n"
      "A picture of the surface of a scene's field, of any kind, by the evaluator of the target. Rays "
      "advance by what is\n"
      "certified to be free, and cannot jump over anything; where the field's certificate tells nothing, by "
      "fixed steps and\n"
      "bisection, which may. The line that is printed says which. Robots are at rest, as for `nearfield "
      "eval`.\n\n%s",
      usage, describe(render_options()).c_str());
}

void place_camera(const Options& options, const SceneDescription& scene, const SceneField& field,
                  RenderSettings& settings) {
  settings.drawn = box_of(options, field).value_or(domain_box(field));
  const auto surface = surface_box(field, settings.drawn);
  if (!surface) {
    throw InputError(scene.file, scene.field.position, scene.field.path,
                     std::string("no surface is found") + (options.has("box") ? " within --box" : ""),
                     "the field is " + format_number(field.level()) + " nowhere from -" +
                         format_number(field.domain()) + " to " + format_number(field.domain()) + " m");
  }
  settings.surface = *surface;
  const double field_of_view = number_of(options, "field-of-view", {1.0, 150.0, "degrees"}).value_or(35.0);
  settings.camera = camera_framing(*surface, field_of_view, settings.width, settings.height);
  const Vector3d back = settings.camera.from - settings.camera.at;
  if (const auto at = vector_of(options, "look-at")) {
    settings.camera.at = *at;
    settings.camera.from = *at + back;
  }
  if (const auto from = vector_of(options, "camera")) settings.camera.from = *from;
  const Vector3d& from = settings.camera.from;
  if (!(length(settings.camera.at - from) > 1e-6))
    throw UsageError("--camera and --look-at are the same point");
  if (settings.drawn.contains(from) && field.inside(from))
    throw UsageError("--camera lies inside the surface");
}

void place_ground(const Options& options, const SceneField& field, RenderSettings& settings) {
  const auto text = options.value("ground");
  if (text && *text == "none") return;
  if (text) {
    if (!parse_number(*text)) throw UsageError("--ground " + *text + ": a number, m, or none");
    settings.ground = number_of(options, "ground", {-1000.0, 1000.0, "m"});
  } else if (settings.surface.low.z > -0.999 * field.domain()) {
    settings.ground = settings.surface.low.z;
  }
}

std::string stepping_in_words(const Rendering& rendering) {
  if (rendering.stepping == Stepping::bisection) return "stepping: bisection";
  const std::string certified =
      "stepping: certified" +
      (rendering.undecided > 0.0 ? " to " + draw::short_text(1000.0 * rendering.undecided, 2) + " mm" : "");
  if (rendering.bisected_rays == 0) return certified;
  return certified + ", but " + std::to_string(rendering.bisected_rays) + " of " +
         std::to_string(rendering.rays) + " rays ended by bisection";
}

std::string warning_of(const Rendering& rendering) {
  if (rendering.saturated_gradients == 0) return "";
  return "gradients saturate at " + std::to_string(rendering.saturated_gradients) + " of " +
         std::to_string(rendering.surface_rays) +
         " places of the surface, where it is shaded by differences; another --scalar holds more";
}

}  // namespace

std::vector<OptionDescription> render_options() {
  return {{"output", "FILE.png", "where to write (required)"},
          {"camera", "x,y,z", "where the camera is, m; default: where it sees all of the surface"},
          {"look-at", "x,y,z", "what is in the middle of the picture; default: the middle of the surface"},
          {"field-of-view", "DEGREES", "of the picture's height, 1 to 150; default: 35"},
          size_option(),
          {"ground", "Z", "height of the ground plane, m, or none; default: below the surface"},
          {"colour", "#RRGGBB", "of the surface, sRGB; default: #95AECA"},
          {"bands", "SPACING",
           "layers of the field, one each SPACING of f, on the ground and on what --box cuts"},
          box_option("x0,y0,z0,x1,y1,z1, m: cut off what is outside; default: nothing is"),
          level_option(),
          {"steps", "N",
           "of rays across the surface's box where nothing is certified, 16 to 65536; default: 512"},
          scalar_option(),
          parameters_option(),
          threads_option(),
          {"help", "", "this text"}};
}

Drawing draw_scene(const Options& options, const ReportProgress& report) {
  const SceneDescription scene = scene_of(options, usage);
  output_of(options, {".png"});
  RenderSettings settings;
  settings.width = size_of(options).width;
  settings.height = size_of(options).height;
  const std::string colour_text = options.value("colour").value_or("#95AECA");
  const auto colour = colour_of(colour_text);
  if (!colour)
    throw UsageError("--colour " + colour_text + ": a hash and six hexadecimal digits, such as #95AECA");
  settings.colour = *colour;
  if (const auto spacing = number_of(options, "bands", {1e-6, 1000.0})) settings.bands = even_bands(*spacing);
  settings.steps = whole_number_of(options, "steps", 16, 65536, 512);
  settings.threads = threads_of(options);
  const auto field = field_of(options, scene);
  place_camera(options, scene, *field, settings);
  place_ground(options, *field, settings);

  const Rendering rendering = render(*field, settings, report);
  std::string said = std::string(name_of(field->kind())) + " of \"" + scene.name + "\", " +
                     std::to_string(settings.width) + " x " + std::to_string(settings.height) + "; " +
                     stepping_in_words(rendering);
  if (settings.ground) {
    said += "; ground at z = " + draw::short_text(*settings.ground, 4) + " m";
    if (settings.bands.empty())
      said += ", lines every " + draw::short_text(rendering.ground_spacing, 4) + " m";
  }
  return {draw::png_of(rendering.image), said, warning_of(rendering)};
}

int run_render(const std::vector<std::string>& arguments) {
  const Options options(render_options(), arguments, Operand::one);
  if (options.has("help")) {
    print_help();
    return 0;
  }
  Drawing drawing;
  {
    Progress progress("drawing");
    drawing = draw_scene(options, [&progress](double done) { progress.report(done); });
  }
  write_file(options.required("output"), drawing.bytes);
  print_warning(options.required("output"), drawing);
  std::printf("%s: %s\n", options.required("output").c_str(), drawing.said.c_str());
  return 0;
}

}  // namespace nearfield::host
