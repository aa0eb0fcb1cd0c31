// The verbs of the command `nearfield`.
#pragma once

#include <string>
#include <vector>

namespace nearfield::host {

// Each returns the exit status: 0, or 1 where the answer itself is no. InputError and UsageError mean status 2.
int run_sim(const std::vector<std::string>& arguments);
int run_check(const std::vector<std::string>& arguments);
int run_bake(const std::vector<std::string>& arguments);
int run_curve(const std::vector<std::string>& arguments);
int run_budget(const std::vector<std::string>& arguments);
int run_eval(const std::vector<std::string>& arguments);
int run_render(const std::vector<std::string>& arguments);
int run_slice(const std::vector<std::string>& arguments);
int run_mesh(const std::vector<std::string>& arguments);
int run_gallery(const std::vector<std::string>& arguments);

// The whole command: finds the verb, prints help, turns errors into one line on standard error and status 2.
int run_command(const std::vector<std::string>& arguments);

}  // namespace nearfield::host
