#include "command/command.hpp"

#include <cstdio>
#include <exception>

#include "command/options.hpp"
#include "text/input_error.hpp"
#include "text/names.hpp"

namespace nearfield::host {
namespace {

struct Verb {
  std::string name;
  int (*run)(const std::vector<std::string>&);
  std::string help;
};

const std::vector<Verb>& verbs() {
  static const std::vector<Verb> all = {
      {"sim", run_sim, "simulate a robot arm in a work cell with a person"},
      {"check", run_check, "clearances of a robot in the starts and goals of planning problems"},
      {"bake", run_bake, "write a work cell as C++ source for a target's flash"},
      {"curve", run_curve, "step and potential curves beside their tables: values, errors, pictures"},
      {"budget", run_budget, "worst-case instructions of a scene's field on each target"},
      {"eval", run_eval, "value, gradient and clearance of a scene's field at points"},
      {"render", run_render, "a picture of a scene's field in three dimensions"},
      {"slice", run_slice, "contours, bands and gradients of a scene's field in a plane"},
      {"mesh", run_mesh, "the surface of a scene's field as triangles"},
      {"gallery", run_gallery, "a page of pictures, drawn as the verbs above draw them"},
  };
  return all;
}

void print_help(std::FILE* to) {
  std::fprintf(to, "usage: nearfield VERB [OPTION...]\n\n");
  for (const Verb& verb : verbs()) std::fprintf(to, "  %-7s %s\n", verb.name.c_str(), verb.help.c_str());
  std::fprintf(to, "\n`nearfield VERB --help` tells more.\n");
}

int run(const Verb& verb, const std::vector<std::string>& arguments) {
  try {
    return verb.run(arguments);
  } catch (const UsageError& error) {
    throw InputError("nearfield", {}, "", error.what(), "`nearfield " + verb.name + " --help` tells more");
  }
}

int dispatch(const std::vector<std::string>& arguments) {
  if (arguments.empty()) {
    print_help(stderr);
    return 2;
  }
  if (arguments[0] == "help" || arguments[0] == "--help" || arguments[0] == "-h") {
    print_help(stdout);
    return 0;
  }
  std::vector<std::string_view> names;
  for (const Verb& verb : verbs()) {
    if (verb.name == arguments[0]) return run(verb, {arguments.begin() + 1, arguments.end()});
    names.push_back(verb.name);
  }
  throw UsageError(unknown_name("verb", arguments[0], names));
}

// Names that the user gave may hold line ends; an InputError's text never does.
void print_line(const InputError& error) { std::fprintf(stderr, "%s\n", error.what()); }

}  // namespace

int run_command(const std::vector<std::string>& arguments) {
  try {
    const int status = dispatch(arguments);
    // A full disk or a closed pipe must not look like success.
    if (std::fflush(stdout) != 0 || std::ferror(stdout) != 0) {
      throw InputError("standard output", {}, "", "cannot be written", "");
    }
    return status;
  } catch (const InputError& error) {
    print_line(error);
  } catch (const UsageError& error) {
    print_line(InputError("nearfield", {}, "", error.what(), "`nearfield help` lists what there is"));
  } catch (const std::exception& error) {
    print_line(InputError("nearfield", {}, "", error.what(), ""));
  }
  return 2;
}

}  // namespace nearfield::host
