// The simulation of `nearfield sim` on the default work cell, tick by tick: its digest must be that of the host.
#include <work_cell/player.hpp>

#include <work_cell.inc>

#include <board/digests.hpp>
#include <golden/simulation_digest.hpp>

namespace {

using namespace nearfield;
using Player = work_cell::Player<work_cell::kArmLinks, work_cell::kArmBodies, work_cell::kPersonLinks, work_cell::kPersonBodies,
                                 work_cell::Operations>;

alignas(Player) unsigned char player_memory[sizeof(Player)];

}  // namespace

// Placement into static memory, without the library header that declares it.
inline void* operator new(size_t, void* at) noexcept { return at; }

int main() {
  Player& player = *new (player_memory) Player(work_cell::kWorkCell);
  if (player.status() != work_cell::PlayerStatus::ok) {
    board::write("the player refuses the work cell\n");
    return 1;
  }
  for (uint32_t tick = 0; tick < player.ticks(); ++tick) player.advance(player.decide());
  return board::print_digest("simulation", player.digest(), golden::kSimulationDigest) ? 0 : 1;
}
