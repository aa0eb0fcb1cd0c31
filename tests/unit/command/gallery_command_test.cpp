// `nearfield gallery`: what its page holds, and what it must refuse.
#include "command_runner.hpp"

namespace nearfield::host {
namespace {

std::size_t count_of(const std::string& text, const std::string& part) {
  std::size_t count = 0;
  for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) ++count;
  return count;
}

class GalleryCommand : public testing::Test {
 protected:
  void SetUp() override {
    folder_.write("g/s/ball.json", R"({"format": "nearfield-scene-1", "name": "a <ball> & \"more\"", "field":
  {"type": "sphere", "radius": 0.5}})");
    folder_.write("g/s/soft.json", R"({"format": "nearfield-scene-1", "name": "soft", "field":
  {"type": "soft_point", "influence_radius": 0.5}})");
    folder_.write("g/s/ray.json", R"({"format": "nearfield-scene-1", "name": "ray", "field":
  {"type": "ray_point", "influence_radius": 0.5}})");
  }
  // A chapter of one figure, with commands as JSON has them.
  void write_chapter(const std::string& name, const std::vector<std::string>& commands,
                     const std::string& extra = "") const {
    std::string pictures;
    for (const std::string& command : commands) {
      pictures += (pictures.empty() ? "" : ",\n") + std::string(R"({"caption": "c <1>", "command": )") +
                  command + "}";
    }
    folder_.write("g/" + name + ".json",
                  R"({"format": "nearfield-gallery-1", "title": "T & )" + name + "\"" + extra +
                      R"(, "figures": [{"figure": "3", "title": "Ball <b>", "look_for": "A 'round' one.",)" +
                      "\n\"pictures\": [\n" + pictures + "]}]}\n");
  }
  std::string page(const std::vector<std::string>& more = {}) const {
    std::vector<std::string> arguments = {"gallery", "g", "--output", "page.html"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    const Outcome outcome = folder_.run(arguments);
    EXPECT_EQ(outcome.status, 0) << outcome.err;
    EXPECT_EQ(outcome.err, "");
    EXPECT_EQ(outcome.out.find("page.html: "), 0U) << outcome.out;
    return folder_.read("page.html");
  }
  std::string refused(const std::string& command) const {
    write_chapter("one", {command});
    return refusal(folder_, {"gallery", "g", "--output", "page.html"});
  }

  const std::string slice_ = R"(["slice", "s/ball.json", "--size", "160x160"])";
  const std::string render_ = R"(["render", "s/ball.json", "--size", "40x30", "--colour", "#AA3311"])";
  const std::string curve_ = R"(["curve", "polynomial", "--set", "n=2", "--rising-range", "0.5"])";
  ScratchFolder folder_;
};

TEST_F(GalleryCommand, PageHoldsPicturesScenesCertificatesAndBudgets) {
  write_chapter("one", {slice_, render_, curve_, R"(["slice", "s/soft.json", "--size", "160x160"])",
                        R"(["slice", "s/ray.json", "--size", "160x160", "--bands"])"});
  const std::string text = page();
  EXPECT_EQ(text.find("<!DOCTYPE html>\n"), 0U);
  EXPECT_EQ(count_of(text, "data:image/svg+xml;base64,"), 3U);
  EXPECT_EQ(count_of(text, "data:image/png;base64,"), 2U);
  EXPECT_NE(text.find("width=\"40\" height=\"30\" alt=\"Ball &lt;b&gt;: c &lt;1&gt;\""), std::string::npos);
  EXPECT_NE(text.find("id=\"one-3\""), std::string::npos);
  EXPECT_NE(text.find("<a href=\"#one-3\">Figure 3: Ball &lt;b&gt;</a>"), std::string::npos);
  EXPECT_NE(text.find("A &#39;round&#39; one."), std::string::npos);
  EXPECT_NE(text.find("nearfield render s/ball.json --size 40x30 --colour &#39;#AA3311&#39;"),
            std::string::npos);
  EXPECT_NE(text.find("stepping: certified"), std::string::npos);
  EXPECT_EQ(count_of(text, "<details><summary>ball.json</summary>"), 2U);
  EXPECT_NE(text.find("a &lt;ball&gt; &amp; \\&quot;more\\&quot;"), std::string::npos);
  EXPECT_EQ(count_of(text, "<dd>Lipschitz constant 1, error at most "), 2U);
  EXPECT_EQ(count_of(text, "a clearance by the greatest value in a ball"), 1U);
  EXPECT_EQ(count_of(text, "no clearance: a ray function&#39;s value is no distance"), 1U);
  // As `nearfield budget` has it.
  const std::string budgets = folder_.run({"budget", "g/s/ball.json"}).out;
  const std::string line =
      budgets.substr(budgets.find("cortex-m4"), budgets.find('\n', budgets.find("cortex-m4")));
  const std::size_t value = line.find_first_of("0123456789", 9), gap = line.find(' ', value);
  EXPECT_NE(text.find("<dd>" + line.substr(value, gap - value) + " instructions a value, "),
            std::string::npos)
      << line;
}

