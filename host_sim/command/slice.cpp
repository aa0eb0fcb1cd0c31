#include <cstdio>

#include "command/command.hpp"
#include "command/drawing.hpp"
#include "command/field_options.hpp"
#include "command/progress.hpp"
#include "draw/number_text.hpp"
#include "draw/png.hpp"
#include "render/slice.hpp"
#include "text/read_file.hpp"

namespace nearfield::host {
namespace {

const char* const usage = "nearfield slice SCENE --output FILE.svg|FILE.png";

void print_help() {
  std::printf(
      "usage: %s [OPTION...]\n\n"
      "A scene's field, of any kind, in a plane, by the evaluator of the target: its inside filled, contours "
      "at even\n"
      "spacing, layers, gradients. f is the value less that on the surface, of intensities the other way "
      "round: below 0\n"
      "inside. Robots are at rest, as for `nearfield eval`.\n\n%s",
      usage, describe(slice_options()).c_str());
}

std::vector<Wave> waves_of(const Options& options) {
  std::vector<Wave> waves;
  for (const std::string& text : options.values("wave")) {
    const std::size_t comma = text.find(',');
    const auto amplitude = parse_number(text.substr(0, comma));
    const auto frequency = comma == std::string::npos ? std::nullopt : parse_number(text.substr(comma + 1));
    if (!amplitude || !frequency || !(*amplitude > 0.0 && *amplitude <= 1e6) ||
        !(*frequency > 0.0 && *frequency <= 1e6)) {
      throw UsageError("--wave " + text + ": two numbers above 0 and at most 1000000, such as 1,62.8");
    }
    waves.push_back({*amplitude, *frequency});
  }
  if (!waves.empty() && !options.has("bands")) throw UsageError("--wave goes with --bands");
  return waves;
}

Plane plane_of(const Options& options, const SceneField& field, const std::optional<Box3>& surface) {
  const auto origin = vector_of(options, "origin"), normal = vector_of(options, "normal");
  const auto text = options.value("plane");
  const Vector3d middle = origin ? *origin : surface ? surface->middle() : Vector3d{};
  if (!field.in_domain(middle)) {
    throw UsageError("--origin lies outside the number range: at most " + format_number(field.domain()) +
                     " m each way");
  }
  if (text && normal) throw UsageError("--plane and --normal exclude each other");
  if (normal) {
    if (!(length(*normal) > 1e-9)) throw UsageError("--normal has no direction");
    return plane_through(middle, *normal);
  }
  if (!text) return coordinate_plane(2, middle.z);
  const bool named = text->size() > 2 && (*text)[0] >= 'x' && (*text)[0] <= 'z' && (*text)[1] == '=';
  const auto value = named ? parse_number(text->substr(2)) : std::nullopt;
  if (!value || std::abs(*value) > field.domain()) {
    throw UsageError("--plane " + *text + ": x, y or z, =, and from -" + format_number(field.domain()) +
                     " to " + format_number(field.domain()) + " m, such as z=0.1");
  }
  return coordinate_plane(static_cast<unsigned>((*text)[0] - 'x'), *value);
}

SliceSettings settings_of(const Options& options, const SceneField& field) {
  SliceSettings settings;
  settings.width = size_of(options).width;
  settings.height = size_of(options).height;
  if (settings.width < 160 || settings.height < 160)
    throw UsageError("--size: a slice needs 160 pixels each way at least");
  settings.spacing = number_of(options, "spacing", {1e-6, 1e6});
  if (settings.spacing && options.has("levels"))
    throw UsageError("--levels and --spacing exclude each other");
  settings.levels = static_cast<int>(whole_number_of(options, "levels", 1, 100, 10));
  settings.layers = options.has("bands");
  settings.bands = Bands(waves_of(options));
  settings.slopes = options.has("arrows");
  settings.threads = threads_of(options);
  // Where the view is given the surface need not be found, which may take longer than the picture.
  std::optional<Box3> surface;
  if (!(options.has("origin") && options.has("width-metres")))
    surface = surface_box(field, domain_box(field));
  settings.plane = plane_of(options, field, surface);
  frame_surface(surface, settings);
  if (const auto origin = vector_of(options, "origin")) {
    settings.middle_u = dot(*origin - settings.plane.origin, settings.plane.u);
    settings.middle_v = dot(*origin - settings.plane.origin, settings.plane.v);
  }
  if (const auto width = number_of(options, "width-metres", {1e-6, 1000.0, "m"}))
    settings.width_metres = *width;
  return settings;
}

std::string warning_of(const draw::SlicePicture& picture) {
  if (picture.saturated_slopes == 0) return "";
  return "gradients saturate at " + std::to_string(picture.saturated_slopes) +
         " places, where arrows are of differences; another --scalar holds more";
}

}  // namespace

std::vector<OptionDescription> slice_options() {
  return {
      {"output", "FILE", "where to write, .svg or .png (required)"},
      {"plane", "AXIS=M", "x, y or z at so many m; default: z in the middle of the surface"},
      {"normal", "x,y,z", "instead: of a plane through --origin, seen from where it points to"},
      {"origin", "x,y,z", "m; what is in the middle of the picture; default: the middle of the surface"},
      {"width-metres", "W", "of what is shown; default: one and a half times the surface"},
      size_option(),
      {"levels", "N", "contours outside of the surface, 1 to 100; default: about 10"},
      {"spacing", "S", "instead: from one contour to the next, m of distances, else in units of the value"},
      {"bands", "", "colour by layers of even thickness: sum a (cos(w f) + 1)"},
      {"wave", "a,w", "one of the sum's terms, w in rad for each unit of f; default: two by the spacing",
       true},
      {"arrows", "", "the field's gradients, away from the inside"},
      level_option(),
      scalar_option(),
      parameters_option(),
      threads_option(),
      {"help", "", "this text"}};
}

Drawing draw_slice(const Options& options, const ReportProgress& report) {
  const SceneDescription scene = scene_of(options, usage);
  const std::string output = output_of(options, {".svg", ".png"});
  const auto field = field_of(options, scene);
  const SliceSettings settings = settings_of(options, *field);
  const draw::SlicePicture picture = slice_of(*field, settings, scene.name, report);
  return {ends_with(output, ".svg") ? draw::slice_svg(picture) : draw::png_of(draw::slice_image(picture)),
          "\"" + scene.name + "\", " + picture.note, warning_of(picture)};
}

int run_slice(const std::vector<std::string>& arguments) {
  const Options options(slice_options(), arguments, Operand::one);
  if (options.has("help")) {
    print_help();
    return 0;
  }
  Drawing drawing;
  {
    Progress progress("sampling");
    drawing = draw_slice(options, [&progress](double done) { progress.report(done); });
  }
  write_file(options.required("output"), drawing.bytes);
  print_warning(options.required("output"), drawing);
  std::printf("%s: %s\n", options.required("output").c_str(), drawing.said.c_str());
  return 0;
}

}  // namespace nearfield::host
