// What one whole tick of an arm costs on this core, next to straightforward float code for the same work: worst and mean over
// 1,000 ticks of the default work cell, 24 ms apart. Fails if the counter is not exact, if they do not tell the same, or if
// what is composed in the source does not give the bits of images.
#include <board/console.hpp>
#include <board/cost_rows.hpp>
#include <board/default_work_cell.hpp>

#include <tick_costs/composed.hpp>
#include <tick_costs/in_float.hpp>

namespace {

using namespace nearfield;
using work_cell::Q;
using straightforward::Tick;

constexpr uint32_t kTicks = 1000;
constexpr uint32_t kMillisecondsApart = 24;

// Not in line: the count is that of a call.
[[gnu::noipa]] void tick_of_images(const board::Player::Monitor& monitor, const Q* arm, const Q* person, ArmTick<Q>& out) {
  out = monitor.tick(arm, person);
}

struct Cost {
  uint32_t worst = 0;
  uint64_t sum = 0;
  // Of a call.
  template <class Call> void count(Call&& call) {
    board::start_instruction_count();
    call();
    const uint32_t instructions = board::stop_instruction_count();
    if (instructions > worst) worst = instructions;
    sum += instructions;
  }
  void write_row(const char* name) const {
    board::write_padded(name, 36);
    board::write_right_aligned(worst, 9);
    board::write_right_aligned(static_cast<uint32_t>(sum / kTicks), 9);
    board::write("\n");
  }
};

float as_float(Q x) { return in_float::number(x); }
float as_float(float x) { return x; }

// How far Nearfield's ticks are from straightforward ones at the most: clearances (metres) and speed, which may be less but not
// more; intensity and vectors away from the same bodies.
struct Differences {
  float clearance_above = 0, clearance_below = 0, speed_above = 0, speed_below = 0, intensity = 0, direction = 0;

  static void note(float& above, float& below, float difference) {
    if (difference > above) above = difference;
    if (-difference > below) below = -difference;
  }
  template <class S> void of_vectors(const Vector3<S>& v, const straightforward::Point& w) {
    note(direction, direction, as_float(v.x) - w.x);
    note(direction, direction, as_float(v.y) - w.y);
    note(direction, direction, as_float(v.z) - w.z);
  }
  template <class S> void of_nearest(const NearestBodies<S>& a, const straightforward::Nearest& b) {
    note(clearance_above, clearance_below, as_float(a.clearance.distance) - b.distance);
    if (a.body == b.body && (a.other == kNoBody || a.other == b.other)) of_vectors(a.clearance.direction, b.away);
  }
  template <class S> void of_tick(const ArmTick<S>& a, const Tick& b) {
    of_nearest(a.cell, b.cell);
    of_nearest(a.person, b.person);
    of_nearest(a.itself, b.itself);
    note(speed_above, speed_below, as_float(a.speed_override) - b.speed);
    note(intensity, intensity, as_float(a.intensity) - b.intensity);
    of_vectors(a.repulsion, b.repulsion);
  }

  // Whether they are near; `below`: how much less a clearance may be (metres), `slower` a speed.
  bool near(float below, float slower) const {
    return clearance_above < 1e-5f && clearance_below < below && speed_above < 2e-4f && speed_below < slower &&
           intensity < 2e-5f && direction < 1e-3f;
  }
  void write(const char* name) const {
    const auto millionths = [](const char* text, float x) {
      board::write(text);
      board::write_decimal(static_cast<uint64_t>(x * 1e6f + 0.5f));
    };
    board::write(name);
    millionths(" clearances above ", clearance_above);
    millionths(", below ", clearance_below);
    millionths("; speed ", speed_above);
    millionths(", ", speed_below);
    millionths("; intensity ", intensity);
    millionths("; directions ", direction);
    board::write("\n");
  }
};

// Of what bounds anything, the bits.
bool same(const NearestBodies<Q>& a, const NearestBodies<Q>& b) {
  return a.clearance.distance == b.clearance.distance && a.clearance.status == b.clearance.status && a.body == b.body &&
         a.other == b.other;
}
bool same(const ArmTick<Q>& a, const ArmTick<Q>& b) {
  return same(a.cell, b.cell) && same(a.person, b.person) && same(a.itself, b.itself) && a.zone == b.zone &&
         a.speed_override == b.speed_override;
}

}  // namespace

int main() {
  if (!board::prepare_instruction_counter()) return 1;
  const work_cell::WorkCell& data = work_cell::kWorkCell;
  const board::Player& player = board::start_player();
  if (player.status() != work_cell::PlayerStatus::ok) return 1;
  const uint64_t cycle = uint64_t{data.arm.track.times.data[data.arm.track.times.count - 1]} << 27;
  uint64_t cycle_time = 0;
  Cost of_images, of_composed, of_float, of_straightforward;
  Differences fixed_apart, float_apart;
  bool good = true;
  for (uint32_t i = 0; i < kTicks; ++i) {
    Q arm[work_cell::kMostVariables], person[work_cell::kMostVariables];
    float arm_in_float[work_cell::kArmLinks], person_in_float[work_cell::kPersonLinks];
    work_cell::sample_track(data.arm.track, cycle_time, arm);
    work_cell::sample_track(data.person.track, uint64_t{i} * kMillisecondsApart * 1000 << 27, person);
    for (uint32_t k = 0; k < data.arm.track.variables; ++k) arm_in_float[k] = in_float::number(arm[k]);
    for (uint32_t k = 0; k < data.person.track.variables; ++k) person_in_float[k] = in_float::number(person[k]);
    ArmTick<Q> decided, again;
    ArmTick<float> decided_in_float;
    Tick direct;
    of_images.count([&] { tick_of_images(player.monitor(), arm, person, decided); });
    of_composed.count([&] { composed::tick(arm, person, again); });
    of_float.count([&] { composed::tick(arm_in_float, person_in_float, decided_in_float); });
    of_straightforward.count([&] { direct = straightforward::tick(in_float::kCell, arm_in_float, person_in_float); });
    fixed_apart.of_tick(decided, direct);
    float_apart.of_tick(decided_in_float, direct);
    good = good && same(decided, again);
    cycle_time += static_cast<uint64_t>(decided.speed_override.raw()) * kMillisecondsApart * 1000;
    if (cycle_time >= cycle) cycle_time -= cycle;
  }
  if (!good) board::write("what is composed in the source does not give the bits of images\n");
  board::write("instructions of an arm's tick on " NEARFIELD_CORE ": worst, mean\n");
  of_images.write_row("arm tick");
  of_composed.write_row("arm tick, composed in the source");
  of_straightforward.write_row("float: arm tick");
  of_float.write_row("Nearfield in float: arm tick");
  board::write("beside straightforward float, um and millionths, at the most\n");
  fixed_apart.write("Fixed<27>:");
  float_apart.write("float:    ");
  if (!fixed_apart.near(1e-5f, 2e-4f) || !float_apart.near(2e-3f, 0.1f)) {
    board::write("they do not tell the same\n");
    good = false;
  }
  return good ? 0 : 1;
}
