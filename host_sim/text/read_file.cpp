#include "text/read_file.hpp"

#include <array>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <memory>
#include <system_error>

#include "text/input_error.hpp"

namespace nearfield::host {
namespace {

struct CloseFile {
  void operator()(std::FILE* file) const { std::fclose(file); }
};
using File = std::unique_ptr<std::FILE, CloseFile>;

[[noreturn]] void fail(const std::string& path, const std::string& message, const std::string& allowed) {
  throw InputError(path, SourcePosition{}, "", message, allowed);
}

std::string reason(int error_number) { return std::strerror(error_number); }

bool is_directory(const std::string& path) {
  std::error_code ignored;
  return std::filesystem::is_directory(path, ignored);
}

// True when every byte reached the file and it closed without an error; otherwise errno says why.
bool write_and_close(File file, std::string_view text) {
  const bool written = std::fwrite(text.data(), 1, text.size(), file.get()) == text.size();
  const int write_error = errno;
  if (std::fclose(file.release()) != 0) return false;
  if (!written) errno = write_error;
  return written;
}

// Creates a file that was not there before, named after `target`; stale ones of earlier failures stay.
File create_beside(const std::string& target, std::string& name) {
  for (int attempt = 0; attempt < 100; ++attempt) {
    name = target + ".partial" + std::to_string(attempt);
    File file(std::fopen(name.c_str(), "wbx"));
    if (file || errno != EEXIST) return file;
  }
  return nullptr;
}

}  // namespace

std::string read_file(const std::string& path) {
  const std::string needed = "a readable file is needed";
  if (path.empty()) fail(path, "the file name is empty", needed);
  if (is_directory(path)) fail(path, "is a directory", needed);
  errno = 0;
  const File file(std::fopen(path.c_str(), "rb"));
  if (!file) fail(path, "cannot be opened: " + reason(errno), needed);
  std::string text;
  std::array<char, 65536> chunk{};
  while (true) {
    const std::size_t count = std::fread(chunk.data(), 1, chunk.size(), file.get());
    if (count > largest_input_file - text.size()) {
      fail(path, "is too large", "at most " + std::to_string(largest_input_file >> 20U) + " MiB");
    }
    text.append(chunk.data(), count);
    if (count < chunk.size()) break;
  }
  if (std::ferror(file.get()) != 0) fail(path, "cannot be read: " + reason(errno), needed);
  return text;
}

void write_file(const std::string& path, std::string_view text) {
  const std::string needed = "a writable file name is needed";
  if (path.empty()) fail(path, "the file name is empty", needed);
  if (is_directory(path)) fail(path, "is a directory", needed);
  errno = 0;
  std::error_code error;
  const bool exists = std::filesystem::exists(path, error);
  if (exists && !std::filesystem::is_regular_file(path, error)) {
    File device(std::fopen(path.c_str(), "wb"));
    if (!device) fail(path, "cannot be opened: " + reason(errno), needed);
    if (!write_and_close(std::move(device), text)) fail(path, "cannot be written: " + reason(errno), needed);
    return;
  }
  std::string target = path;
  if (exists) {
    const auto followed = std::filesystem::canonical(path, error);
    if (!error) target = followed.string();
  }
  std::string partial;
  File file = create_beside(target, partial);
  if (!file) fail(path, "cannot be created: " + reason(errno), needed);
  bool replaced = write_and_close(std::move(file), text);
  std::string cause = reason(errno);
  if (replaced) {
    std::filesystem::rename(partial, target, error);
    replaced = !error;
    cause = error.message();
  }
  if (!replaced) {
    std::remove(partial.c_str());
    fail(path, "cannot be written: " + cause, needed);
  }
}

}  // namespace nearfield::host
