// What a verb draws, before it is written anywhere, so that other verbs can draw the same.
#pragma once

#include <string>
#include <vector>

#include "command/options.hpp"
#include "render/parallel_rows.hpp"

namespace nearfield::host {

struct Drawing {
  std::string bytes;    // of a whole file
  std::string said;     // what is printed after the file's name
  std::string warning;  // what of the picture is not as it should be, in one line; mostly empty
};

// A verb that draws one picture, into the file that one of its options names.
struct DrawingVerb {
  std::string name;
  std::vector<OptionDescription> (*options)();
  std::string output;  // that option, without dashes
  std::string ending;  // of the file, with the dot: of two that there may be, the one without loss
  bool of_scene;       // its operand is a scene's file
  // As the verb does it: UsageError and InputError as that has them. Writes and prints nothing.
  Drawing (*draw)(const Options& options, const ReportProgress& report);
};

std::vector<OptionDescription> slice_options();
std::vector<OptionDescription> render_options();
std::vector<OptionDescription> curve_options();
Drawing draw_slice(const Options& options, const ReportProgress& report);
Drawing draw_scene(const Options& options, const ReportProgress& report);
Drawing draw_curve(const Options& options, const ReportProgress& report);

const std::vector<DrawingVerb>& drawing_verbs();

// A line on standard error, unless there is nothing to warn of.
void print_warning(const std::string& file, const Drawing& drawing);

}  // namespace nearfield::host
