#include "text/read_file.hpp"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <random>
#include <string>

#include "text/input_error.hpp"

namespace nearfield::host {
namespace {

class ReadFile : public testing::Test {
 protected:
  void SetUp() override {
    std::random_device random;
    folder_ = std::filesystem::temp_directory_path() / ("nearfield_read_file_" + std::to_string(random()));
    std::filesystem::create_directory(folder_);
  }
  void TearDown() override { std::filesystem::remove_all(folder_); }

  std::string path(const std::string& name) const { return (folder_ / name).string(); }

  std::filesystem::path folder_;
};

TEST_F(ReadFile, ReadsBackWhatWasWritten) {
  const std::string text = std::string("a\0b\r\n", 5) + std::string(200000, 'x');
  write_file(path("a"), text);
  EXPECT_EQ(read_file(path("a")), text);
  write_file(path("a"), "");
  EXPECT_EQ(read_file(path("a")), "");
  std::size_t files = 0;
  for (const auto& entry : std::filesystem::directory_iterator(folder_)) files += entry.exists() ? 1U : 0U;
  EXPECT_EQ(files, 1U) << "a partial file stayed";
}

TEST_F(ReadFile, ErrorsNameTheFile) {
  const auto message = [](const std::string& file) -> std::string {
    try {
      read_file(file);
      return "read";
    } catch (const InputError& error) {
      return error.what();
    }
  };
  EXPECT_EQ(message(path("missing")),
            path("missing") + ": cannot be opened: No such file or directory; a readable file is needed");
  EXPECT_EQ(message(folder_.string()), folder_.string() + ": is a directory; a readable file is needed");
  EXPECT_EQ(message(""), "the file name is empty; a readable file is needed");
}

TEST_F(ReadFile, SizeIsLimited) {
  std::ofstream(path("a")).put('x');
  std::filesystem::resize_file(path("a"), largest_input_file);
  EXPECT_EQ(read_file(path("a")).size(), largest_input_file);
  std::filesystem::resize_file(path("a"), largest_input_file + 1);
  EXPECT_THROW(read_file(path("a")), InputError);
}

TEST_F(ReadFile, WritingFollowsLinksAndKeepsThem) {
  write_file(path("target"), "old");
  std::filesystem::create_symlink("target", path("link"));
  write_file(path("link"), "new");
  EXPECT_TRUE(std::filesystem::is_symlink(path("link")));
  EXPECT_EQ(read_file(path("target")), "new");
}

TEST_F(ReadFile, WritingToADeviceLeavesItADevice) {
  write_file("/dev/null", "text");
  EXPECT_TRUE(std::filesystem::is_character_file("/dev/null"));
}

TEST_F(ReadFile, WritingWhereNothingCanBeIsAnError) {
  EXPECT_THROW(write_file(folder_.string(), "text"), InputError);
  EXPECT_THROW(write_file(path("no/such/folder"), "text"), InputError);
  EXPECT_THROW(write_file("", "text"), InputError);
}

TEST(InputErrorLine, LeavesOutWhatIsUnknownAndStaysOneLine) {
  EXPECT_STREQ(InputError("f", {3, 4}, "a.b", "wrong", "right").what(), "f:3:4: a.b: wrong; right");
  EXPECT_STREQ(InputError("f", {}, "", "wrong", "").what(), "f: wrong");
  EXPECT_STREQ(InputError("", {}, "a", "two\nlines", "").what(), "a: two\\x0alines");
}

}  // namespace
}  // namespace nearfield::host
