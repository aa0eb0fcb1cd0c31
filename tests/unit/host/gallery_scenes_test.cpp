// The gallery that comes with Nearfield: its indexes are valid, its scenes compile.
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <set>
#include <stdexcept>
#include <string>
#include <vector>

#include "command/drawing.hpp"
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

const GalleryChapter& chapter_named(const std::vector<GalleryChapter>& chapters, const std::string& name) {
  const auto found = std::find_if(chapters.begin(), chapters.end(),
                                  [&name](const GalleryChapter& chapter) { return chapter.name == name; });
  if (found == chapters.end()) throw std::runtime_error("no chapter " + name);
  return *found;
}

TEST(GalleryScenes, EveryFigureOfThePapersIsThere) {
  const std::vector<GalleryChapter> chapters = read_gallery(gallery_folder().string());
  const std::vector<std::pair<const char*, std::set<std::string>>> figures = {
      {"li", {"1", "2", "3", "4", "5", "6", "7", "8", "9", "10", "11", "12", "13", "14", "15"}},
      {"kacic_alesic", {"1", "2", "3", "4", "5", "6", "7", "8", "9", "10", "11", "14", "15"}},
      {"hsu", {"1", "2", "3", "4", "5", "6", "7", "9", "10", "12", "13", "14"}},
      {"akleman", {"1"}}};
  for (const auto& [name, wanted] : figures) {
    std::set<std::string> numbers;
    for (const GalleryFigure& figure : chapter_named(chapters, name).figures) {
      if (figure.figure) numbers.insert(*figure.figure);
    }
    EXPECT_EQ(numbers, wanted) << name;
  }
  // Six contours, each beside its blend.
  for (const GalleryFigure& figure : chapter_named(chapters, "hsu").figures) {
    if (figure.figure != "12" && figure.figure != "14") continue;
    std::vector<std::string> exponents;
    for (const GalleryPicture& picture : figure.pictures) {
      const std::size_t at = picture.caption.find("n1 = ");
      if (at != std::string::npos) exponents.push_back(picture.caption.substr(at));
    }
    ASSERT_EQ(exponents.size(), 12U);
    for (std::size_t i = 0; i < 12; i += 2) EXPECT_EQ(exponents[i], exponents[i + 1]);
  }
  EXPECT_EQ(chapter_named(chapters, "sipos").figures.size(), 6U);
  EXPECT_EQ(chapter_named(chapters, "robotics").figures.back().pictures.size(), 8U);  // frames of the morph
}

TEST(GalleryScenes, CommandsAreWhatTheVerbsTake) {
  for (const GalleryChapter& chapter : read_gallery(gallery_folder().string())) {
    for (const GalleryFigure& figure : chapter.figures) {
      EXPECT_FALSE(figure.look_for.empty());
      for (const GalleryPicture& picture : figure.pictures) {
        const auto verb = std::find_if(
            drawing_verbs().begin(), drawing_verbs().end(),
            [&picture](const DrawingVerb& each) { return each.name == picture.command.front(); });
        ASSERT_NE(verb, drawing_verbs().end()) << picture.command.front();
        const std::vector<std::string> words(picture.command.begin() + 1, picture.command.end());
        EXPECT_NO_THROW(Options(verb->options(), words, Operand::one)) << chapter.file << " " << picture.path;
      }
    }
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
