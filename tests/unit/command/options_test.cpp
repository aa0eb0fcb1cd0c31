// How the command is called: help, verbs, options and their values, names of files.
#include <algorithm>

#include "command/options.hpp"
#include "command_runner.hpp"

namespace nearfield::host {
namespace {

const std::vector<std::string> verbs = {"sim",  "check", "bake",  "curve", "budget",
                                        "eval", "render", "slice", "mesh",  "gallery"};

/// What a refusal ends with: where to read on.
std::string help_for(const std::vector<std::string>& arguments) {
  const bool known = !arguments.empty() && std::count(verbs.begin(), verbs.end(), arguments[0]) != 0;
  return known ? "; `nearfield " + arguments[0] + " --help` tells more" : "; `nearfield help` lists what there is";
}

TEST(CommandOptions, HelpTellsOfEveryVerb) {
  const ScratchFolder folder;
  for (const char* help : {"help", "--help", "-h"}) {
    const Outcome outcome = folder.run({help});
    EXPECT_EQ(outcome.status, 0);
    EXPECT_EQ(outcome.err, "");
    for (const char* verb : {"  sim ", "  check ", "  bake ", "  curve ", "  eval "})
      EXPECT_NE(outcome.out.find(verb), std::string::npos);
  }
}

TEST(CommandOptions, HelpOfAVerbTellsOfItsOptions) {
  struct {
    const char* verb;
    std::vector<std::string> options;
  } const cases[] = {{"sim", {"scene", "robot", "srdf", "output", "duration", "help"}},
                     {"check", {"robot", "srdf", "problems", "json", "help"}},
                     {"bake", {"scene", "robot", "srdf", "output", "help"}},
                     {"curve",
                      {"set", "list", "csv", "svg", "samples", "error", "bytes", "degree", "segments", "bits",
                       "argument", "scalar", "help"}},
                     {"eval", {"points", "scalar", "output", "help"}}};
  const ScratchFolder folder;
  for (const auto& [verb, options] : cases) {
    const Outcome outcome = folder.run({verb, "--help"});
    EXPECT_EQ(outcome.status, 0) << verb;
    EXPECT_EQ(outcome.err, "") << verb;
    EXPECT_EQ(outcome.out.find(std::string("usage: nearfield ") + verb), 0U) << outcome.out;
    for (const std::string& option : options) {
      EXPECT_NE(outcome.out.find("--" + option), std::string::npos) << verb << " " << option;
    }
  }
  EXPECT_TRUE(folder.everything().empty());
}

TEST(CommandOptions, RepeatableOptionsKeepEveryValueInOrder) {
  const std::vector<OptionDescription> described = {{"set", "NAME=VALUE", "a parameter", true},
                                                    {"size", "N", "how large"},
                                                    {"flag", "", "yes"}};
  const Options options(described,
                        {"--set", "a=1", "--size=3", "--set=b=2", "--set", "--flag", "--set", "a=1"});
  EXPECT_EQ(options.values("set"), (std::vector<std::string>{"a=1", "b=2", "--flag", "a=1"}));
  EXPECT_EQ(options.value("set"), "a=1");
  EXPECT_EQ(options.required("set"), "a=1");
  EXPECT_EQ(options.values("size"), std::vector<std::string>{"3"});
  EXPECT_TRUE(options.values("flag").empty());
  EXPECT_FALSE(options.has("flag"));
  EXPECT_EQ(options.value("flag"), std::nullopt);
  const auto refused = [&described](const std::vector<std::string>& arguments) -> std::string {
    try {
      const Options ignored(described, arguments);
    } catch (const UsageError& error) {
      return error.what();
    }
    return "";
  };
  EXPECT_EQ(refused({"--size", "1", "--size", "1"}), "--size is given twice");
  EXPECT_EQ(refused({"--flag", "--set", "a", "--flag"}), "--flag is given twice");
  EXPECT_EQ(refused({"--set", "a", "--set"}), "--set needs a value: NAME=VALUE");
}

TEST(CommandOptions, OneOperandAnywhereWhereItIsAllowed) {
  const std::vector<OptionDescription> described = {{"size", "N", "how large"}};
  for (const std::vector<std::string>& arguments :
       {std::vector<std::string>{"word", "--size", "3"}, {"--size", "3", "word"}, {"--size=3", "word"}}) {
    const Options options(described, arguments, Operand::one);
    EXPECT_EQ(options.operand(), "word");
    EXPECT_EQ(options.value("size"), "3");
    EXPECT_THROW(Options(described, arguments), UsageError);
  }
  EXPECT_EQ(Options(described, {"--size", "word"}, Operand::one).operand(), std::nullopt);
  EXPECT_THROW(Options(described, {"word", "word"}, Operand::one), UsageError);
  EXPECT_THROW(Options(described, {"-word"}, Operand::one), UsageError);
}

TEST(CommandOptions, WithoutAVerbThereIsUsageOnStandardError) {
  const ScratchFolder folder;
  const Outcome outcome = folder.run({});
  EXPECT_EQ(outcome.status, 2);
  EXPECT_EQ(outcome.out, "");
  EXPECT_EQ(outcome.err.find("usage: nearfield VERB"), 0U);
}

TEST(CommandOptions, RefusesWrongCalls) {
  struct {
    std::vector<std::string> arguments;
    std::string line;
  } const cases[] = {
      {{"simm"}, "unknown verb \"simm\" (did you mean \"sim\"?)"},
      {{"xyzzy"}, "unknown verb \"xyzzy\""},
      {{""}, "unknown verb \"\""},
      {{"--scene", "a.json"}, "unknown verb \"--scene\""},
      {{"sim", "--sceen", "a.json"}, "unknown option \"sceen\" (did you mean \"scene\"?)"},
      {{"sim", "--"}, "unknown option \"\""},
      {{"sim", "a.json"}, "unexpected argument \"a.json\""},
      {{"sim", "-s"}, "unexpected argument \"-s\""},
      {{"sim", "--json"}, "unknown option \"json\""},
      {{"sim", "--scene"}, "--scene needs a value: FILE"},
      {{"sim", "--scene", "a.json", "--scene=b.json"}, "--scene is given twice"},
      {{"sim", "--duration", "1", "--duration", "1"}, "--duration is given twice"},
      {{"check", "--json", "--json"}, "--json is given twice"},
      {{"check", "--json=yes"}, "--json takes no value"},
      {{"check", "--problems", "p.json"}, "--robot is required"},
      {{"check", "--robot", "r.urdf"}, "--problems is required"},
      {{"bake"}, "--output is required"},
  };
  const ScratchFolder folder;
  for (const auto& [arguments, line] : cases) {
    EXPECT_EQ(refusal(folder, arguments), "nearfield: " + line + help_for(arguments)) << typed(arguments);
  }
}

TEST(CommandOptions, RefusesWrongDurations) {
  const ScratchFolder folder;
  for (const char* duration :
       {"0", "-1", "0.0009", "3600.1", "1e9", "1e999", "nan", "inf", "", " 1", "1s", "0x10"}) {
    expect_refusal(folder, {"sim", "--duration", duration}, std::string("nearfield: --duration ") + duration);
  }
}

TEST(CommandOptions, RefusalsStayOneLine) {
  const ScratchFolder folder;
  refusal(folder, {"sim\nbake"});
  refusal(folder, {"sim", "a\nb"});
  refusal(folder, {"sim", "--a\nb"});
  refusal(folder, {"sim", "--duration", "1\n2"});
  refusal(folder, {"sim", "--scene", "a\nb"});
  refusal(folder, {"bake", "--output", "a\nb/c"});
}

TEST(CommandOptions, RefusesFilesThatAreNone) {
  const ScratchFolder folder;
  folder.write("folder/file", "");
  for (const char* verb : {"sim", "bake"}) {
    const auto expect = [&](const char* option, const char* value, const std::string& line) {
      expect_refusal(folder, {verb, option, value, "--output", "made"}, line);
    };
    expect("--scene", "absent.json", "absent.json: cannot be opened: ");
    expect("--scene", "folder", "folder: is a directory");
    expect("--scene", "", "the file name is empty");
    expect("--scene", "folder/file/x", "folder/file/x: cannot be opened: ");
    expect("--robot", "absent.urdf", "absent.urdf: cannot be opened: ");
    expect("--robot", "folder", "folder: is a directory");
    expect("--robot", "", "the file name is empty");
    expect("--srdf", "absent.srdf", "absent.srdf: cannot be opened: ");
    expect("--srdf", "folder", "folder: is a directory");
  }
  const std::string robot = NEARFIELD_SOURCE_DIR "/host_sim/robots/ur5e_like.urdf";
  expect_refusal(folder, {"check", "--robot", "absent.urdf", "--problems", "p.json"},
                 "absent.urdf: cannot be opened: ");
  expect_refusal(folder, {"check", "--robot", robot, "--problems", "p.json"}, "p.json: cannot be opened: ");
  expect_refusal(folder, {"check", "--robot", robot, "--problems", "folder"}, "folder: is a directory");
}

TEST(CommandOptions, RefusesOutputThatCannotBeWritten) {
  const ScratchFolder folder;
  folder.write("file", "kept");
  folder.write("blocked/trace.csv/x", "");
  expect_refusal(folder, {"sim", "--duration", "0.01", "--output", "file"}, "file: ");
  expect_refusal(folder, {"sim", "--duration", "0.01", "--output", "file/below"}, "file/below: ");
  expect_refusal(folder, {"sim", "--duration", "0.01", "--output", ""}, "");
  expect_refusal(folder, {"sim", "--duration", "0.01", "--output", "blocked"},
                 "blocked/trace.csv: is a directory");
  expect_refusal(folder, {"bake", "--output", "absent/work_cell.inc"},
                 "absent/work_cell.inc: cannot be created: ");
  expect_refusal(folder, {"bake", "--output", "blocked"}, "blocked: is a directory");
  expect_refusal(folder, {"bake", "--output", ""}, "the file name is empty");
  expect_refusal(folder, {"bake", "--output", "/dev/full"}, "/dev/full: cannot be written: ");
  EXPECT_EQ(folder.read("file"), "kept");
}

TEST(CommandOptions, RefusesOutputOfWhichALaterFileCannotBeWritten) {
  const ScratchFolder folder;
  folder.write("blocked/timeline.svg/x", "");
  expect_refusal(folder, {"sim", "--duration", "0.01", "--output", "blocked"},
                 "blocked/timeline.svg: is a directory");
}

}  // namespace
}  // namespace nearfield::host
