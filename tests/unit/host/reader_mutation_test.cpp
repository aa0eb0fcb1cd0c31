#include <gtest/gtest.h>

#include <cstdint>
#include <random>
#include <string>

#include "input_error_expectation.hpp"
#include "model/problems.hpp"
#include "model/scene_reader.hpp"
#include "model/srdf.hpp"
#include "model/urdf.hpp"
#include "scene_text.hpp"

namespace nearfield::host {
namespace {

constexpr std::uint32_t seed = 20240601;
constexpr int flips = 5000;

const std::string urdf_text = R"(<?xml version="1.0" encoding="utf-8"?>
<robot name="a&amp;b"><!-- arm -->
<link name="base"><collision><origin xyz="0 0 1" rpy="0 0.5 0"/><geometry><box size="1 2 3"/></geometry>
</collision></link>
<link name="hand"><collision><geometry><capsule radius="0.1" length="0.5"/></geometry></collision></link>
<joint name="turn" type="revolute"><parent link="base"/><child link="hand"/><axis xyz="0 1 0"/>
<limit lower="-1" upper="1" velocity="2"/></joint>
</robot>)";

const std::string srdf_text =
    R"(<robot name="a"><disable_collisions link1="base" link2="hand" reason="Adjacent"/></robot>)";

const std::string problem_text = R"([{"set": "s", "index": 1, "objects": [{"name": "\u00e9", "type": "box",
  "position": [0, 0, 1e-1], "orientation_xyzw": [0, 0, 0, 1], "size": [1, 2, 3]}],
  "start": {"turn": 0.5}, "goal": {"turn": -1}}])";

// Reads a text; anything thrown but InputError fails the test. True when it was accepted.
template <class Read>
bool accepts(const Read& read, const std::string& text) {
  try {
    read(text, "file");
    return true;
  } catch (const InputError& error) {
    EXPECT_EQ(std::string(error.what()).find('\n'), std::string::npos);
    EXPECT_NE(error.line(), 0U) << error.what();
    return false;
  }
}

template <class Read>
void mutate(const Read& read, const std::string& valid) {
  ASSERT_TRUE(accepts(read, valid));
  for (std::size_t length = 0; length < valid.size(); ++length) {
    const bool only_white_space_cut = valid.find_first_not_of(" \n", length) == std::string::npos;
    ASSERT_EQ(accepts(read, valid.substr(0, length)), only_white_space_cut) << "first " << length << " bytes";
  }
  std::mt19937 random(seed);
  int refused = 0;
  for (int flip = 0; flip < flips; ++flip) {
    SCOPED_TRACE(testing::Message() << "seed " << seed << ", flip " << flip);
    std::string text = valid;
    text[random() % text.size()] = static_cast<char>(random() % 256U);
    refused += accepts(read, text) ? 0 : 1;
  }
  EXPECT_GT(refused, flips / 4);
  EXPECT_LT(refused, flips);
}

TEST(ReaderMutation, Scene) { mutate(parse_scene, scene_text); }

TEST(ReaderMutation, Urdf) { mutate(parse_urdf, urdf_text); }

TEST(ReaderMutation, Srdf) {
  RobotDescription robot = parse_urdf(urdf_text, "file");
  mutate([&robot](const std::string& text, const std::string& file) { parse_srdf(text, file, robot); },
         srdf_text);
}

TEST(ReaderMutation, Problems) { mutate(parse_problems, problem_text); }

}  // namespace
}  // namespace nearfield::host
