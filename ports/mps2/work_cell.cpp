// The simulation of `nearfield sim`, tick by tick on the target: the same decisions, the same digest.
#include <board/console.hpp>
#include <board/default_work_cell.hpp>
#include <board/instruction_counter.hpp>
#include <board/stack_watermark.hpp>

namespace {

using namespace nearfield;

void print(const char* label, uint64_t number, const char* unit) {
  board::write(label);
  board::write_decimal(number);
  board::write(unit);
}

// Instructions of one kind of work over the whole run.
struct Cost {
  uint32_t worst = 0;
  uint64_t sum = 0;

  void add(uint32_t instructions) {
    if (instructions > worst) worst = instructions;
    sum += instructions;
  }
  // One line; false if the budget was exceeded.
  bool report(const char* what, uint32_t count, uint32_t budget) const {
    print(what, sum / count, "");
    print(", worst ", worst, "");
    print(", budget ", budget, worst > budget ? " EXCEEDED\n" : "\n");
    return worst <= budget;
  }
};

// A point of the cell's surroundings, a different one for each tick.
Vector3<work_cell::Q> point_of(uint32_t tick) {
  const auto coordinate = [tick](uint32_t factor) {
    return work_cell::Q::from_raw(static_cast<int32_t>((tick + 1) * factor) >> 3);  // within 2 m
  };
  return {coordinate(2654435761u), coordinate(2246822519u), coordinate(3266489917u)};
}

__attribute__((noinline)) Clearance<work_cell::Q> query(const board::Player::Field& cell, const Vector3<work_cell::Q>& p) {
  return clearance(cell, p);
}

volatile int32_t sink;

}  // namespace

int main() {
  board::paint_unused_stack();
  const bool counting = board::prepare_instruction_counter();
  board::Player& player = board::start_player();
  if (player.status() != work_cell::PlayerStatus::ok) {
    print("the player refuses the work cell: status ", static_cast<uint64_t>(player.status()), "\n");
    board::exit_with_status(1);
  }
  Cost tick_cost, query_cost;
  uint32_t in_zone[3] = {};
  for (uint32_t tick = 0; tick < player.ticks(); ++tick) {
    board::start_instruction_count();
    const ArmTick<work_cell::Q> decided = player.decide();
    tick_cost.add(board::stop_instruction_count());
    ++in_zone[static_cast<uint32_t>(decided.zone)];
    const Vector3<work_cell::Q> p = point_of(tick);
    board::start_instruction_count();
    const Clearance<work_cell::Q> c = query(player.cell(), p);
    query_cost.add(board::stop_instruction_count());
    sink = c.distance.raw();
    player.advance(decided);
  }
  print("ticks ", player.ticks(), "\n");
  print("time in zones: free ", in_zone[2], " ms");
  print(", slow ", in_zone[1], " ms");
  print(", stop ", in_zone[0], " ms");
  print("; cycles completed: ", player.cycles(), "\n");
  bool within_budget = true;
  if (counting) {
    within_budget = tick_cost.report("instructions a tick: mean ", player.ticks(), player.monitor().budget());
    within_budget &= query_cost.report("instructions a query of the cell: mean ", player.ticks(), player.cell().budget().gradient);
  }
  print("greatest stack ", board::greatest_stack_bytes(), " bytes\n");
  board::write("digest ");
  board::write_hexadecimal(player.digest(), 16);
  board::write("\n");
  board::exit_with_status(within_budget ? 0 : 1);
}
