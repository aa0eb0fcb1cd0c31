// `nearfield eval`: fields of every kind at points, in every scalar, and what
// it must refuse.
#include <cmath>
#include <cstdlib>
#include <sstream>

#include "command_runner.hpp"

namespace nearfield::host {
namespace {

const std::string header = "x,y,z,value,gradient_x,gradient_y,gradient_z,clearance,status\n";

const std::string one_joint =
    R"(<robot name="r"><link name="base"/><link name="arm"/><link name="finger"/>
<joint name="turn" type="revolute"><parent link="base"/><child link="arm"/><origin xyz="0 0 0.5"/>
<axis xyz="0 0 1"/><limit lower="1.5707963267948966" upper="2"/></joint>
<joint name="slide" type="prismatic"><parent link="arm"/><child link="finger"/><origin xyz="1 0 0"/>
<axis xyz="1 0 0"/><limit lower="0" upper="1"/><mimic joint="turn" offset="-1.0707963267948966"/></joint>
</robot>)";

class EvalCommand : public testing::Test {
 protected:
  void SetUp() override {
    folder_.write("ball.json", scene("{\"type\": \"sphere\", \"radius\": 0.5}"));
    folder_.write("points.csv", "1,0,0\n");
    folder_.write("robot.urdf", one_joint);
  }

  static std::string scene(const std::string& field, const std::string& more = "") {
    return "{\"format\": \"nearfield-scene-1\", \"name\": \"a\", " + more + "\"field\":\n" + field + "}";
  }
  // What it prints for this field at these points, below the header.
  std::string lines(const std::string& scene_text, const std::string& points,
                    const std::vector<std::string>& options = {}) const {
    folder_.write("s.json", scene_text);
    folder_.write("p.csv", points);
    std::vector<std::string> arguments = {"eval", "s.json", "--points", "p.csv"};
    arguments.insert(arguments.end(), options.begin(), options.end());
    const Outcome outcome = folder_.run(arguments);
    EXPECT_EQ(outcome.status, 0) << outcome.err;
    EXPECT_EQ(outcome.err, "");
    EXPECT_EQ(outcome.out.substr(0, header.size()), header);
    return outcome.out.substr(std::min(header.size(), outcome.out.size()));
  }
  std::string lines_of_field(const std::string& field, const std::string& points,
                             const std::vector<std::string>& options = {}) const {
    return lines(scene(field), points, options);
  }

