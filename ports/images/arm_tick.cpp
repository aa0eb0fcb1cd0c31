// Every tick of an arm of the default work cell: kinematics, its cell, a person, itself.
#include <work_cell/player.hpp>

#include <work_cell.inc>

#include <images/report.hpp>

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
  if (player.status() != work_cell::PlayerStatus::ok) return 1;
  for (uint32_t tick = 0; tick < 500; ++tick) player.advance(player.decide());
  board::report_stack();
  return 0;
}
