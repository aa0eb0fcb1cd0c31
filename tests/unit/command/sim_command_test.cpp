// `nearfield sim` and `nearfield bake` on the work cell that comes with Nearfield.
#include <golden/simulation_digest.hpp>

#include <cinttypes>
#include <cstdio>
#include <regex>

#include "command_runner.hpp"

namespace nearfield::host {
namespace {

std::string last_line(const std::string& text) {
  const std::size_t end = text.find_last_not_of('\n') + 1;
  const std::size_t before = text.rfind('\n', end - 1);
  return text.substr(before == std::string::npos ? 0 : before + 1,
                     end - (before == std::string::npos ? 0 : before + 1));
}

std::size_t line_count(const std::string& text) {
  return static_cast<std::size_t>(std::count(text.begin(), text.end(), '\n'));
}

TEST(SimCommand, WholeRun) {
  const ScratchFolder folder;
  const Outcome outcome = folder.run({"sim"});
  ASSERT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_EQ(outcome.err, "") << "no progress bar without a terminal";

  char digest[40];
  std::snprintf(digest, sizeof digest, "digest %016" PRIx64, golden::kSimulationDigest);
  EXPECT_EQ(last_line(outcome.out), digest);
  for (const char* word : {"least clearance to the cell", "least clearance to the person",
                           "least clearance to itself", "time in zones: free ", "worst tick: "}) {
    EXPECT_NE(outcome.out.find(word), std::string::npos) << word;
  }

  const std::string trace = folder.read("out/sim/trace.csv");
  EXPECT_EQ(line_count(trace), golden::kSimulationTicks + 1);
  EXPECT_EQ(trace.find("time_s,zone,speed_override,cell_status,cell_clearance_m,"), 0U);
  const std::size_t columns = static_cast<std::size_t>(
      std::count(trace.begin(), trace.begin() + static_cast<std::ptrdiff_t>(trace.find('\n')), ','));
  EXPECT_EQ(static_cast<std::size_t>(std::count(trace.begin(), trace.end(), ',')),
            columns * line_count(trace));
  for (const char* zone : {",free,", ",slow,", ",stop,"})
    EXPECT_NE(trace.find(zone), std::string::npos) << zone;

  std::vector<std::string> expected = {"out", "out/sim", "out/sim/timeline.svg", "out/sim/trace.csv"};
  for (const char letter : {'A', 'B', 'C', 'D', 'E', 'F'})
    expected.push_back(std::string("out/sim/moment_") + letter + ".svg");
  std::sort(expected.begin(), expected.end());
  EXPECT_EQ(folder.everything(), expected);
  for (const std::string& file : expected) {
    if (file.size() < 4 || file.substr(file.size() - 4) != ".svg") continue;
    const std::string picture = folder.read(file);
    EXPECT_GT(picture.size(), 2000U) << file;
    EXPECT_NE(picture.find("<svg"), std::string::npos) << file;
    EXPECT_EQ(last_line(picture), "</svg>") << file;
  }
}

TEST(SimCommand, DurationAndOutput) {
  const ScratchFolder folder;
  for (const auto& [duration, ticks] :
       {std::pair("0.001", 1U), std::pair("0.002", 2U), std::pair("0.25", 250U)}) {
    const std::string output = std::string("for_") + duration;
    const Outcome outcome = folder.run({"sim", "--duration", duration, "--output=" + output});
    ASSERT_EQ(outcome.status, 0) << outcome.err;
    EXPECT_TRUE(std::regex_match(last_line(outcome.out), std::regex("digest [0-9a-f]{16}"))) << outcome.out;
    EXPECT_EQ(line_count(folder.read(output + "/trace.csv")), ticks + 1) << duration;
    const bool says_timeline = outcome.out.find("timeline.svg") != std::string::npos;
    EXPECT_EQ(says_timeline, std::filesystem::exists(folder.path() / output / "timeline.svg")) << outcome.out;
  }
}

TEST(SimCommand, RunsAgainOverItsOwnOutput) {
  const ScratchFolder folder;
  const std::vector<std::string> arguments = {"sim", "--duration", "0.02", "--output", "a/b"};
  const Outcome first = folder.run(arguments);
  const std::vector<std::string> files = folder.everything();
  const std::string trace = folder.read("a/b/trace.csv");
  const Outcome second = folder.run(arguments);
  EXPECT_EQ(second.status, 0) << second.err;
  EXPECT_EQ(second.out, first.out);
  EXPECT_EQ(folder.everything(), files);
  EXPECT_EQ(folder.read("a/b/trace.csv"), trace);
}

TEST(SimCommand, RobotBesideItsSceneIsTheRobotNamed) {
  const ScratchFolder folder;
  const std::string host_sim = NEARFIELD_SOURCE_DIR "/host_sim/";
  const Outcome by_default = folder.run({"sim", "--duration", "0.05", "--output", "a"});
  const Outcome named = folder.run(
      {"sim", "--duration", "0.05", "--output", "b", "--scene", host_sim + "scenes/work_cell.json", "--robot",
       host_sim + "robots/ur5e_like.urdf", "--srdf", host_sim + "robots/ur5e_like.srdf"});
  EXPECT_EQ(last_line(named.out), last_line(by_default.out));
}

TEST(BakeCommand, WritesASourceFile) {
  const ScratchFolder folder;
  const Outcome outcome = folder.run({"bake", "--output", "work_cell.inc"});
  ASSERT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_EQ(outcome.err, "");
  EXPECT_EQ(line_count(outcome.out), 1U);
  EXPECT_EQ(folder.everything(), std::vector<std::string>{"work_cell.inc"});
  const std::string source = folder.read("work_cell.inc");
  for (const char* name : {"kWorkCell", "kArmLinks", "kArmBodies", "kPersonLinks", "kPersonBodies"}) {
    EXPECT_NE(source.find(name), std::string::npos) << name;
  }
  EXPECT_EQ(source.find(NEARFIELD_SOURCE_DIR), std::string::npos)
      << "the source names a place on this machine";
  folder.run({"bake", "--output", "again.inc"});
  EXPECT_EQ(folder.read("again.inc"), source);
}

}  // namespace
}  // namespace nearfield::host
