// Every tick of an arm of the default work cell: kinematics, its cell, a person, itself.
#include <board/default_work_cell.hpp>

#include <images/report.hpp>

int main() {
  using namespace nearfield;
  board::Player& player = board::start_player();
  if (player.status() != work_cell::PlayerStatus::ok) return 1;
  for (uint32_t tick = 0; tick < 500; ++tick) player.advance(player.decide());
  board::report_stack();
  return 0;
}
