// `nearfield render`, `slice` and `mesh`: what they write, and what they must refuse.
#include "command_runner.hpp"

namespace nearfield::host {
namespace {

const std::string ball = R"({"type": "sphere", "radius": 0.5})";

class PictureCommands : public testing::Test {
 protected:
  void SetUp() override {
    write_scene("ball.json", ball);
    write_scene("plane.json", R"({"type": "half_space", "normal": [0, 0, 1]})");
    write_scene("none.json", R"({"type": "offset", "radius": -1, "operands": [)" + ball + "]}");
    write_scene("morph.json", R"({"type": "morph", "parameter_slot": 0, "operands": [)" + ball +
                                  R"(, {"type": "box", "size": [1, 1, 1]}]})");
    write_scene("torus.json", R"({"type": "algebraic_torus", "ring_radius": 0.5, "tube_radius": 0.2})");
  }
  void write_scene(const std::string& name, const std::string& field) const {
    folder_.write(name, "{\"format\": \"nearfield-scene-1\", \"name\": \"a\", \"field\":\n" + field + "}");
  }
  std::string succeed(const std::vector<std::string>& arguments) const {
    const Outcome outcome = folder_.run(arguments);
    EXPECT_EQ(outcome.status, 0) << typed(arguments);
    EXPECT_EQ(outcome.err, "") << typed(arguments);
    return outcome.out;
  }

