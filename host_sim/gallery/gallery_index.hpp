// What a gallery shows: chapters of figures, each a row of pictures that are drawn by commands.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "text/source_position.hpp"

namespace nearfield::host {

struct GalleryPicture {
  std::string caption;
  std::vector<std::string> command;  // what one types after `nearfield`, without where to write
  bool scene_text = true;            // whether the page shows the scene's text
  std::string path;                  // `figures[1].pictures[0]`
  SourcePosition position;           // of the command
};

struct GalleryFigure {
  std::optional<std::string> figure;  // its number in the paper
  std::string title;
  std::string look_for;
  std::vector<GalleryPicture> pictures;  // at least 1
};

struct GalleryChapter {
  std::string file;  // the index it was read from
  std::string name;  // of that file, without folder and ending
  std::string title;
  std::optional<std::string> paper;
  long long order = 0;
  std::vector<GalleryFigure> figures;  // at least 1
};

// Reads an index in the format `nearfield-gallery-1` (FORMATS.md). InputError, with file, line, column and
// path, on anything that the format does not allow. Commands are not looked into.
GalleryChapter parse_chapter(std::string_view text, const std::string& file);

// All indexes of a folder, its files *.json, by their order and then by their names. InputError when there is
// none.
std::vector<GalleryChapter> read_gallery(const std::string& folder);

}  // namespace nearfield::host