  ScratchFolder folder_;
};

// The cells of one line.
std::vector<std::string> cells_of(const std::string& line) {
  std::vector<std::string> cells;
  std::istringstream stream(line.substr(0, line.find('\n')));
  for (std::string cell; std::getline(stream, cell, ',');) cells.push_back(cell);
  return cells;
}
double number(const std::string& cell) { return std::strtod(cell.c_str(), nullptr); }

TEST_F(EvalCommand, Distances) {
  const std::string ball = "{\"type\": \"sphere\", \"radius\": 0.5}";
  const std::string points = "x,y,z\n1,0,0\n0.5,0,0\n0,-0.25,0\n17,0,0\n";
  EXPECT_EQ(lines_of_field(ball, points),
            "1,0,0,0.5,1,0,0,0.4999999776482582,clear\n"
            "0.5,0,0,0,1,0,0,-2.2351741790771484e-08,undecided\n"
            "0,-0.25,0,-0.25,0,-1,0,-0.2500000223517418,touching\n"
            "17,0,0,,,,,,invalid\n");
  EXPECT_EQ(lines_of_field(ball, points, {"--scalar", "q27"}), lines_of_field(ball, points));
  EXPECT_EQ(lines_of_field(ball, points, {"--scalar", "q16"}),
            "1,0,0,0.5,1,0,0,0.4999542236328125,clear\n"
            "0.5,0,0,0,1,0,0,-4.57763671875e-05,undecided\n"
            "0,-0.25,0,-0.25,0,-1,0,-0.2500457763671875,touching\n"
            "17,0,0,16.5,1,0,0,16.499954223632812,clear\n");
}

TEST_F(EvalCommand, EveryScalarSaysNearlyTheSame) {
  const std::string blend =
      "{\"type\": \"interior_union\", \"rising_range\": "
      "0.25, \"operands\": [{\"type\": \"sphere\", "
      "\"radius\": "
      "0.5}, {\"type\": \"box\", \"size\": [1, 1, 1], "
      "\"position\": [0.75, 0.5, 0]}]}";
  const std::vector<std::string> exact = cells_of(lines_of_field(blend, "0.1,0.9,0.4"));
  ASSERT_EQ(exact.size(), 9U);
  for (const char* scalar : {"q24", "q16", "float"}) {
    const std::vector<std::string> cells =
        cells_of(lines_of_field(blend, "0.1,0.9,0.4", {"--scalar", scalar}));
    ASSERT_EQ(cells.size(), 9U) << scalar;
    for (std::size_t i = 3; i < 8; ++i) EXPECT_NEAR(number(cells[i]), number(exact[i]), 5e-4) << scalar << i;
    EXPECT_EQ(cells[8], exact[8]);
  }
}

// Gradients are per metre, whatever the kind.
TEST_F(EvalCommand, IntensitiesHaveAClearanceToTheSoftSurface) {
  const std::string cubic = "{\"type\": \"soft_point\", \"influence_radius\": 2, \"weight\": 1}";
  const std::string text = lines_of_field(cubic, "1,0,0\n0,0,0\n3,0,0\n");
  std::istringstream stream(text);
  std::string at_surface, at_centre, outside;
  std::getline(stream, at_surface);
  std::getline(stream, at_centre);
  std::getline(stream, outside);
  EXPECT_NEAR(number(cells_of(at_surface)[3]), 0.5, 1e-6);
  EXPECT_NEAR(number(cells_of(at_surface)[4]), -19.0 / 24.0, 1e-5);
  EXPECT_EQ(cells_of(at_surface)[8], "undecided");
  EXPECT_EQ(at_centre, "0,0,0,1,0,0,0,0,touching");
  EXPECT_EQ(cells_of(outside)[3], "0");
  EXPECT_EQ(cells_of(outside)[8], "clear");
  EXPECT_GT(number(cells_of(outside)[7]), 1.99);
  EXPECT_LE(number(cells_of(outside)[7]), 2.0);
}

TEST_F(EvalCommand, RaysAndAlgebraicFieldsHaveNoClearance) {
  EXPECT_EQ(lines_of_field("{\"type\": \"ray_point\", \"influence_radius\": 2}", "1,0,0\n0,0,0\n"),
            "1,0,0,0.5,0.5,0,0,,no_clearance\n0,0,0,0,0,0,0,,no_clearance\n");
  EXPECT_EQ(lines_of_field("{\"type\": \"quadric\", \"diagonal\": [1, 1, 1], "
                           "\"constant\": -0.25}",
                           "0.5,0.25,0"),
            "0.5,0.25,0,0.0625,1,0.5,0,,no_clearance\n");
  EXPECT_EQ(cells_of(lines_of_field("{\"type\": \"variable_influence\", "
                                    "\"operands\": [{\"type\": \"ray_point\", "
                                    "\"influence_radius\": 1}, {\"type\": "
                                    "\"ray_point\", \"influence_radius\": 2}]}",
                                    "0.625,0,0"))[8],
            "no_clearance");
}

// What a number on the way to the value is too large for, the value is not.
TEST_F(EvalCommand, SaturatedValuesAreNamed) {
  const auto plane = [](const std::string& normal) {
    return "{\"type\": \"algebraic_plane\", \"normal\": " + normal + "}";
  };
  const std::string spline =
      "{\"type\": \"functional_spline\", \"primaries\": "
      "2, \"lambda\": 0.5, \"operands\": [" +
      plane("[4, 0, 0]") + ", " + plane("[-4, 0, 0]") + ", " + plane("[0, 4, 0]") + "]}";
  const std::string liming = "{\"type\": \"liming\", \"lambda\": 0.5, \"operands\": [" + plane("[4, 0, 0]") +
                             ", " + plane("[-4, 0, 0]") + ", " + plane("[0, 4, 0]") + "]}";
  // -8 x^2 + 8 y^2: both products are 16 and more in the second point, and
  // cancel out as they should.
  for (const std::string& blend : {spline, liming}) {
    EXPECT_EQ(lines_of_field(blend, "0.5,0.25,0\n1.5,1.5,0\n1.5,0.5,0\n"),
              "0.5,0.25,0,-1.5,-8,4,0,,no_clearance\n1.5,1.5,0,0,-24,24,0,,"
              "no_clearance\n"
              "1.5,0.5,0,-6,-24,8,0,,saturated\n");
    const std::vector<std::string> wide =
        cells_of(lines_of_field(blend, "1.5,0.5,0\n", {"--scalar", "float"}));
    EXPECT_EQ(wide[3] + wide[8], "-16no_clearance");
    const std::string moved =
        "{\"type\": \"place\", \"position\": [0.5, 0, 0], \"operands\": [" + blend + "]}";
    EXPECT_EQ(cells_of(lines_of_field(moved, "2,0.5,0\n"))[8], "saturated");
    EXPECT_EQ(cells_of(lines_of_field(moved, "1,0.25,0\n"))[8], "no_clearance");
    const std::string least =
        "{\"type\": \"algebraic_union\", \"operands\": [" + blend + ", " + plane("[1, 0, 0]") + "]}";
    EXPECT_EQ(cells_of(lines_of_field(least, "1.5,0.5,0\n"))[8], "saturated");
  }
  const std::string steep = "{\"type\": \"quadric\", \"diagonal\": [4, 4, 4], \"constant\": 0}";
  EXPECT_EQ(cells_of(lines_of_field(steep, "2,1,0\n"))[8], "saturated");
  EXPECT_EQ(cells_of(lines_of_field(steep, "1,1,0\n"))[8], "no_clearance");
  // Inside: of a product with the point, and of a gradient that is scaled down afterwards.
  EXPECT_EQ(cells_of(lines_of_field("{\"type\": \"quadric\", \"diagonal\": [4, 0, 0], \"off_diagonal\": "
                                    "[0, 4, 4], \"constant\": 0}",
                                    "0.05,4,4\n"))[8],
            "saturated");
  EXPECT_EQ(cells_of(lines_of_field("{\"type\": \"hoffmann_hopcroft_union\", \"r1\": 0.2, \"r2\": 2.8, \"operands\": "
                                    "[{\"type\": \"quadric\", \"diagonal\": [4, -4, 0], \"constant\": 0.1}, "
                                    "{\"type\": \"algebraic_plane\", \"normal\": [0, 0, 1], \"offset\": -0.15}]}",
                                    "3.9,3.9,0\n"))[8],
            "saturated");
  const std::string patch = "{\"type\": \"ribbon_patch\", \"side_weights\": [4, 4], \"operands\": [" +
                            plane("[4, 0, 0]") + ", " + plane("[0, 1, 0]") + ", " + plane("[-4, 0, 0]") +
                            ", " + plane("[0, 1, 0.5]") + "]}";
  EXPECT_EQ(cells_of(lines_of_field(patch, "1.25,1,1\n"))[8], "saturated");
  EXPECT_EQ(cells_of(lines_of_field(patch, "0.75,1,1\n"))[8], "no_clearance");
}

TEST_F(EvalCommand, ParametersComeWithTheCall) {
  const std::string morph =
      R"({"type": "morph", "parameter_slot": 1, "operands": [{"type": "sphere", "radius": 0.5},
{"type": "swell", "radius": 0.25, "parameter_slot": 0, "operands": [{"type": "sphere", "radius": 1}]}]})";
  const auto value = [&](const std::string& parameters) {
    return number(cells_of(lines_of_field(morph, "2,0,0\n", {"--parameters", parameters})).at(3));
  };
  EXPECT_EQ(value("0,0"), 1.5);
  EXPECT_EQ(value("1,0"), 1.5);
  EXPECT_EQ(value("0,1"), 1.0);
  EXPECT_EQ(value("1,1"), 0.75);
  EXPECT_EQ(value("0.5,0.5,0.25"), 1.1875);
  folder_.write("s.json", scene(morph));
  const Outcome missing = folder_.run({"eval", "s.json", "--points", "points.csv", "--parameters", "0.5"});
  EXPECT_EQ(missing.status, 2);
  EXPECT_EQ(missing.err,
            "s.json:2:1: field: takes 2 parameters, of which 1 are given; "
            "--parameters with as many numbers from 0 to 1\n");
  for (const std::string bad : {"1.5", "-0.1", "a", "0.5,", ",0.5", "nan", "0.5 0.5"}) {
    const Outcome outcome = folder_.run({"eval", "s.json", "--points", "points.csv", "--parameters", bad});
    EXPECT_EQ(outcome.status, 2) << bad;
    EXPECT_NE(outcome.err.find("--parameters"), std::string::npos) << bad;
    EXPECT_EQ(outcome.out, "") << bad;
  }
}

