#include <gtest/gtest.h>

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "model/problems.hpp"
#include "model/scene_reader.hpp"
#include "model/srdf.hpp"
#include "model/urdf.hpp"
#include "text/read_file.hpp"

namespace nearfield::host {
namespace {

// The page that documents the formats, found from this file's own place in the source tree.
std::string formats_page() {
  const std::filesystem::path folder = std::filesystem::path(__FILE__).parent_path();
  return read_file((folder / "../../../host_sim/FORMATS.md").string());
}

std::vector<std::string> code_blocks(const std::string& page, const std::string& language) {
  std::vector<std::string> blocks;
  const std::string opening = "```" + language + "\n";
  for (std::size_t at = page.find(opening); at != std::string::npos; at = page.find(opening, at + 1)) {
    const std::size_t begin = at + opening.size();
    blocks.push_back(page.substr(begin, page.find("```", begin) - begin));
  }
  return blocks;
}

TEST(FormatsPage, ItsExamplesAreValid) {
  const std::string page = formats_page();
  const std::vector<std::string> json = code_blocks(page, "json");
  const std::vector<std::string> xml = code_blocks(page, "xml");
  ASSERT_EQ(json.size(), 2U);
  ASSERT_EQ(xml.size(), 2U);
  EXPECT_EQ(parse_scene(json[0], "scene").field.operands.size(), 2U);
  EXPECT_EQ(parse_problems(json[1], "problems").size(), 1U);
  RobotDescription robot = parse_urdf(xml[0], "urdf");
  parse_srdf(xml[1], "srdf", robot);
  EXPECT_EQ(robot.unchecked_pairs.size(), 1U);
}

TEST(FormatsPage, NamesEveryOperatorParameterAndChoice) {
  const std::string page = formats_page();
  const auto expect_named = [&page](std::string_view name) {
    EXPECT_NE(page.find(std::string(name) + "`"), std::string::npos) << name;
  };
  for (const OperatorDescription& row : all_operators()) {
    expect_named(row.name);
    for (const ParameterDescription& parameter : row.parameters) expect_named(parameter.key);
    for (const ChoiceDescription& choice : row.choices) {
      expect_named(choice.key);
      for (const std::string_view name : choice.names) expect_named("\"" + std::string(name) + "\"");
    }
    for (const CurveDescription& curve : row.curves) {
      expect_named(curve.key);
      expect_named("\"" + std::string(curve.default_name) + "\"");
    }
  }
}

}  // namespace
}  // namespace nearfield::host
