// The 1,400 configurations of 700 planning problems of a real arm, in fixed point, against the clearances
// that an independent program found for them in double precision.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <string>
#include <vector>

#include "simulate/check.hpp"
#include "text/json.hpp"
#include "text/json_node.hpp"
#include "text/read_file.hpp"

namespace nearfield::host {
namespace {

constexpr double greatest_shortfall = 20e-6;  // metres, what is promised
constexpr double aimed_shortfall = 2e-6;      // metres, what is reached

// How much smaller the reported clearances are than the true ones, in metres; all of one kind.
struct Shortfalls {
  std::vector<double> all;

  void compare(const Clearance<Q>& reported, double expected) {
    const double distance = reported.distance.to_double();
    EXPECT_LE(distance, expected);
    EXPECT_NE(reported.status, ClearanceStatus::invalid);
    EXPECT_LE(expected - distance, greatest_shortfall);
    EXPECT_EQ(reported.status == ClearanceStatus::clear, expected > 0.0)
        << "the true clearance is " << expected;
    all.push_back(expected - distance);
  }

  double greatest() const { return *std::max_element(all.begin(), all.end()); }
  double median() const {
    std::vector<double> sorted = all;
    const auto middle = sorted.begin() + static_cast<std::ptrdiff_t>(sorted.size() / 2);
    std::nth_element(sorted.begin(), middle, sorted.end());
    return *middle;
  }
  void print(const char* to) const {
    std::printf(
        "clearance to %s: %zu configurations, too small by %.3f um at the most, %.3f um in the median\n", to,
        all.size(), 1e6 * greatest(), 1e6 * median());
  }
};

TEST(Panda, ClearancesOfAllConfigurations) {
  const char* shared = std::getenv("NEARFIELD_SHARED_DATA");
  if (shared == nullptr) GTEST_SKIP() << "NEARFIELD_SHARED_DATA is not set: the panda data is not checked";
  const std::filesystem::path folder = std::filesystem::path(shared) / "panda";
  if (!std::filesystem::is_directory(folder))
    GTEST_SKIP() << folder << " is not there: the panda data is not checked";
  const auto path = [&folder](const char* name) { return (folder / name).string(); };

  const std::vector<CheckedProblem> checked =
      check_problems(path("panda_spherized.urdf"), path("panda.srdf"), path("problems.json"), [](double) {});
  const JsonDocument document = parse_json(read_file(path("expected.json")), path("expected.json"));
  const std::vector<JsonNode> expected = JsonNode(document).elements(700, 700);
  ASSERT_EQ(checked.size(), 700U);

  Shortfalls scene, itself;
  std::vector<std::string> not_valid;
  for (std::size_t i = 0; i < checked.size(); ++i) {
    const CheckedProblem& problem = checked[i];
    const std::string name = problem.set + " " + std::to_string(problem.index);
    ASSERT_EQ(expected[i].required("set").string(100), problem.set);
    ASSERT_EQ(expected[i].required("index").integer(0, 1000), problem.index);
    const auto compare = [&](const char* which, const CheckedConfiguration& configuration) {
      SCOPED_TRACE(name + " " + which);
      const JsonNode clearances = expected[i].required(which);
      scene.compare(configuration.scene, clearances.required("scene_clearance").number({}));
      itself.compare(configuration.itself, clearances.required("self_clearance").number({}));
      if (!configuration.clear()) not_valid.push_back(name + " " + which);
    };
    compare("start", problem.start);
    compare("goal", problem.goal);
  }
  scene.print("the scene");
  itself.print("itself");
  EXPECT_EQ(scene.all.size(), 1400U);
  EXPECT_LE(scene.greatest(), aimed_shortfall);
  EXPECT_LE(itself.greatest(), aimed_shortfall);
  EXPECT_EQ(not_valid, std::vector<std::string>{"table_pick_panda 41 goal"});
}

}  // namespace
}  // namespace nearfield::host