TEST_F(EvalCommand, PointsMayBeSpreadOut) {
  const std::string ball = "{\"type\": \"sphere\", \"radius\": 0.5}";
  const std::string expected = "1,0,0,0.5,1,0,0,0.4999999776482582,clear\n";
  for (const char* points :
       {"1,0,0", "1,0,0\n", "\n\n  1 ,\t0 , 0\r\n\n", " x , y,z\r\n1e0,0.0,-0\r\n", "10e-1,0,0\n \n"}) {
    std::string found = lines_of_field(ball, points);
    const std::size_t minus = found.find("-0");
    if (minus == 4) found.erase(minus, 1);  // the point stands as it was given
    EXPECT_EQ(found, expected) << points;
  }
  std::string many, all;
  for (int i = 0; i < 1000; ++i) {
    many += "1,0,0\n";
    all += expected;
  }
  EXPECT_EQ(lines_of_field(ball, many), all);
}

TEST_F(EvalCommand, OutputGoesToAFile) {
  const Outcome outcome =
      folder_.run({"eval", "ball.json", "--points", "points.csv", "--output", "made.csv"});
  EXPECT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_EQ(outcome.out + outcome.err, "");
  EXPECT_EQ(folder_.read("made.csv"), header + "1,0,0,0.5,1,0,0,0.4999999776482582,clear\n");
}

