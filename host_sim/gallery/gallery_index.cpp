#include "gallery/gallery_index.hpp"

#include <algorithm>
#include <filesystem>
#include <utility>

#include "model/limits.hpp"
#include "text/input_error.hpp"
#include "text/json_node.hpp"
#include "text/read_file.hpp"

namespace nearfield::host {
namespace {

constexpr std::size_t most_figures = 100, most_pictures = 32, most_words = 64;
constexpr std::size_t longest_text = 2000;  // bytes
constexpr std::size_t longest_number = 20;  // bytes, of a figure's
constexpr std::int64_t last_order = 1000;

GalleryPicture read_picture(const JsonNode& node) {
  node.reject_unknown_keys({"caption", "command", "scene_text"});
  GalleryPicture picture;
  picture.path = node.path();
  picture.caption = node.required("caption", "what the picture shows").string(longest_text);
  const JsonNode command = node.required("command", "an array of words");
  picture.position = command.position();
  for (const JsonNode& word : command.elements(1, most_words))
    picture.command.push_back(word.string(longest_path));
  if (const auto shown = node.optional("scene_text")) picture.scene_text = shown->boolean();
  return picture;
}

GalleryFigure read_figure(const JsonNode& node) {
  node.reject_unknown_keys({"figure", "title", "look_for", "pictures"});
  GalleryFigure figure;
  if (const auto number = node.optional("figure")) figure.figure = number->string(longest_number);
  figure.title = node.required("title", "the figure's title").string(longest_name);
  figure.look_for = node.required("look_for", "what to look for").string(longest_text);
  for (const JsonNode& picture : node.required("pictures", "an array of pictures").elements(1, most_pictures))
    figure.pictures.push_back(read_picture(picture));
  return figure;
}

}  // namespace

GalleryChapter parse_chapter(std::string_view text, const std::string& file) {
  const JsonDocument document = parse_json(text, file);
  const JsonNode root(document);
  root.required("format", "\"nearfield-gallery-1\"").choice({"nearfield-gallery-1"});
  root.reject_unknown_keys({"format", "title", "paper", "order", "figures"});
  GalleryChapter chapter;
  chapter.file = file;
  chapter.name = std::filesystem::path(file).stem().string();
  chapter.title = root.required("title", "the chapter's title").string(longest_name);
  if (const auto paper = root.optional("paper")) chapter.paper = paper->string(longest_text);
  chapter.order = last_order;
  if (const auto order = root.optional("order")) chapter.order = order->integer(0, last_order);
  for (const JsonNode& figure : root.required("figures", "an array of figures").elements(1, most_figures))
    chapter.figures.push_back(read_figure(figure));
  return chapter;
}

std::vector<GalleryChapter> read_gallery(const std::string& folder) {
  std::vector<std::string> files;
  std::error_code failure;
  for (std::filesystem::directory_iterator entry(folder, failure), end; !failure && entry != end;
       entry.increment(failure)) {
    if (entry->path().extension() == ".json") files.push_back(entry->path().string());
  }
  if (failure) throw InputError(folder, {}, "", "cannot be read", "a folder of indexes");
  if (files.empty()) throw InputError(folder, {}, "", "holds no index", "files *.json");
  std::sort(files.begin(), files.end());
  std::vector<GalleryChapter> chapters;
  for (const std::string& file : files) chapters.push_back(parse_chapter(read_file(file), file));
  std::stable_sort(chapters.begin(), chapters.end(),
                   [](const GalleryChapter& a, const GalleryChapter& b) { return a.order < b.order; });
  return chapters;
}

}  // namespace nearfield::host