TEST_F(GalleryCommand, WarningsAreOnThePageAndOnStandardError) {
  const std::string plane = R"({"type": "algebraic_plane", "normal": [0, 0, 1], "offset": -4}, )";
  folder_.write("g/s/steep.json", R"({"format": "nearfield-scene-1", "name": "steep", "field":
    {"type": "functional_spline", "lambda": 0.0001, "primaries": 5, "operands": [
      {"type": "algebraic_sphere", "radius": 0.5, "size": 0.25}, )" +
                                      plane + plane + plane + plane +
                                      R"({"type": "algebraic_plane", "normal": [0, 0, 1], "offset": 0}]}})");
  write_chapter("one", {slice_, R"(["render", "s/steep.json", "--size", "24x24", "--box", "-1,-1,-1,1,1,1",
                                    "--steps", "64"])"});
  const Outcome outcome = folder_.run({"gallery", "g", "--output", "page.html"});
  EXPECT_EQ(outcome.status, 0);
  EXPECT_EQ(outcome.err.find("g/one.json: figures[0].pictures[1].command: figure 3, \"Ball <b>\", picture 2: "
                             "warning: gradients saturate at "),
            0U)
      << outcome.err;
  EXPECT_EQ(count_of(outcome.err, "\n"), 1U);
  EXPECT_EQ(count_of(folder_.read("page.html"), "<dt>Warning</dt><dd class=\"warning\">gradients saturate"),
            1U);
}

TEST_F(GalleryCommand, PageNeedsNothingElse) {
  write_chapter("one", {slice_, render_, curve_});
  const std::string text = page();
  for (const char* part :
       {"<script", "<link", "<iframe", "http:", "https:", "url(", "@import", "file:", "srcset"})
    EXPECT_EQ(text.find(part), std::string::npos) << part;
  EXPECT_EQ(count_of(text, " src=\""), count_of(text, " src=\"data:"));
  EXPECT_EQ(count_of(text, " href=\""), count_of(text, " href=\"#"));
  EXPECT_EQ(text.find(folder_.path().string()), std::string::npos);
}

TEST_F(GalleryCommand, SameBytesWhateverTheThreadsAndTwice) {
  write_chapter("one", {slice_, render_, curve_});
  write_chapter("two", {render_, slice_});
  const std::string text = page();
  EXPECT_EQ(page({"--threads", "1"}), text);
  EXPECT_EQ(page({"--threads", "2"}), text);
  EXPECT_EQ(page({"--threads", "2"}), text);
}

TEST_F(GalleryCommand, PicturesAreThoseOfTheVerbs) {
  write_chapter("one", {render_});
  const std::string text = page();
  ASSERT_EQ(
      folder_.run({"render", "g/s/ball.json", "--size", "40x30", "--colour", "#AA3311", "--output", "a.png"})
          .status,
      0);
  const std::string png = folder_.read("a.png");
  const std::size_t begin = text.find("base64,") + 7;
  const std::string base64 = text.substr(begin, text.find('"', begin) - begin);
  const std::string letters = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string decoded;
  unsigned bits = 0, count = 0;
  for (const char c : base64) {
    if (c == '=') break;
    bits = bits << 6U | static_cast<unsigned>(letters.find(c));
    count += 6;
    if (count < 8) continue;
    count -= 8;
    decoded += static_cast<char>(bits >> count & 255U);
  }
  EXPECT_TRUE(decoded == png);
}

TEST_F(GalleryCommand, ChaptersComeInTheirOrder) {
  write_chapter("alpha", {curve_});
  write_chapter("beta", {curve_}, R"(, "order": 2)");
  write_chapter("gamma", {curve_}, R"(, "order": 1, "paper": "Somebody, 1999")");
  const std::string text = page();
  EXPECT_LT(text.find("<section id=\"gamma\""), text.find("<section id=\"beta\""));
  EXPECT_LT(text.find("<section id=\"beta\""), text.find("<section id=\"alpha\""));
  EXPECT_NE(text.find("Somebody, 1999"), std::string::npos);
  const std::string one = page({"--chapter", "beta"});
  EXPECT_EQ(count_of(one, "<section id="), 1U);
  EXPECT_EQ(refusal(folder_, {"gallery", "g", "--output", "page.html", "--chapter", "betta"})
                .find("nearfield: --chapter: unknown name \"betta\" (did you mean \"beta\"?)"),
            0U);
}

TEST_F(GalleryCommand, PicturesMayBeInOtherNumberTypes) {
  folder_.write("g/s/far.json", R"({"format": "nearfield-scene-1", "name": "far", "field":
  {"type": "sphere", "radius": 8}})");
  write_chapter("one", {R"(["slice", "s/far.json", "--size", "160x160", "--scalar", "q24"])",
                        R"(["slice", "s/ball.json", "--size", "160x160", "--scalar", "q24"])"});
  const std::string text = page();
  EXPECT_EQ(count_of(text, "not stated: the field does not fit Fixed&lt;27&gt;"), 1U);
  EXPECT_EQ(count_of(text, " with its gradient (in Fixed&lt;27&gt;)"), 1U);
}

