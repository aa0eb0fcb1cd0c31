#include "gallery/gallery_page.hpp"

#include <algorithm>
#include <cctype>

#include "draw/svg.hpp"
#include "gallery/base64.hpp"
#include "text/number.hpp"

namespace nearfield::host {
namespace {

using draw::escaped;

constexpr double widest_in_a_row = 720.0, widest = 900.0;  // pixels; pictures may be larger
constexpr double narrowest = 224.0;                        // pixels, of what is written beneath a picture

const char* const style = R"(
:root { color-scheme: light dark;
  --paper: #fbfbfa; --ink: #1b2430; --quiet: #5a6572; --line: #dfe3e8; --card: #ffffff; --code: #f1f3f5;
  --link: #00588f; --warning: #9a3412; }
@media (prefers-color-scheme: dark) { :root {
  --paper: #14181d; --ink: #e4e8ec; --quiet: #9aa5b1; --line: #333b45; --card: #1c2229; --code: #242b33;
  --link: #7cc3ec; --warning: #f6ad82; } }
* { box-sizing: border-box; }
body { margin: 0; background: var(--paper); color: var(--ink); line-height: 1.5;
  font-family: system-ui, -apple-system, "Segoe UI", "Helvetica Neue", Arial, "DejaVu Sans", sans-serif; }
main, header { max-width: 96rem; margin: 0 auto; padding: 0 1.5rem; }
h1 { font-size: 1.9rem; margin: 2rem 0 .5rem; }
h2 { font-size: 1.5rem; margin: 3.5rem 0 .25rem; padding-top: 1rem; border-top: 2px solid var(--line); }
h3 { font-size: 1.12rem; margin: 2.25rem 0 .25rem; }
h3 a { color: inherit; text-decoration: none; }
h3 a:hover { text-decoration: underline; }
p { margin: .35rem 0; max-width: 60rem; }
a { color: var(--link); }
nav { columns: 20rem; column-gap: 2.5rem; margin: 1.5rem 0; font-size: .92rem; }
nav section { break-inside: avoid; margin: 0 0 1rem; }
nav ul { list-style: none; margin: .15rem 0 0; padding: 0; }
nav li { overflow: hidden; text-overflow: ellipsis; white-space: nowrap; }
nav > section > a { font-weight: 600; }
nav a { text-decoration: none; }
nav a:hover { text-decoration: underline; }
.paper, .quiet { color: var(--quiet); }
.look { border-left: 3px solid var(--line); padding-left: .8rem; }
.row { display: flex; flex-wrap: wrap; gap: 1rem; margin: .9rem 0 0; align-items: flex-start; }
figure { margin: 0; background: var(--card); border: 1px solid var(--line); border-radius: .5rem;
  overflow: hidden; max-width: 100%; }
figure img { display: block; max-width: 100%; height: auto; margin: 0 auto; background: #ffffff; }
figcaption { padding: .6rem .8rem .7rem; font-size: .88rem; }
figcaption strong { display: block; font-size: .95rem; }
code, pre { font-family: ui-monospace, "DejaVu Sans Mono", Menlo, Consolas, monospace; font-size: .78rem; }
code { overflow-wrap: anywhere; }
.command { display: block; background: var(--code); border-radius: .3rem; padding: .3rem .5rem;
  margin: .4rem 0; }
dl { margin: .3rem 0 0; color: var(--quiet); font-size: .82rem; }
dt { float: left; clear: left; margin-right: .4rem; font-weight: 600; }
dt::after { content: ":"; }
dd { margin: 0; }
.warning { color: var(--warning); }
details { margin-top: .4rem; }
summary { cursor: pointer; color: var(--link); font-size: .82rem; }
pre { background: var(--code); border-radius: .3rem; padding: .5rem; margin: .3rem 0 0; overflow: auto;
  max-height: 28rem; }
footer { color: var(--quiet); font-size: .85rem; padding: 3rem 1.5rem 2rem; max-width: 96rem;
  margin: 0 auto; }
)";

const char* const introduction =
    "<p>Every picture on this page was drawn by the evaluator that runs on the target, in fixed point "
    "(<code>Fixed&lt;27&gt;</code> unless its command says otherwise), by the command beneath it. Nothing "
    "was "
    "drawn by hand and nothing was touched up. The file names in the commands are relative to the gallery's "
    "folder.</p>\n"
    "<p>Beneath a scene's picture: how it was drawn, what is proved of its field, and the worst-case number "
    "of instructions that a query of the field takes on a Cortex-M4. <em>Certified</em> stepping: each ray "
    "advanced by what is proved to be free and cannot have jumped over anything. <em>Bisection</em>: where "
    "nothing is proved, rays went in fixed steps.</p>\n";

std::string anchor_text(const std::string& text) {
  std::string anchor;
  for (const char c : text) {
    const bool plain = (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_';
    if (plain)
      anchor += c;
    else if (!anchor.empty() && anchor.back() != '-')
      anchor += '-';
  }
  return anchor.empty() ? "chapter" : anchor;
}

std::string anchor_by_number(const GalleryChapter& chapter, const GalleryFigure& figure) {
  return figure.figure ? anchor_text(chapter.name + "-" + *figure.figure) : "";
}

std::string heading_of(const GalleryFigure& figure) {
  return (figure.figure ? "Figure " + *figure.figure + ": " : "") + figure.title;
}

// As one types it, words in quotes where a shell needs them.
std::string typed(const std::vector<std::string>& command) {
  std::string text = "nearfield";
  for (const std::string& word : command) {
    const bool plain = std::all_of(word.begin(), word.end(), [](char c) {
      return std::isalnum(static_cast<unsigned char>(c)) != 0 ||
             std::string("-_./,=:").find(c) != std::string::npos;
    });
    std::string quoted;
    for (const char c : word) quoted += c == '\'' ? std::string("'\\''") : std::string(1, c);
    text += plain ? " " + word : " '" + quoted + "'";
  }
  return text;
}

struct Sides {
  double width = 640.0, height = 480.0;
};

bool is_png(const std::string& bytes) { return bytes.compare(0, 4, "\x89PNG") == 0; }

Sides sides_of_png(const std::string& bytes) {
  const auto number_at = [&bytes](std::size_t at) {
    double number = 0.0;
    for (std::size_t i = 0; i < 4; ++i)
      number = 256.0 * number + static_cast<unsigned char>(bytes.at(at + i));
    return number;
  };
  return {number_at(16), number_at(20)};
}

Sides sides_of_svg(const std::string& bytes) {
  const auto number_after = [&bytes](const std::string& name) {
    const std::size_t begin = bytes.find(name) + name.size();
    return parse_number(bytes.substr(begin, bytes.find('"', begin) - begin)).value_or(0.0);
  };
  return {number_after(" width=\""), number_after(" height=\"")};
}

std::string image_element(const DrawnPicture& drawn, const std::string& description, const Sides& sides) {
  return std::string("<img src=\"data:") + (is_png(drawn.bytes) ? "image/png" : "image/svg+xml") +
         ";base64," + base64_of(drawn.bytes) + "\" width=\"" + format_number(sides.width) + "\" height=\"" +
         format_number(sides.height) + "\" alt=\"" + escaped(description) + "\">\n";
}

std::string picture_element(const GalleryFigure& figure, const GalleryPicture& picture,
                            const DrawnPicture& drawn) {
  const Sides sides = is_png(drawn.bytes) ? sides_of_png(drawn.bytes) : sides_of_svg(drawn.bytes);
  const double most = sides.width > 700.0 && figure.pictures.size() > 1 ? widest_in_a_row : widest;
  std::string text = "<figure style=\"width:" + format_number(std::clamp(sides.width, narrowest, most)) +
                     "px\">\n" + image_element(drawn, figure.title + ": " + picture.caption, sides) +
                     "<figcaption><strong>" + escaped(picture.caption) +
                     "</strong>\n<code class=\"command\">" + escaped(typed(picture.command)) +
                     "</code>\n<dl>\n<dt>Drawn</dt><dd>" + escaped(drawn.said) + "</dd>\n";
  if (!drawn.warning.empty())
    text += "<dt>Warning</dt><dd class=\"warning\">" + escaped(drawn.warning) + "</dd>\n";
  if (!drawn.scene_file.empty()) {
    text += "<dt>Certificate</dt><dd>" + escaped(drawn.certificate) +
            "</dd>\n<dt>Cortex-M4, at most</dt><dd>" + escaped(drawn.budget) + "</dd>\n";
  }
  text += "</dl>\n";
  if (!drawn.scene_file.empty() && picture.scene_text) {
    // An HTML parser drops the first line end of a pre.
    text += "<details><summary>" + escaped(drawn.scene_file) + "</summary>\n<pre>\n";
    // Line ends stay; escaped() would take them for control characters.
    for (std::size_t at = 0; at < drawn.scene_text.size();) {
      const std::size_t end = std::min(drawn.scene_text.find('\n', at), drawn.scene_text.size());
      text += escaped(drawn.scene_text.substr(at, end - at)) + "\n";
      at = end + 1;
    }
    text += "</pre></details>\n";
  }
  return text + "</figcaption></figure>\n";
}

std::string table_of_contents(const std::vector<GalleryChapter>& chapters) {
  std::string text = "<nav aria-label=\"Chapters and figures\">\n";
  for (const GalleryChapter& chapter : chapters) {
    text +=
        "<section><a href=\"#" + anchor_text(chapter.name) + "\">" + escaped(chapter.title) + "</a>\n<ul>\n";
    for (std::size_t i = 0; i < chapter.figures.size(); ++i) {
      text += "<li><a href=\"#" + anchor_of(chapter, i) + "\">" + escaped(heading_of(chapter.figures[i])) +
              "</a></li>\n";
    }
    text += "</ul></section>\n";
  }
  return text + "</nav>\n";
}

}  // namespace

std::string anchor_of(const GalleryChapter& chapter, std::size_t figure) {
  const std::string anchor = anchor_by_number(chapter, chapter.figures[figure]);
  bool taken = anchor.empty();
  for (std::size_t i = 0; i < figure; ++i)
    taken = taken || anchor_by_number(chapter, chapter.figures[i]) == anchor;
  return taken ? anchor_text(chapter.name) + "-no-" + std::to_string(figure + 1) : anchor;
}

std::string gallery_page(const std::vector<GalleryChapter>& chapters,
                         const std::vector<DrawnPicture>& drawn) {
  std::string text =
      "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n"
      "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n"
      "<title>Nearfield gallery</title>\n<style>" +
      std::string(style) + "</style>\n</head>\n<body>\n<header>\n<h1>Nearfield gallery</h1>\n" +
      introduction + table_of_contents(chapters) + "</header>\n<main>\n";
  std::size_t next = 0;
  for (const GalleryChapter& chapter : chapters) {
    text += "<section id=\"" + anchor_text(chapter.name) + "\">\n<h2>" + escaped(chapter.title) + "</h2>\n";
    if (chapter.paper) text += "<p class=\"paper\">" + escaped(*chapter.paper) + "</p>\n";
    for (std::size_t i = 0; i < chapter.figures.size(); ++i) {
      const GalleryFigure& figure = chapter.figures[i];
      const std::string anchor = anchor_of(chapter, i);
      text += "<article id=\"" + anchor + "\">\n<h3><a href=\"#" + anchor + "\">" +
              escaped(heading_of(figure)) + "</a></h3>\n<p class=\"look\">" + escaped(figure.look_for) +
              "</p>\n<div class=\"row\">\n";
      for (const GalleryPicture& picture : figure.pictures)
        text += picture_element(figure, picture, drawn.at(next++));
      text += "</div>\n</article>\n";
    }
    text += "</section>\n";
  }
  return text + "</main>\n<footer>" + std::to_string(drawn.size()) +
         " pictures, the same bytes from run to run.</footer>\n</body>\n</html>\n";
}

}  // namespace nearfield::host
