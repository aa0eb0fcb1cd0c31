// The simulation of `nearfield sim`, tick by tick on the target: the same decisions, the same digest.
#include <work_cell/player.hpp>

#include <work_cell.inc>

#include <mps2/instruction_counter.hpp>
#include <mps2/semihosting.hpp>
#include <mps2/stack_watermark.hpp>

namespace {

using namespace nearfield;

using Player = work_cell::Player<work_cell::kArmLinks, work_cell::kArmBodies, work_cell::kPersonLinks, work_cell::kPersonBodies>;

alignas(Player) unsigned char player_memory[sizeof(Player)];

void print(const char* label, uint64_t number, const char* unit) {
  mps2::write(label);
  mps2::write_decimal(number);
  mps2::write(unit);
}

struct Extremes {
  uint32_t worst = 0;
  uint64_t sum = 0;
  uint32_t least_cell = 0x7fffffff, least_person = 0x7fffffff;  // 2^-27 m
  uint32_t in_zone[3] = {};
};

}  // namespace

// Placement into static memory, without the library header that declares it.
inline void* operator new(size_t, void* at) noexcept { return at; }

int main() {
  mps2::paint_unused_stack();
  const bool counting = mps2::prepare_instruction_counter();
  Player& player = *new (player_memory) Player(work_cell::kWorkCell);
  if (player.status() != work_cell::PlayerStatus::ok) {
    print("the player refuses the work cell: status ", static_cast<uint64_t>(player.status()), "\n");
    mps2::exit_with_status(1);
  }
  Extremes seen;
  for (uint32_t tick = 0; tick < player.ticks(); ++tick) {
    mps2::start_instruction_count();
    const ArmTick<work_cell::Q> decided = player.decide();
    const uint32_t instructions = mps2::stop_instruction_count();
    if (instructions > seen.worst) seen.worst = instructions;
    seen.sum += instructions;
    ++seen.in_zone[static_cast<uint32_t>(decided.zone)];
    player.advance(decided);
  }
  const uint32_t budget = player.monitor().budget();
  print("ticks ", player.ticks(), "\n");
  print("time in zones: free ", seen.in_zone[2], " ms");
  print(", slow ", seen.in_zone[1], " ms");
  print(", stop ", seen.in_zone[0], " ms");
  print("; cycles completed: ", player.cycles(), "\n");
  if (counting) {
    print("instructions a tick: mean ", seen.sum / player.ticks(), "");
    print(", worst ", seen.worst, "");
    print(", budget ", budget, "\n");
  }
  print("greatest stack ", mps2::greatest_stack_bytes(), " bytes\n");
  mps2::write("digest ");
  mps2::write_hexadecimal(player.digest(), 16);
  mps2::write("\n");
  mps2::exit_with_status(counting && seen.worst > budget ? 1 : 0);
}