TEST_F(GalleryCommand, SceneTextMayBeLeftOut) {
  folder_.write("g/one.json", R"({"format": "nearfield-gallery-1", "title": "t", "figures": [{"title": "f",
    "look_for": "l", "pictures": [{"caption": "c", "scene_text": false, "command": )" +
                                  slice_ + "}]}]}");
  const std::string text = page();
  EXPECT_EQ(text.find("<details>"), std::string::npos);
  EXPECT_NE(text.find("<dt>Certificate</dt>"), std::string::npos);
  EXPECT_NE(text.find("id=\"one-no-1\""), std::string::npos);
}

TEST_F(GalleryCommand, RefusesWrongCommandsWithFigureAndPicture) {
  const std::string start =
      "g/one.json:3:33: figures[0].pictures[0].command: figure 3, \"Ball <b>\", picture 1: ";
  struct Wrong {
    std::string command, message;
  };
  const std::vector<Wrong> all = {
      {R"(["slyce", "s/ball.json"])",
       "unknown verb \"slyce\" (did you mean \"slice\"?); one of slice, render, curve"},
      {R"(["mesh", "s/ball.json"])", "unknown verb \"mesh\""},
      {R"(["slice", "s/ball.json", "--levls", "3"])",
       "unknown option \"levls\" (did you mean \"levels\"?); `nearfield slice --help` tells more"},
      {R"(["slice", "s/ball.json", "--size"])", "--size needs a value"},
      {R"(["slice", "s/ball.json", "--size", "9"])", "--size 9: two whole numbers"},
      {R"(["slice"])", "which scene?"},
      {R"(["render", "s/ball.json", "--output", "x.png"])", "--output is not for pictures of a gallery"},
      {R"(["render", "s/ball.json", "--threads", "1"])", "--threads is not for pictures of a gallery"},
      {R"(["curve", "polynomial", "--svg", "x.svg"])", "--svg is not for pictures of a gallery"},
      {R"(["curve", "polynomial", "--help"])", "--help is not for pictures of a gallery"},
      {R"(["curve", "--list"])", "--list goes without a name"},
      {R"(["curve", "polynomial", "--csv", "-"])", "--csv and --svg exclude each other"},
      {R"(["curve", "polinomial"])", "nearfield curve: unknown curve \"polinomial\""},
      {R"(["curve", "wyvill", "--rising-range", "0.5"])",
       "--rising-range is of steps; wyvill is a potential"},
      {R"(["curve", "polynomial", "--rising-range", "2"])", "--rising-range 2: a number from 0.02 to 1"}};
  for (const Wrong& wrong : all) {
    const std::string line = refused(wrong.command);
    EXPECT_EQ(line.substr(0, start.size() + wrong.message.size()), start + wrong.message);
  }
}

TEST_F(GalleryCommand, RefusesWrongScenesAtTheirPlace) {
  EXPECT_EQ(refused(R"(["slice", "s/missing.json"])").find("g/s/missing.json: cannot be opened"), 0U);
  folder_.write("g/s/wrong.json", R"({"format": "nearfield-scene-1", "name": "a", "field":
  {"type": "sphere", "radius": -1}})");
  EXPECT_EQ(refused(R"(["slice", "s/wrong.json"])").find("g/s/wrong.json:2:32: field.radius: "), 0U);
  // Of several the first.
  write_chapter("one", {slice_, R"(["slice", "s/wrong.json"])", R"(["slice", "s/missing.json"])"});
  for (const char* threads : {"1", "2"}) {
    EXPECT_EQ(refusal(folder_, {"gallery", "g", "--output", "page.html", "--threads", threads})
                  .find("g/s/wrong.json:2:32: field.radius: "),
              0U);
  }
}

