// What `nearfield curve` must refuse: wrong names, parameters, values, options and files.
#include "command_runner.hpp"

namespace nearfield::host {
namespace {

class CurveRefusals : public testing::Test {
 protected:
  void expect_refused(std::vector<std::string> arguments, const std::string& start_of_line) const {
    arguments.insert(arguments.begin(), "curve");
    expect_refusal(folder_, arguments, start_of_line);
  }

  ScratchFolder folder_;
};

TEST_F(CurveRefusals, RefusesTablesThatMissTheErrorAskedFor) {
  const std::string missed = "no table of at most 1024 bytes comes within 2^-20; the best reaches ";
  expect_refused({"arctangent", "--set", "c1=100", "--error", "20"},
                 "nearfield curve: arctangent: " + missed);
  expect_refused({"arctangent", "--set", "c1=100", "--error", "20", "--svg", "none"},
                 "nearfield curve: arctangent: " + missed);
}

TEST_F(CurveRefusals, RefusesRisingRangesOfAnythingButPicturesOfSteps) {
  expect_refused({"polynomial", "--rising-range", "0.5"}, "nearfield: --rising-range goes with --svg");
  expect_refused({"wyvill", "--rising-range", "0.5", "--svg", "-"},
                 "nearfield: --rising-range is of steps; wyvill is a potential");
  for (const char* wrong : {"0", "0.01", "1.5", "x"}) {
    expect_refused({"polynomial", "--rising-range", wrong, "--svg", "-"},
                   std::string("nearfield: --rising-range ") + wrong + ": a number from 0.02 to 1");
  }
}

TEST_F(CurveRefusals, RefusesWrongNames) {
  expect_refused({"bezir"}, "nearfield curve: unknown curve \"bezir\" (did you mean \"bezier\"?); ");
  expect_refused({"arctan_clamped"},
                 "nearfield curve: unknown curve \"arctan_clamped\" (did you mean \"arctangent_clamped\"?)");
  expect_refused({"xyzzy"},
                 "nearfield curve: unknown curve \"xyzzy\"; `nearfield curve --list` names them all");
  expect_refused({""}, "nearfield curve: unknown curve \"\"; ");
  expect_refused({"be\nzier"}, "nearfield curve: unknown curve \"be\\x0azier\" (did you mean \"bezier\"?); ");
  expect_refused({}, "nearfield curve: which curve?; `nearfield curve --list` names them all");
  expect_refused({"--csv", "-"}, "nearfield curve: which curve?; ");
  expect_refused({"bezier", "cubic"}, "nearfield: unexpected argument \"cubic\"");
  expect_refused({"-bezier"}, "nearfield: unexpected argument \"-bezier\"");
}

TEST_F(CurveRefusals, RefusesWrongParameters) {
  struct {
    const char* name;
    const char* setting;
    const char* line;
  } const cases[] = {
      {"rising_cutoff", "m=2", "unknown parameter \"m\"; it has n"},
      {"cutoff_from_polynomial", "strat=2",
       "unknown parameter \"strat\" (did you mean \"start\"?); it has n, start"},
      {"arctangent", "c3=1", "unknown parameter \"c3\" (did you mean \"c1\"?); it has c1, c2, w1, w2"},
      {"heaviside", "n=1", "unknown parameter \"n\"; it has none"},
      {"logistic", "w1=1", "unknown parameter \"w1\"; it has alpha"},
      {"arctangent", "=3", "unknown parameter \"\"; "},
      {"arctangent", "", "unknown parameter \"\"; "},
  };
  for (const auto& [name, setting, line] : cases) {
    expect_refused({name, "--set", setting}, "nearfield curve: " + std::string(name) + ": " + line);
  }
}

TEST_F(CurveRefusals, RefusesWrongValues) {
  struct {
    const char* name;
    std::vector<std::string> settings;
    const char* line;
  } const cases[] = {
      {"arctangent", {"c1=5000"}, "arctangent.c1: 5000 is out of range; from 1 to 1000"},
      {"arctangent", {"c1=-5"}, "arctangent.c1: -5 is out of range; from 1 to 1000"},
      {"arctangent", {"c1"}, "arctangent.c1: no value; c1=VALUE"},
      {"arctangent", {"c1="}, "arctangent.c1: 0 values; from 1 to 1000"},
      {"arctangent", {"c1=1,2"}, "arctangent.c1: 2 values; from 1 to 1000"},
      {"arctangent", {"c1=ten"}, "arctangent.c1: \"ten\" is not a number; from 1 to 1000"},
      {"arctangent", {"c1=nan"}, "arctangent.c1: \"nan\" is not a number; "},
      {"arctangent", {"c1=inf"}, "arctangent.c1: \"inf\" is not a number; "},
      {"arctangent", {"c1=1e999"}, "arctangent.c1: \"1e999\" is not a number; "},
      {"arctangent", {"c1= 10"}, "arctangent.c1: \" 10\" is not a number; "},
      {"arctangent", {"c1=10=10"}, "arctangent.c1: \"10=10\" is not a number; "},
      {"arctangent", {"c1=10", "c1=10"}, "arctangent.c1: set twice; "},
      {"polynomial", {"n=2.5"}, "polynomial.n: 2.5 is not a whole number; a whole number from 1 to 8"},
      {"polynomial", {"n=0"}, "polynomial.n: 0 is out of range; a whole number from 1 to 8"},
      {"polynomial", {"n=1e300"}, "polynomial.n: 1e+300 is out of range; "},
      {"bezier", {"b=1"}, "bezier.b: 1 value; 2 to 10 numbers from 0 to 1"},
      {"bezier", {"b="}, "bezier.b: 0 values; 2 to 10 numbers from 0 to 1"},
      {"bezier", {"b=1,1,1,1,1,1,0,0,0,0,0"}, "bezier.b: 11 values; 2 to 10 numbers from 0 to 1"},
      {"bezier", {"b=1,1.5,0"}, "bezier.b[1]: 1.5 is out of range; from 0 to 1"},
      {"bezier", {"b=1,,0"}, "bezier.b[1]: \"\" is not a number; from 0 to 1"},
      {"bezier", {"b"}, "bezier.b: no value; b=VALUE,..."},
      {"bezier", {"b=0,1"}, "bezier: the first coefficient is 1, the last 0"},
      {"bezier", {"b=1,0,1,1,0"}, "bezier: the curve of these coefficients is not monotone"},
      {"natural_spline", {"r=0,0.5,1"}, "natural_spline: as many values as places; "},
      {"bspline", {"knots="}, "bspline: there are degree + 1 + (number of knots) coefficients"},
      {"parametric_bezier_points",
       {"first=1"},
       "parametric_bezier_points.first: 1 value; 2 numbers from 0 to 1"},
      {"cubic", {"w1=0"}, "cubic.w1: 0 is out of range; from 0.01 to 3"},
      {"cubic", {"w1=0.5", "w2=0.75"}, "cubic: w2 is above 0, at most 1 and at most w1"},
      {"cubic", {"w2=2"}, "cubic.w2: 2 is out of range; from 0.01 to 1"},
  };
  for (const auto& [name, settings, line] : cases) {
    std::vector<std::string> arguments = {name};
    for (const std::string& setting : settings) arguments.insert(arguments.end(), {"--set", setting});
    expect_refused(arguments, std::string("nearfield curve: ") + line);
  }
}

TEST_F(CurveRefusals, RefusesWrongOptions) {
  struct {
    std::vector<std::string> options;
    const char* line;
  } const cases[] = {
      {{"--list"}, "--list goes without a name and without other options"},
      {{"--csv", "-", "--svg", "-"}, "--csv and --svg exclude each other"},
      {{"--csv"}, "--csv needs a value: FILE"},
      {{"--set"}, "--set needs a value: NAME=VALUE"},
      {{"--samples", "1"}, "--samples 1 is not a whole number from 2 to 100001"},
      {{"--samples", "100002"}, "--samples 100002 is not a whole number from 2 to 100001"},
      {{"--samples", "2.5"}, "--samples 2.5 is not a whole number"},
      {{"--samples", "many"}, "--samples many is not a whole number"},
      {{"--samples", "1e99"}, "--samples 1e99 is not a whole number"},
      {{"--error", "31"}, "--error 31 is not a whole number from 0 to 30"},
      {{"--error", "-1"}, "--error -1 is not a whole number"},
      {{"--bytes", "0"}, "--bytes 0 is not a whole number from 4 to 16384"},
      {{"--bytes", "16385"}, "--bytes 16385 is not"},
      {{"--degree", "0"}, "--degree 0 is not a whole number from 1 to 3"},
      {{"--degree", "4"}, "--degree 4 is not"},
      {{"--segments", "0"}, "--segments 0 is not a whole number from 1 to 1024"},
      {{"--segments", "1025"}, "--segments 1025 is not"},
      {{"--segments", "8", "--bytes", "64"}, "--segments and --bytes exclude each other"},
      {{"--segments", "7", "--degree", "2"}, "--segments 7 is odd"},
      {{"--bits", "24"}, "--bits 24 is neither 16 nor 32"},
      {{"--bits", "8"}, "--bits 8 is not a whole number from 16 to 32"},
      {{"--bits", "16", "--scalar", "float"}, "--bits 16 goes with fixed point"},
      {{"--argument", "squared"}, "--argument: unknown name \"squared\" (did you mean \"square\"?)"},
      {{"--argument", ""}, "--argument: unknown name \"\""},
      {{"--argument", "square"}, "--argument square is for curves whose range starts at 0"},
      {{"--scalar", "q28"}, "--scalar: unknown name \"q28\" (did you mean \"q27\"?)"},
      {{"--scalar", "double"}, "--scalar: unknown name \"double\""},
      {{"--smaples", "3"}, "unknown option \"smaples\" (did you mean \"samples\"?)"},
      {{"--bytes", "64", "--bytes", "64"}, "--bytes is given twice"},
  };
  for (const auto& [options, line] : cases) {
    std::vector<std::string> arguments = {"polynomial"};
    arguments.insert(arguments.end(), options.begin(), options.end());
    expect_refused(arguments, std::string("nearfield: ") + line);
  }
}

TEST_F(CurveRefusals, LeavesNothingBehindWhenTheFileCannotBeWritten) {
  folder_.write("folder/file", "kept");
  for (const char* kind : {"--csv", "--svg"}) {
    expect_refused({"bezier", kind, "absent/made"}, "absent/made: cannot be created: ");
    expect_refused({"bezier", kind, "folder"}, "folder: is a directory");
    expect_refused({"bezier", kind, "folder/file/made"}, "folder/file/made: ");
    expect_refused({"bezier", kind, ""}, "the file name is empty");
    expect_refused({"bezier", kind, "/dev/full"}, "/dev/full: cannot be written: ");
    expect_refused({"bezier", "--set", "b=0", kind, "folder/file"}, "nearfield curve: bezier.b: ");
  }
  EXPECT_EQ(folder_.read("folder/file"), "kept");
}

}  // namespace
}  // namespace nearfield::host
