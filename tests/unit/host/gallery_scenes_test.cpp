// The gallery that comes with Nearfield: its indexes are valid, its scenes compile.
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <set>
#include <string>
#include <vector>

#include "gallery/gallery_index.hpp"
#include "gallery/gallery_page.hpp"
#include "model/scene_reader.hpp"
#include "render/scene_field.hpp"

namespace nearfield::host {
namespace {

namespace fs = std::filesystem;

// Found from this file's own place in the source tree.
fs::path gallery_folder() { return fs::path(__FILE__).parent_path() / "../../../host_sim/scenes/gallery"; }

// Files *.json in folders of the gallery's folder, as commands name them.
std::set<std::string> scenes_in_folders() {
  std::set<std::string> scenes;
  for (const fs::directory_entry& entry : fs::recursive_directory_iterator(gallery_folder())) {
    const fs::path name = entry.path().lexically_relative(gallery_folder());
    if (name.extension() == ".json" && name.has_parent_path()) scenes.insert(name.generic_string());
  }
  return scenes;
}

TEST(GalleryScenes, CompileWhetherDrawnOrNot) {
  const std::set<std::string> scenes = scenes_in_folders();
  EXPECT_GT(scenes.size(), 10U);
  for (const std::string& name : scenes) {
    SCOPED_TRACE(name);
    const SceneDescription scene = read_scene_of_any_kind((gallery_folder() / name).string());
    EXPECT_NO_THROW(scene_field(scene, FieldScalar::q27, std::vector<double>(64, 0.5)));
  }
}

TEST(GalleryScenes, IndexesNameThemAllAndNoOther) {
  std::set<std::string> named;
  std::set<std::string> anchors;
  for (const GalleryChapter& chapter : read_gallery(gallery_folder().string())) {
    for (std::size_t i = 0; i < chapter.figures.size(); ++i) {
      EXPECT_TRUE(anchors.insert(anchor_of(chapter, i)).second) << chapter.name << ", " << i;
      for (const GalleryPicture& picture : chapter.figures[i].pictures) {
        if (picture.command.front() == "curve") continue;
        ASSERT_GE(picture.command.size(), 2U) << chapter.file << " " << picture.path;
        // Scenes of other folders are somebody else's.
        if (picture.command[1].rfind("../", 0) != 0) named.insert(picture.command[1]);
      }
    }
  }
  EXPECT_EQ(named, scenes_in_folders());
}

}  // namespace
}  // namespace nearfield::host