TEST_F(GalleryCommand, RefusesWrongIndexes) {
  const auto line_of = [this](const std::string& index) {
    folder_.write("g/one.json", index);
    return refusal(folder_, {"gallery", "g", "--output", "page.html"});
  };
  const std::string head = R"({"format": "nearfield-gallery-1", "title": "t", )";
  EXPECT_EQ(line_of("{}").find("g/one.json:1:1: format: missing; required: \"nearfield-gallery-1\""), 0U);
  EXPECT_EQ(line_of(R"({"format": "nearfield-gallery-2"})").find("g/one.json:1:12: format: unknown name"),
            0U);
  EXPECT_EQ(
      line_of(head + R"("figurs": []})").find("g/one.json:1:49: figurs: unknown key \"figurs\" (did you"),
      0U);
  EXPECT_EQ(line_of(head + R"("figures": []})").find("g/one.json:1:60: figures: array of 0; "), 0U);
  EXPECT_EQ(
      line_of(head + R"("order": 1.5, "figures": []})").find("g/one.json:1:58: order: 1.5 is not a whole"),
      0U);
  EXPECT_EQ(
      line_of(head + R"("figures": [{"title": "f"}]})").find("g/one.json:1:61: figures[0].look_for: missing"),
      0U);
  const std::string figure = head + "\"figures\": [{\"title\": \"f\", \"look_for\": \"l\", \"pictures\":\n";
  EXPECT_EQ(line_of(figure + R"([{"caption": "c"}]}]})")
                .find("g/one.json:2:2: figures[0].pictures[0].command: missing"),
            0U);
  EXPECT_EQ(line_of(figure + R"([{"caption": "c", "command": []}]}]})")
                .find("g/one.json:2:30: figures[0].pictures[0].command: array of 0; an array of 1 to 64"),
            0U);
  EXPECT_EQ(line_of(figure + R"([{"caption": "c", "comand": ["slice"]}]}]})")
                .find("g/one.json:2:19: figures[0].pictures[0].comand: unknown key"),
            0U);
  EXPECT_EQ(line_of(figure + R"([{"caption": "c", "command": ["slice", 3]}]}]})")
                .find("g/one.json:2:40: figures[0].pictures[0].command[1]: a number is not allowed here"),
            0U);
  EXPECT_EQ(line_of("{").find("g/one.json:"), 0U);
}

TEST_F(GalleryCommand, RefusesWrongFoldersAndOutputs) {
  write_chapter("one", {curve_});
  expect_refusal(folder_, {"gallery", "g"}, "nearfield: --output is required");
  expect_refusal(folder_, {"gallery", "g", "--output", "page.pdf"},
                 "nearfield: --output page.pdf: the name must end in .html");
  expect_refusal(folder_, {"gallery", "none", "--output", "page.html"}, "none: cannot be read");
  std::filesystem::create_directory(folder_.path() / "empty");
  expect_refusal(folder_, {"gallery", "empty", "--output", "page.html"}, "empty: holds no index");
  expect_refusal(folder_, {"gallery", "g", "--output", "no/such/page.html"},
                 "no/such/page.html: cannot be created");
  EXPECT_EQ(folder_.run({"gallery", "--help"}).out.find("usage: nearfield gallery"), 0U);
}

}  // namespace
}  // namespace nearfield::host
