// The simulation of `nearfield sim` on the default work cell, tick by tick: its digest must be that of the host.
#include <board/default_work_cell.hpp>
#include <board/digests.hpp>
#include <golden/simulation_digest.hpp>

int main() {
  using namespace nearfield;
  board::Player& player = board::start_player();
  if (player.status() != work_cell::PlayerStatus::ok) {
    board::write("the player refuses the work cell\n");
    return 1;
  }
  for (uint32_t tick = 0; tick < player.ticks(); ++tick) player.advance(player.decide());
  return board::print_digest("simulation", player.digest(), golden::kSimulationDigest) ? 0 : 1;
}
