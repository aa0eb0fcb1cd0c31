// A gallery as one page of HTML that needs no other file: pictures are inside it, there is no script.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "gallery/gallery_index.hpp"

namespace nearfield::host {

// What a page shows of a picture besides what its index says.
struct DrawnPicture {
  std::string bytes;       // of an SVG or PNG file, by its own first bytes
  std::string said;        // what the command prints of it
  std::string warning;     // of the command; mostly empty
  std::string scene_file;  // empty: a picture without a scene
  std::string scene_text;
  std::string certificate;  // in a few words
  std::string budget;
};

// `drawn` has the pictures of all figures of all chapters, in their order. The same arguments give the same
// bytes.
std::string gallery_page(const std::vector<GalleryChapter>& chapters, const std::vector<DrawnPicture>& drawn);

// `li-4`: the anchor of a chapter's figure; of figures without a number `li-no-3`, counted from 1.
std::string anchor_of(const GalleryChapter& chapter, std::size_t figure);

}  // namespace nearfield::host
