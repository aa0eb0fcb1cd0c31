// Plays a work cell tick by tick: the arm repeats its cycle at the speed that the monitor allows, the person follows
// a path. The same code, and so the same decisions to the bit, on the host and on a target.
#pragma once

#include "work_cell/digest.hpp"
#include "work_cell/work_cell.hpp"

namespace nearfield::work_cell {

inline constexpr uint32_t kTickMicroseconds = 1000;
inline constexpr int kMostVariables = 64;

// Values of a track at a time in units of 2^-27 microseconds; held before the first and after the last time.
inline void sample_track(const Track& track, uint64_t time, Q* values) {
  uint32_t next = 0;
  while (next < track.times.count && time >= (static_cast<uint64_t>(track.times.data[next]) << 27)) ++next;
  const uint32_t after = next == track.times.count ? next - 1 : next;
  const uint32_t before = next == 0 ? 0 : next - 1;
  const Q* a = track.values.data + before * track.variables;
  const Q* b = track.values.data + after * track.variables;
  Q smooth{};
  if (before != after) {
    const uint32_t start = track.times.data[before], duration = track.times.data[after] - start;
    const uint64_t elapsed = time - (static_cast<uint64_t>(start) << 27);
    const Q u = Q::from_raw(static_cast<int32_t>(elapsed / duration));  // below 1
    const Q one = ScalarTraits<Q>::one();
    smooth = u * u * (one + ((one - u) + (one - u)));  // 3 u^2 - 2 u^3
  }
  for (uint32_t i = 0; i < track.variables; ++i) values[i] = a[i] + (b[i] - a[i]) * smooth;
}

enum class PlayerStatus : uint8_t { ok, bad_arm, bad_person, bad_cell_image, bad_soft_image, bad_scenario };

// Operations: those of the work cell's fields (OnlyOperations<...>), so that a target links no others.
template <int ArmLinks, int ArmBodies, int PersonLinks, int PersonBodies, class Operations = AllOperations> class Player {
 public:
  using ArmChain = Chain<Q, ArmLinks, ArmBodies>;
  using PersonChain = Chain<Q, PersonLinks, PersonBodies>;
  using Field = Program<Q, Operations>;
  using Monitor = ArmMonitor<ArmChain, PersonChain, Field, Field>;

  // `data` must outlive the player; the player must stay where it is.
  explicit Player(const WorkCell& data) : data_(data) { status_ = prepare(); }
  Player(const Player&) = delete;
  Player& operator=(const Player&) = delete;

  PlayerStatus status() const { return status_; }
  const Monitor& monitor() const { return monitor_; }
  const ArmChain& arm() const { return arm_; }
  const PersonChain& person() const { return person_; }
  const Field& cell() const { return cell_; }
  const Field& soft() const { return soft_; }
  uint32_t ticks() const { return data_.ticks; }

  // Joint values of the tick to come.
  const Q* arm_joints() const { return arm_joints_; }
  const Q* person_joints() const { return person_joints_; }
  // Place in the cycle, in units of 2^-27 microseconds, and how often it has been completed.
  uint64_t cycle_time() const { return cycle_time_; }
  uint32_t cycles() const { return cycles_; }
  uint64_t digest() const { return digest_.value(); }

  // What the controller does in a tick; then time goes on.
  ArmTick<Q> decide() const { return monitor_.tick(arm_joints_, person_joints_); }
  void advance(const ArmTick<Q>& out) {
    add_to_digest(out);
    const uint64_t cycle = static_cast<uint64_t>(data_.arm.track.times.data[data_.arm.track.times.count - 1]) << 27;
    cycle_time_ += static_cast<uint64_t>(out.speed_override.raw()) * kTickMicroseconds;
    if (cycle_time_ >= cycle) {
      cycle_time_ -= cycle;
      ++cycles_;
    }
    ++tick_;
    sample();
  }

 private:
  template <class AnyChain> static bool build(const RobotData& robot, AnyChain& chain) {
    for (uint32_t i = 0; i < robot.joints.count; ++i) chain.add_joint(robot.joints.data[i]);
    for (uint32_t i = 0; i < robot.bodies.count; ++i) chain.add_body(robot.bodies.data[i]);
    const Track& track = robot.track;
    return chain.valid() && chain.variable_count() <= track.variables && track.variables <= kMostVariables &&
           track.times.count >= 1 && track.values.count == track.times.count * track.variables;
  }

  PlayerStatus prepare() {
    if (!build(data_.arm, arm_) || data_.checked_against_cell.count != arm_.body_count()) return PlayerStatus::bad_arm;
    const bool somebody = data_.person.bodies.count != 0;
    if (somebody && !build(data_.person, person_)) return PlayerStatus::bad_person;
    cell_ = load<Q, Operations>(data_.cell_image.data, data_.cell_image.count * sizeof(uint32_t));
    if (!cell_.valid() || cell_.kind() != Kind::distance) return PlayerStatus::bad_cell_image;
    const bool soft = data_.soft_image.count != 0;
    if (soft) soft_ = load<Q, Operations>(data_.soft_image.data, data_.soft_image.count * sizeof(uint32_t));
    if (soft && (!soft_.valid() || soft_.kind() != Kind::intensity)) return PlayerStatus::bad_soft_image;
    if (data_.arm.track.times.count < 2 || data_.tool_link >= arm_.link_count()) return PlayerStatus::bad_scenario;
    for (uint32_t i = 0; i < data_.self_pairs.count; ++i) {
      const BodyPair& pair = data_.self_pairs.data[i];
      if (pair.first >= arm_.body_count() || pair.second >= arm_.body_count()) return PlayerStatus::bad_scenario;
    }
    monitor_.arm = &arm_;
    monitor_.person = somebody ? &person_ : nullptr;
    monitor_.cell = &cell_;
    monitor_.soft = soft ? &soft_ : nullptr;
    monitor_.checked_against_cell = data_.checked_against_cell.data;
    monitor_.self_pairs = data_.self_pairs.data;
    monitor_.self_pair_count = static_cast<uint16_t>(data_.self_pairs.count);
    monitor_.tool_link = data_.tool_link;
    monitor_.effort = {data_.refinements, data_.tolerance};
    monitor_.person_ramp = SpeedRamp<Q>(data_.person_stop, data_.person_free);
    monitor_.cell_ramp = SpeedRamp<Q>(data_.cell_stop, data_.cell_free);
    sample();
    return PlayerStatus::ok;
  }

  void sample() {
    sample_track(data_.arm.track, cycle_time_, arm_joints_);
    if (data_.person.track.times.count != 0) {
      sample_track(data_.person.track, static_cast<uint64_t>(tick_) * kTickMicroseconds << 27, person_joints_);
    }
  }

  void add_to_digest(const Vector3<Q>& v) {
    digest_.add(ScalarTraits<Q>::word(v.x));
    digest_.add(ScalarTraits<Q>::word(v.y));
    digest_.add(ScalarTraits<Q>::word(v.z));
  }
  void add_to_digest(const NearestBodies<Q>& nearest) {
    digest_.add(static_cast<uint32_t>(nearest.clearance.status));
    digest_.add(ScalarTraits<Q>::word(nearest.clearance.distance));
    add_to_digest(nearest.clearance.direction);
    digest_.add(static_cast<uint32_t>(nearest.body) << 16 | nearest.other);
  }
  void add_to_digest(const ArmTick<Q>& out) {
    digest_.add(static_cast<uint32_t>(out.kinematics) << 8 | static_cast<uint32_t>(out.person_kinematics));
    add_to_digest(out.cell);
    add_to_digest(out.person);
    add_to_digest(out.itself);
    digest_.add(static_cast<uint32_t>(out.zone));
    digest_.add(ScalarTraits<Q>::word(out.speed_override));
    digest_.add(ScalarTraits<Q>::word(out.intensity));
    add_to_digest(out.repulsion);
    digest_.add(static_cast<uint32_t>(cycle_time_));
    digest_.add(static_cast<uint32_t>(cycle_time_ >> 32));
  }

  const WorkCell& data_;
  ArmChain arm_;
  PersonChain person_;
  Field cell_, soft_;
  Monitor monitor_;
  Q arm_joints_[kMostVariables] = {};
  Q person_joints_[kMostVariables] = {};
  uint64_t cycle_time_ = 0;
  uint32_t cycles_ = 0;
  uint32_t tick_ = 0;
  Digest digest_;
  PlayerStatus status_;
};

}  // namespace nearfield::work_cell