  ScratchFolder folder_;
};

TEST_F(PictureCommands, RenderWritesAPictureAndSaysHow) {
  const std::string said = succeed({"render", "ball.json", "--output", "a.png", "--size", "40x30"});
  EXPECT_EQ(said.find("a.png: distance of \"a\", 40 x 30; stepping: certified; ground at z = -0.5"), 0U)
      << said;
  EXPECT_NE(said.find(" m, lines every 0.2 m\n"), std::string::npos) << said;
  const std::string file = folder_.read("a.png");
  EXPECT_EQ(file.substr(0, 16), std::string("\x89PNG\r\n\x1A\n\0\0\0\rIHDR", 16));
  EXPECT_EQ(file.substr(16, 8), (std::string{0, 0, 0, 40, 0, 0, 0, 30}));
  succeed({"render", "ball.json", "--output", "b.png", "--size", "40x30", "--threads", "1"});
  EXPECT_EQ(folder_.read("b.png"), file);
  EXPECT_NE(succeed({"render", "torus.json", "--output", "t.png", "--size", "20x16", "--steps", "64"})
                .find("; stepping: bisection;"),
            std::string::npos);
}

TEST_F(PictureCommands, RenderTakesACameraAndParameters) {
  succeed({"render", "morph.json", "--output", "a.png", "--size", "40x30", "--parameters", "0", "--ground",
           "none"});
  succeed({"render", "morph.json", "--output", "b.png", "--size", "40x30", "--parameters", "1", "--ground",
           "none"});
  succeed({"render", "ball.json", "--output", "c.png", "--size", "40x30", "--ground", "none"});
  EXPECT_NE(folder_.read("a.png"), folder_.read("b.png"));
  EXPECT_EQ(folder_.read("a.png"), folder_.read("c.png"));
  EXPECT_EQ(succeed({"render",          "plane.json", "--output", "d.png",     "--size",
                     "20x20",           "--camera",   "0,-3,1",   "--look-at", "0,0,0",
                     "--field-of-view", "40",         "--ground", "-1",        "--colour",
                     "#aa3311",         "--bands",    "0.1",      "--box",     "-1,-1,-1,1,1,1",
                     "--scalar",        "q16"}),
            "d.png: distance of \"a\", 20 x 20; stepping: certified; ground at z = -1 m\n");
}

TEST_F(PictureCommands, SaturatedGradientsAreWarnedOf) {
  const std::string plane = R"({"type": "algebraic_plane", "normal": [0, 0, 1], "offset": -4}, )";
  write_scene("steep.json", R"({"type": "functional_spline", "lambda": 0.0001, "primaries": 5, "operands": [
      {"type": "algebraic_sphere", "radius": 0.5, "size": 0.25}, )" +
                                plane + plane + plane + plane +
                                R"({"type": "algebraic_plane", "normal": [0, 0, 1], "offset": 0}]})");
  const std::vector<std::string> arguments = {"render", "steep.json", "--output",       "a.png",   "--size",
                                              "40x30",  "--box",      "-1,-1,-1,1,1,1", "--steps", "64"};
  const Outcome outcome = folder_.run(arguments);
  EXPECT_EQ(outcome.status, 0);
  EXPECT_EQ(outcome.err.find("a.png: warning: gradients saturate at "), 0U) << outcome.err;
  EXPECT_EQ(std::count(outcome.err.begin(), outcome.err.end(), '\n'), 1);
  EXPECT_EQ(folder_.read("a.png").substr(1, 3), "PNG");
  std::vector<std::string> in_float = arguments;
  in_float.insert(in_float.end(), {"--scalar", "float"});
  succeed(in_float);
}

TEST_F(PictureCommands, SliceWritesBothKinds) {
  EXPECT_EQ(succeed({"slice", "ball.json", "--output", "a.svg", "--size", "200x160", "--plane", "x=0.1",
                     "--spacing", "0.1"}),
            "a.svg: \"a\", distance; x = 0.1 m; contours every 0.1 m\n");
  EXPECT_EQ(folder_.read("a.svg").substr(0, 5), "<?xml");
  succeed({"slice",    "ball.json", "--output",       "a.png", "--size",   "200x160", "--normal",
           "1,1,1",    "--bands",   "--wave",         "1,40",  "--wave",   "0.5,8",   "--arrows",
           "--levels", "5",         "--width-metres", "2",     "--origin", "0,0,0.1"});
  EXPECT_EQ(folder_.read("a.png").substr(1, 3), "PNG");
}

TEST_F(PictureCommands, MeshWritesBothKinds) {
  const std::string said = succeed({"mesh", "ball.json", "--output", "a.ply", "--resolution", "12"});
  EXPECT_EQ(said.find("a.ply: distance of \"a\", "), 0U) << said;
  EXPECT_EQ(folder_.read("a.ply").substr(0, 4), "ply\n");
  succeed({"mesh", "ball.json", "--output", "a.obj", "--resolution", "12", "--level", "0.1"});
  EXPECT_EQ(folder_.read("a.obj").substr(0, 2), "# ");
  expect_refusal(folder_, {"mesh", "plane.json", "--output", "b.ply", "--resolution", "12"},
                 "plane.json:2:1: field: the surface leaves the number range; --close, or a --box");
  expect_refusal(folder_,
                 {"mesh", "ball.json", "--output", "b.ply", "--resolution", "12", "--box", "0,0,0,1,1,1"},
                 "ball.json:2:1: field: the surface leaves --box; a larger --box, or --close");
  succeed(
      {"mesh", "ball.json", "--output", "b.ply", "--resolution", "12", "--box", "0,0,0,1,1,1", "--close"});
}

TEST_F(PictureCommands, RefuseWhatIsWrong) {
  struct Wrong {
    std::vector<std::string> arguments;
    std::string line;
  };
  const std::vector<Wrong> all = {
      {{"render", "--output", "x.png"}, "nearfield: which scene?"},
      {{"render", "ball.json"}, "nearfield: --output is required"},
      {{"render", "missing.json", "--output", "x.png"}, "missing.json: cannot be opened"},
      {{"render", "ball.json", "--output", "x.svg"}, "nearfield: --output x.svg: the name must end in .png"},
      {{"slice", "ball.json", "--output", "x.ply"},
       "nearfield: --output x.ply: the name must end in .svg or .png"},
      {{"mesh", "ball.json", "--output", "x.png"},
       "nearfield: --output x.png: the name must end in .ply or .obj"},
      {{"render", "ball.json", "--output", "x.png", "--size", "640"},
       "nearfield: --size 640: two whole numbers"},
      {{"render", "ball.json", "--output", "x.png", "--size", "5x5"},
       "nearfield: --size 5x5: two whole numbers"},
      {{"render", "ball.json", "--output", "x.png", "--camera", "1,2"},
       "nearfield: --camera 1,2: three numbers"},
      {{"render", "ball.json", "--output", "x.png", "--camera", "0,0,0.1"},
       "nearfield: --camera lies inside the surface"},
      {{"render", "ball.json", "--output", "x.png", "--camera", "0,0,2", "--look-at", "0,0,2"},
       "nearfield: --camera and --look-at are the same point"},
      {{"render", "ball.json", "--output", "x.png", "--field-of-view", "180"},
       "nearfield: --field-of-view 180: a number"},
      {{"render", "ball.json", "--output", "x.png", "--ground", "low"}, "nearfield: --ground low: a number"},
      {{"render", "ball.json", "--output", "x.png", "--colour", "red"}, "nearfield: --colour red: a hash"},
      {{"render", "ball.json", "--output", "x.png", "--box", "1,1,1,0,0,0"},
       "nearfield: --box 1,1,1,0,0,0: six numbers"},
      {{"render", "ball.json", "--output", "x.png", "--box", "0,0,0,5,5,5"},
       "nearfield: --box 0,0,0,5,5,5: six numbers"},
      {{"render", "ball.json", "--output", "x.png", "--threads", "0"},
       "nearfield: --threads 0 is not a whole number"},
      {{"render", "ball.json", "--output", "x.png", "--camra", "1,1,1"},
       "nearfield: unknown option \"camra\""},
      {{"render", "none.json", "--output", "x.png"},
       "none.json:2:1: field: no surface is found; the field is 0 nowhere"},
      {{"render", "morph.json", "--output", "x.png"},
       "morph.json:2:1: field: takes 1 parameters, of which 0 are given"},
      {{"mesh", "none.json", "--output", "x.ply", "--resolution", "8"},
       "none.json:2:1: field: no surface is found"},
      {{"mesh", "ball.json", "--output", "x.ply", "--resolution", "1000"},
       "nearfield: --resolution 1000 is not a whole"},
      {{"slice", "ball.json", "--output", "x.svg", "--plane", "w=1"}, "nearfield: --plane w=1: x, y or z"},
      {{"slice", "ball.json", "--output", "x.svg", "--plane", "z=9"}, "nearfield: --plane z=9: x, y or z"},
      {{"slice", "ball.json", "--output", "x.svg", "--normal", "0,0,0"},
       "nearfield: --normal has no direction"},
      {{"slice", "ball.json", "--output", "x.svg", "--spacing", "0"}, "nearfield: --spacing 0: a number"},
      {{"slice", "ball.json", "--output", "x.svg", "--spacing", "nan"}, "nearfield: --spacing nan: a number"},
      {{"slice", "ball.json", "--output", "x.svg", "--width-metres", "1e-12"},
       "nearfield: --width-metres 1e-12: a number from 1e-06 to 1000 m"},
      {{"slice", "ball.json", "--output", "x.svg", "--size", "16x16"},
       "nearfield: --size: a slice needs 160 pixels each way at least"},
      {{"render", "ball.json", "--output", "x.png", "--bands", "1e-300"},
       "nearfield: --bands 1e-300: a number from 1e-06 to 1000"},
      {{"render", "ball.json", "--output", "x.png", "--camera", "nan,0,0"},
       "nearfield: --camera nan,0,0: three numbers"},
      {{"render", "ball.json", "--output", "x.png", "--size", "nanxnan"},
       "nearfield: --size nanxnan: two whole numbers"},
      {{"render", "ball.json", "--output", "x.png", "--size", "99999x99999"},
       "nearfield: --size 99999x99999: two whole numbers"},
      {{"render", "ball.json", "--output", "x.png", "--level", "nan"}, "nearfield: --level nan: a number"},
      {{"slice", "ball.json", "--output", "x.svg", "--spacing", "1", "--levels", "3"},
       "nearfield: --levels and --spacing exclude each other"},
      {{"slice", "ball.json", "--output", "x.svg", "--wave", "1,2"}, "nearfield: --wave goes with --bands"},
      {{"slice", "ball.json", "--output", "x.svg", "--bands", "--wave", "1"},
       "nearfield: --wave 1: two numbers"},
      {{"render", "ball.json", "--output", "no/such/folder.png", "--size", "16x16"},
       "no/such/folder.png: cannot be created"}};
  for (const Wrong& wrong : all) expect_refusal(folder_, wrong.arguments, wrong.line);
}

TEST_F(PictureCommands, Help) {
  for (const char* verb : {"render", "slice", "mesh"}) {
    const std::string text = succeed({verb, "--help"});
    EXPECT_EQ(text.find(std::string("usage: nearfield ") + verb), 0U);
    EXPECT_NE(text.find("--output"), std::string::npos);
    EXPECT_NE(succeed({"help"}).find(std::string("  ") + verb), std::string::npos);
  }
}

}  // namespace
}  // namespace nearfield::host
