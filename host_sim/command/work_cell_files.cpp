#include "command/work_cell_files.hpp"

#include <filesystem>

#include "model/scene_reader.hpp"
#include "text/input_error.hpp"

#ifndef NEARFIELD_SCENE_FOLDER
#error "the build names the folder of the scenes that come with Nearfield"
#endif

namespace nearfield::host {

std::vector<OptionDescription> work_cell_options() {
  return {{"scene", "FILE", "scene (JSON, see host_sim/FORMATS.md); default: the work cell of Nearfield"},
          {"robot", "FILE", "robot (URDF); default: the scene's"},
          {"srdf", "FILE", "link pairs not to check; default: the .srdf beside the robot, if any"}};
}

CompiledWorkCell compile_work_cell(const Options& options, WorkCellFiles& files) {
  files.scene = options.value("scene").value_or(NEARFIELD_SCENE_FOLDER "/work_cell.json");
  const SceneDescription scene = read_scene(files.scene);
  if (!options.has("robot") && !scene.robot) {
    throw InputError(files.scene, {}, "robot", "missing", "name a robot here or with --robot");
  }
  files.robot = options.value("robot").value_or(scene.robot.value_or(""));
  files.srdf = options.value("srdf").value_or("");
  if (!options.has("srdf")) {
    const std::filesystem::path beside = std::filesystem::path(files.robot).replace_extension(".srdf");
    std::error_code ignored;
    if (std::filesystem::is_regular_file(beside, ignored)) files.srdf = beside.string();
  }
  return compile_work_cell(scene, files.robot, files.srdf);
}

}  // namespace nearfield::host
