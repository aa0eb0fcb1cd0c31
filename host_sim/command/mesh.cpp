#include <algorithm>
#include <cstdio>

#include "command/command.hpp"
#include "command/field_options.hpp"
#include "command/progress.hpp"
#include "render/mesh_file.hpp"
#include "render/surface_mesh.hpp"
#include "text/input_error.hpp"
#include "text/read_file.hpp"

namespace nearfield::host {
namespace {

const char* const usage = "nearfield mesh SCENE --output FILE.ply|FILE.obj";

std::vector<OptionDescription> mesh_options() {
  return {{"output", "FILE", "where to write, .ply or .obj (required)"},
          {"resolution", "N", "cells along the longest edge of the box, 4 to 512; default: 96"},
          box_option("x0,y0,z0,x1,y1,z1, m: what is sampled; default: about the surface"),
          {"close", "", "where the surface leaves the box, end it with the box's faces"},
          level_option(),
          scalar_option(),
          parameters_option(),
          threads_option(),
          {"help", "", "this text"}};
}

void print_help() {
  std::printf(
      "usage: %s [OPTION...]\n\n"
      "The surface of a scene's field, of any kind, as a closed mesh of triangles: every edge belongs to "
      "two. Vertices lie\n"
      "where the field changes its sign, normals are its gradient. What is smaller than a cell may be "
      "missed. A surface\n"
      "that leaves the box is refused without --close.\n\n%s",
      usage, describe(mesh_options()).c_str());
}

[[noreturn]] void refuse(const SceneDescription& scene, const std::string& message,
                         const std::string& allowed) {
  throw InputError(scene.file, scene.field.position, scene.field.path, message, allowed);
}

Box3 box_about_surface(const SceneField& field, std::size_t resolution) {
  const auto surface = surface_box(field, domain_box(field));
  if (!surface) return domain_box(field);
  const Vector3d size = surface->size();
  const double margin = 2.0 * std::max({size.x, size.y, size.z}) / static_cast<double>(resolution);
  return intersection(grown(*surface, margin), domain_box(field));
}

}  // namespace

int run_mesh(const std::vector<std::string>& arguments) {
  const Options options(mesh_options(), arguments, Operand::one);
  if (options.has("help")) {
    print_help();
    return 0;
  }
  const SceneDescription scene = scene_of(options, usage);
  const std::string output = output_of(options, {".ply", ".obj"});
  MeshSettings settings;
  settings.resolution = whole_number_of(options, "resolution", 4, 512, 96);
  settings.close = options.has("close");
  settings.threads = threads_of(options);
  const auto field = field_of(options, scene);
  const auto given = box_of(options, *field);
  settings.box = given ? *given : box_about_surface(*field, settings.resolution);

  Meshing meshing;
  {
    Progress progress("meshing");
    meshing = mesh_of(*field, settings, [&progress](double done) { progress.report(done); });
  }
  if (meshing.leaves_box) {
    refuse(scene, std::string("the surface leaves ") + (given ? "--box" : "the number range"),
           given ? "a larger --box, or --close" : "--close, or a --box");
  }
  const SurfaceMesh& mesh = meshing.mesh;
  if (mesh.triangles.empty())
    refuse(scene, "no surface is found", "another --box, --level or a greater --resolution");
  const std::string comment = scene.name + ", in m";
  write_file(output, ends_with(output, ".ply") ? ply_of(mesh, comment) : obj_of(mesh, comment));
  std::printf("%s: %s of \"%s\", %zu vertices, %zu triangles; %.0f %% of the cells proved empty\n",
              output.c_str(), name_of(field->kind()), scene.name.c_str(), mesh.vertices.size(),
              mesh.triangles.size(),
              100.0 * static_cast<double>(meshing.passed_over) / static_cast<double>(meshing.cells));
  return 0;
}

}  // namespace nearfield::host
