// Runs the built command `nearfield` as a user does, and looks at all that comes out of it.
#pragma once

#include <fcntl.h>
#include <gtest/gtest.h>
#include <stdlib.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <stdexcept>
#include <string>
#include <vector>

#ifndef NEARFIELD_COMMAND
#error "the build names the command to run"
#endif

namespace nearfield::host {

inline std::string contents_of(const std::filesystem::path& file) {
  std::ifstream stream(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), {}};
}

struct Outcome {
  int status = -1;  // -1: it did not end by itself
  std::string out;
  std::string err;
};

// A folder of its own for one test; gone afterwards.
class ScratchFolder {
 public:
  ScratchFolder() {
    std::string name = (std::filesystem::temp_directory_path() / "nearfield_XXXXXX").string();
    if (mkdtemp(name.data()) == nullptr) throw std::runtime_error("cannot make a folder " + name);
    path_ = name;
  }
  ~ScratchFolder() {
    std::error_code ignored;
    std::filesystem::remove_all(path_, ignored);
    for (const char* stream : {".out", ".err"}) std::filesystem::remove(path_.string() + stream, ignored);
  }
  ScratchFolder(const ScratchFolder&) = delete;
  ScratchFolder& operator=(const ScratchFolder&) = delete;

  const std::filesystem::path& path() const { return path_; }
  std::string read(const std::string& name) const { return contents_of(path_ / name); }
  void write(const std::string& name, const std::string& text) const {
    std::filesystem::create_directories((path_ / name).parent_path());
    std::ofstream(path_ / name, std::ios::binary) << text;
  }

  // Names of all files and folders in it, however deep, sorted.
  std::vector<std::string> everything() const {
    std::vector<std::string> names;
    for (const auto& entry : std::filesystem::recursive_directory_iterator(path_)) {
      names.push_back(entry.path().lexically_relative(path_).generic_string());
    }
    std::sort(names.begin(), names.end());
    return names;
  }

  // Runs `nearfield ARGUMENTS...` in this folder, without a terminal.
  Outcome run(const std::vector<std::string>& arguments) const {
    const std::string out = path_.string() + ".out", err = path_.string() + ".err";
    const pid_t child = fork();
    if (child == 0) become_command(arguments, out, err);
    Outcome outcome;
    int status = 0;
    while (waitpid(child, &status, 0) < 0 && errno == EINTR) {
    }
    if (child > 0 && WIFEXITED(status)) outcome.status = WEXITSTATUS(status);
    outcome.out = contents_of(out);
    outcome.err = contents_of(err);
    return outcome;
  }

 private:
  [[noreturn]] void become_command(const std::vector<std::string>& arguments, const std::string& out,
                                   const std::string& err) const {
    std::vector<std::string> words = {NEARFIELD_COMMAND};
    words.insert(words.end(), arguments.begin(), arguments.end());
    std::vector<char*> pointers;
    for (std::string& word : words) pointers.push_back(word.data());
    pointers.push_back(nullptr);
    const auto redirect = [](const std::string& file, int to) {
      return dup2(open(file.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0600), to) == to;
    };
    if (chdir(path_.c_str()) == 0 && redirect(out, STDOUT_FILENO) && redirect(err, STDERR_FILENO)) {
      execv(pointers[0], pointers.data());
    }
    _exit(127);
  }

  std::filesystem::path path_;
};

// The arguments as one would type them, for messages.
inline std::string typed(const std::vector<std::string>& arguments) {
  std::string text = "nearfield";
  for (const std::string& argument : arguments) text += " " + argument;
  return text;
}

// Runs what must be refused: status 2, one line on standard error, nothing on standard output, and the folder
// left as it was. Returns that line, without its end.
inline std::string refusal(const ScratchFolder& folder, const std::vector<std::string>& arguments) {
  SCOPED_TRACE(typed(arguments));
  const std::vector<std::string> before = folder.everything();
  const Outcome outcome = folder.run(arguments);
  EXPECT_EQ(outcome.status, 2);
  EXPECT_EQ(outcome.out, "");
  EXPECT_EQ(std::count(outcome.err.begin(), outcome.err.end(), '\n'), 1) << outcome.err;
  EXPECT_EQ(folder.everything(), before);
  return outcome.err.substr(0, outcome.err.find('\n'));
}

inline void expect_refusal(const ScratchFolder& folder, const std::vector<std::string>& arguments,
                           const std::string& start_of_line) {
  const std::string line = refusal(folder, arguments);
  EXPECT_EQ(line.substr(0, start_of_line.size()), start_of_line) << typed(arguments);
}

}  // namespace nearfield::host
