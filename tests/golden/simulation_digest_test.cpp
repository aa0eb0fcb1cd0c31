// Every tick of the work cell that comes with Nearfield, bit for bit, against a digest recorded once.
// A change of this digest is a change of what the simulation decides.
#include <golden/simulation_digest.hpp>

#include <gtest/gtest.h>

#include <string>

#include "model/scene_reader.hpp"
#include "simulate/simulation.hpp"

namespace nearfield::host {
namespace {

const std::string folder = NEARFIELD_SOURCE_DIR "/host_sim/";

CompiledWorkCell default_work_cell() {
  return compile_work_cell(read_scene(folder + "scenes/work_cell.json"), folder + "robots/ur5e_like.urdf",
                           folder + "robots/ur5e_like.srdf");
}

std::uint64_t digest_of_first(std::uint32_t ticks) {
  CompiledWorkCell cell = default_work_cell();
  cell.settings.ticks = ticks;
  return simulate(cell, [](double) {}).digest;
}

TEST(SimulationDigest, DefaultWorkCell) {
  const SimulationResult result = simulate(default_work_cell(), [](double) {});
  EXPECT_EQ(result.ticks.size(), golden::kSimulationTicks);
  EXPECT_EQ(result.digest, golden::kSimulationDigest) << std::hex << "the run's digest is " << result.digest;
}

TEST(Simulation, DigestCoversEveryTick) {
  const std::uint64_t digest = digest_of_first(50);
  EXPECT_EQ(digest, digest_of_first(50));
  EXPECT_NE(digest, digest_of_first(49));
  EXPECT_NE(digest, digest_of_first(51));
}

}  // namespace
}  // namespace nearfield::host
