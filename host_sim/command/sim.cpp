#include <cinttypes>
#include <cstdio>
#include <filesystem>
#include <utility>

#include "command/command.hpp"
#include "command/progress.hpp"
#include "command/work_cell_files.hpp"
#include "simulate/report.hpp"
#include "text/input_error.hpp"
#include "text/number.hpp"
#include "text/read_file.hpp"

namespace nearfield::host {
namespace {

std::vector<OptionDescription> sim_options() {
  std::vector<OptionDescription> options = work_cell_options();
  options.push_back({"output", "FOLDER", "where trace, timeline and pictures go; default: out/sim"});
  options.push_back({"duration", "SECONDS", "simulated time; default: the scene's"});
  options.push_back({"help", "", "this text"});
  return options;
}

double duration_of(const std::string& text) {
  const std::optional<double> seconds = parse_number(text);
  if (!seconds || !(*seconds >= 0.001) || !(*seconds <= 3600.0)) {
    throw UsageError("--duration " + text + " is not a number of seconds from 0.001 to 3600");
  }
  return *seconds;
}

void make_folder(const std::string& folder) {
  std::error_code error;
  std::filesystem::create_directories(folder, error);
  if (error) throw InputError(folder, {}, "", "cannot make this folder: " + error.message(), "");
}

using NamedText = std::pair<std::string, std::string>;

// All files or none: when one cannot be written, those before it are removed again.
void write_all(const std::string& folder, const std::vector<NamedText>& files) {
  std::vector<std::string> written;
  try {
    for (const auto& [name, text] : files) {
      write_file(folder + "/" + name, text);
      written.push_back(folder + "/" + name);
    }
  } catch (const InputError&) {
    for (const std::string& file : written) std::remove(file.c_str());
    throw;
  }
}

}  // namespace

int run_sim(const std::vector<std::string>& arguments) {
  const Options options(sim_options(), arguments);
  if (options.has("help")) {
    std::printf("usage: nearfield sim [OPTION...]\n\nRuns a robot arm in a work cell, with a person walking in, at 1 kHz "
                "in fixed point.\nWrites trace.csv, timeline.svg and pictures; prints a summary and a digest of every "
                "tick.\n\n%s", describe(sim_options()).c_str());
    return 0;
  }
  const std::string output = options.value("output").value_or("out/sim");
  WorkCellFiles inputs;
  CompiledWorkCell cell = compile_work_cell(options, inputs);
  if (const auto duration = options.value("duration")) {
    cell.settings.ticks = static_cast<std::uint32_t>(duration_of(*duration) * 1000.0 + 0.5);
  }
  make_folder(output);

  SimulationResult result;
  {
    Progress progress("simulating");
    result = simulate(cell, [&progress](double done) { progress.report(done); });
  }
  const std::vector<TellingMoment> moments = telling_moments(cell, result);
  std::vector<NamedText> files;
  {
    Progress progress("drawing   ");
    files.emplace_back("trace.csv", trace_csv(cell, result));
    if (result.ticks.size() > 1) files.emplace_back("timeline.svg", timeline_of(cell, result, moments));
    for (std::size_t i = 0; i < moments.size(); ++i) {
      progress.report(static_cast<double>(i) / static_cast<double>(moments.size()));
      files.emplace_back("moment_" + moments[i].letter + ".svg", picture_of(cell, result, moments[i]));
    }
  }
  write_all(output, files);
  std::printf("%s, %.3f s at 1 kHz, Fixed<27>\n", inputs.scene.c_str(), 0.001 * static_cast<double>(result.ticks.size()));
  std::printf("%s", summary_of(cell, result).c_str());
  std::printf("written to %s: trace.csv%s, %zu pictures\n", output.c_str(),
              result.ticks.size() > 1 ? ", timeline.svg" : "", moments.size());
  for (const TellingMoment& moment : moments) {
    std::printf("  moment_%s.svg  %7.3f s  %s\n", moment.letter.c_str(), result.ticks[moment.tick].time, moment.title.c_str());
  }
  std::printf("digest %016" PRIx64 "\n", result.digest);
  return 0;
}

}  // namespace nearfield::host
