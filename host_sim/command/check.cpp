#include <algorithm>
#include <cstdio>


#include "command/command.hpp"
#include "command/options.hpp"
#include "command/progress.hpp"
#include "simulate/check.hpp"
#include "text/json_writer.hpp"

namespace nearfield::host {
namespace {

std::vector<OptionDescription> check_options() {
  return {{"robot", "FILE", "robot (URDF, required)"},
          {"srdf", "FILE", "link pairs not to check; without it, all but directly joined links are"},
          {"problems", "FILE", "problems (JSON, see host_sim/FORMATS.md; required)"},
          {"json", "", "print a JSON list, one entry a problem, instead of words"},
          {"help", "", "this text"}};
}

void write_json(const std::vector<CheckedProblem>& problems) {
  JsonWriter json;
  json.begin_array();
  for (const CheckedProblem& problem : problems) {
    json.begin_object().key("set").string(problem.set).key("index").integer(problem.index);
    const auto configuration = [&json](const char* name, const CheckedConfiguration& c) {
      json.key(name).begin_object();
      json.key("scene_clearance").number(c.scene.distance.to_double());
      json.key("self_clearance").number(c.itself.distance.to_double());
      json.end_object();
    };
    configuration("start", problem.start);
    configuration("goal", problem.goal);
    json.end_object();
  }
  json.end_array();
  std::printf("%s\n", json.text().c_str());
}

void write_words(const std::vector<CheckedProblem>& problems) {
  std::size_t valid = 0;
  for (const CheckedProblem& problem : problems) {
    if (problem.valid()) {
      ++valid;
      continue;
    }
    std::printf("%s %lld:", problem.set.c_str(), static_cast<long long>(problem.index));
    const auto configuration = [](const char* name, const CheckedConfiguration& c) {
      if (!c.clear()) {
        std::printf(" %s scene %.6f m, self %.6f m", name, c.scene.distance.to_double(), c.itself.distance.to_double());
      }
    };
    configuration("start", problem.start);
    configuration("goal", problem.goal);
    std::printf("\n");
  }
  std::printf("%zu of %zu problems have a clear start and goal\n", valid, problems.size());
}

}  // namespace

int run_check(const std::vector<std::string>& arguments) {
  const Options options(check_options(), arguments);
  if (options.has("help")) {
    std::printf("usage: nearfield check --robot FILE --problems FILE [OPTION...]\n\nFor every start and goal of a problem "
                "file: the least signed clearance to the scene and of the robot to itself,\nin fixed point, never too "
                "large. Exit status 1 if one is not clear.\n\n%s", describe(check_options()).c_str());
    return 0;
  }
  const std::string robot = options.required("robot"), problems = options.required("problems");
  std::vector<CheckedProblem> checked;
  {
    Progress progress("checking");
    checked = check_problems(robot, options.value("srdf").value_or(""), problems,
                             [&progress](double done) { progress.report(done); });
  }
  if (options.has("json")) write_json(checked);
  else write_words(checked);
  const bool all = std::all_of(checked.begin(), checked.end(), [](const CheckedProblem& p) { return p.valid(); });
  return all ? 0 : 1;
}

}  // namespace nearfield::host
