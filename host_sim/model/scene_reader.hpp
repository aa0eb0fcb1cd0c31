#pragma once

#include <string>
#include <string_view>

#include "model/scene_description.hpp"

namespace nearfield::host {

// Reads a scene in the format `nearfield-scene-1` (FORMATS.md). Files that the scene names are resolved
// relative to the scene's folder but not opened; names of links and joints are not checked against a robot.
// InputError, with file, line, column and path, on anything that the format does not allow.
SceneDescription read_scene(const std::string& path);

// The same from text; `file` is the name that errors show and that relative files are resolved against.
SceneDescription parse_scene(std::string_view text, const std::string& file);

// The same for a scene that is only to be evaluated: `field` may yield any kind, and `duration` may be
// missing.
SceneDescription read_scene_of_any_kind(const std::string& path);
SceneDescription parse_scene_of_any_kind(std::string_view text, const std::string& file);

}  // namespace nearfield::host