// The arm turns as little as its limits allow, a quarter; the finger slides by
// 0.5 more than 1.
TEST_F(EvalCommand, LinksAreWhereRobotsCarryThemAtRest) {
  const std::string finger = "{\"type\": \"sphere\", \"radius\": 0.5, \"link\": \"finger\"}";
  const std::vector<std::string> cells =
      cells_of(lines(scene(finger, "\"robot\": \"robot.urdf\", "), "0,2.5,0.5\n"));
  EXPECT_NEAR(number(cells[3]), 0.5, 1e-7);
  EXPECT_NEAR(number(cells[5]), 1.0, 1e-7);
  EXPECT_EQ(cells[8], "clear");
  const std::string person =
      "\"person\": {\"robot\": \"robot.urdf\", \"path\": [{\"time\": 0, "
      "\"joints\": {\"turn\": 1.6}}, "
      "{\"time\": 1, \"joints\": {\"turn\": 1.6}}]}, ";
  const std::string of_person =
      "{\"type\": \"union\", \"operands\": [{\"type\": \"sphere\", \"radius\": "
      "0.5, \"link\": "
      "\"person/finger\"}, {\"type\": \"sphere\", \"radius\": 0.25, \"link\": "
      "\"person/arm\"}]}";
  EXPECT_NEAR(number(cells_of(lines(scene(of_person, person), "0,2.5,0.5\n"))[3]), 0.5, 1e-7);
}

TEST_F(EvalCommand, TheWorkCellMayBeEvaluated) {
  const Outcome outcome =
      folder_.run({"eval", NEARFIELD_SOURCE_DIR "/host_sim/scenes/work_cell.json", "--points", "points.csv"});
  EXPECT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_NE(outcome.out.find(",clear\n"), std::string::npos) << outcome.out;
}

TEST_F(EvalCommand, WrongPointsAreRefused) {
  struct {
    const char* points;
    const char* says;
  } const cases[] = {
      {"", "p.csv: no points; three numbers in m: X,Y,Z"},
      {"\n\n", "p.csv: no points; "},
      {"x,y,z\n", "p.csv: no points; "},
      {"1,2\n", "p.csv:1:4: z: missing; three numbers in m: X,Y,Z"},
      {"1\n", "p.csv:1:2: y: missing"},
      {"1,2,3,4\n", "p.csv:1:7: 4 values"},
      {"1,2,3,\n", "p.csv:1:7: 4 values"},
      {"1,2,\n", "p.csv:1:5: z: \"\" is not a number"},
      {"0,0,0\n1, 2x ,3\n", "p.csv:2:4: y: \"2x\" is not a number"},
      {"0,0,0\n\nx,y,z\n", "p.csv:3:1: x: \"x\" is not a number"},
      {"x,y\n", "p.csv:1:1: x: \"x\" is not a number"},
      {"x,y,z\nx,y,z\n", "p.csv:2:1: x: \"x\" is not a number"},
      {"nan,0,0\n", "p.csv:1:1: x: \"nan\" is not a number"},
      {"0,inf,0\n", "p.csv:1:3: y: \"inf\" is not a number"},
      {"0,1e999,0\n", "p.csv:1:3: y: \"1e999\" is not a number"},
      {"0;0;0\n", "p.csv:1:1: x: \"0;0;0\" is not a number"},
      {"0,+1,0\n", "p.csv:1:3: y: \"+1\" is not a number"},
      {"0,0,\xff\n", "p.csv:1:5: bytes that are not UTF-8; the file must be UTF-8"},
      {"\xef\xbb\xbf" "x,y,z\n1,2,3\n", "p.csv:1:1: byte order mark; UTF-8 without one"},
      {"\xc3\xa9,0,0\n", "p.csv:1:1: x: \"\xc3\xa9\" is not a number"},
  };
  for (const auto& [points, says] : cases) {
    folder_.write("p.csv", points);
    expect_refusal(folder_, {"eval", "ball.json", "--points", "p.csv"}, says);
    expect_refusal(folder_, {"eval", "ball.json", "--points", "p.csv", "--output", "made.csv"}, says);
  }
}

