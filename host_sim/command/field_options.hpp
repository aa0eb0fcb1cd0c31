// Options that verbs about a scene's field share.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "command/options.hpp"
#include "compile/field_scalar.hpp"
#include "render/scene_field.hpp"
#include "render/surface_box.hpp"
#include "text/number.hpp"

namespace nearfield::host {

OptionDescription scalar_option();
FieldScalar scalar_of(const Options& options);
OptionDescription parameters_option();
std::vector<double> parameters_of(const Options& options);

// `--level NUMBER`.
OptionDescription level_option();
// The field of the scene that is the operand, in --scalar, with --parameters and --level. UsageError without
// an operand, naming `usage`.
std::unique_ptr<SceneField> field_of(const Options& options, const SceneDescription& scene);
SceneDescription scene_of(const Options& options, const std::string& usage);

// UsageError with the option and what is allowed for anything that is not what is asked for.
std::optional<double> number_of(const Options& options, const std::string& name, const NumberRange& range);
std::optional<Vector3d> vector_of(const Options& options, const std::string& name);
// `--box x0,y0,z0,x1,y1,z1`, within the field's domain.
OptionDescription box_option(const std::string& help);
std::optional<Box3> box_of(const Options& options, const SceneField& field);
std::size_t whole_number_of(const Options& options, const std::string& name, std::size_t least,
                            std::size_t greatest, std::size_t initial);
struct PictureSize {
  std::size_t width = 640, height = 480;  // pixels
};
OptionDescription size_option();
PictureSize size_of(const Options& options);
OptionDescription threads_option();
unsigned threads_of(const Options& options);

// The name of --output, one of whose endings (with the dot) it must have. UsageError otherwise.
std::string output_of(const Options& options, const std::vector<std::string>& endings);
bool ends_with(const std::string& text, const std::string& ending);

}  // namespace nearfield::host