TEST_F(EvalCommand, WrongScenesAreRefused) {
  struct {
    std::string scene;
    const char* says;
  } const cases[] = {
      {"{}", "s.json:1:1: format: missing"},
      {scene("{\"type\": \"sphere\", \"radius\": 9}"),
       "s.json:2:30: field.radius: 9 does not fit q27; from 0 to 4 m"},
      {scene("{\"type\": \"soft_sum\", \"operands\": [\n{\"type\": \"sphere\", "
             "\"radius\": 1}]}"),
       "s.json:3:1: field.operands[0]: \"sphere\" yields a distance; an "
       "intensity is needed here"},
      {scene("{\"type\": \"sphere\", \"radius\": 1, \"link\": \"arm\"}"),
       "s.json:2:1: field.link: link of a robot, but the scene has none; name "
       "one"},
      {scene("{\"type\": \"sphere\", \"radius\": 1, \"link\": \"leg\"}", "\"robot\": \"robot.urdf\", "),
       "s.json:2:1: field.link: no link \"leg\"; one of base, arm, finger"},
      {scene("{\"type\": \"sphere\", \"radius\": 1, \"link\": \"arm\"}", "\"robot\": \"absent.urdf\", "),
       "absent.urdf: cannot be opened"},
      {scene("{\"type\": \"soft_point\", \"influence_radius\": 1, "
             "\"potential\": \"arctangent_clamped\"}"),
       "s.json:2:60: field.potential: too steep for a table of 256 segments"},
      {scene("{\"type\": \"ray_plane\", \"normal\": [0, 0, 0], "
             "\"influence_radius\": 1}"),
       "s.json:2:33: field.normal: a zero vector has no direction"},
      {scene("{\"type\": \"scale_union\", \"r1\": 0.5, \"r2\": 0.5, \"p\": "
             "0.25, \"operands\": [{\"type\": "
             "\"ray_point\", "
             "\"influence_radius\": 1}, {\"type\": \"ray_point\", "
             "\"influence_radius\": 1}]}"),
       "s.json:2:52: field.p: the parameters do not fit each other; p is at "
       "most 0.99 r1 r2"},
      {scene("{\"type\": \"functional_spline\", \"lambda\": 0.5, "
             "\"primaries\": 2, \"operands\": [{\"type\": "
             "\"algebraic_plane\", \"normal\": [1, 0, 0]}, {\"type\": "
             "\"algebraic_plane\", \"normal\": [0, "
             "1, 0]}]}"),
       "s.json:2:59: field.primaries: 2 primaries of 2 operands"},
  };
  for (const auto& [text, says] : cases) {
    folder_.write("s.json", text);
    expect_refusal(folder_, {"eval", "s.json", "--points", "points.csv"}, says);
  }
}

TEST_F(EvalCommand, WrongCallsAreRefused) {
  struct {
    std::vector<std::string> arguments;
    const char* says;
  } const cases[] = {
      {{"eval"}, "nearfield: which scene? `nearfield eval SCENE --points FILE`"},
      {{"eval", "ball.json"}, "nearfield: --points is required"},
      {{"eval", "ball.json", "--points"}, "nearfield: --points needs a value"},
      {{"eval", "ball.json", "points.csv"}, "nearfield: unexpected argument \"points.csv\""},
      {{"eval", "ball.json", "--point", "points.csv"},
       "nearfield: unknown option \"point\" (did you mean \"points\"?)"},
      {{"eval", "ball.json", "--points", "absent.csv"}, "absent.csv: cannot be opened"},
      {{"eval", "absent.json", "--points", "points.csv"}, "absent.json: cannot be opened"},
      {{"eval", "ball.json", "--points", "points.csv", "--scalar", "q28"},
       "nearfield: --scalar: unknown name \"q28\" (did you mean \"q27\"?): it "
       "is one of q27, q24, q16, "
       "float"},
      {{"eval", "ball.json", "--points", "points.csv", "--output", "absent/made.csv"},
       "absent/made.csv: cannot be"},
  };
  for (const auto& [arguments, says] : cases) expect_refusal(folder_, arguments, says);
}

}  // namespace
}  // namespace nearfield::host
