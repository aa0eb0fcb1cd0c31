#include <nearfield/nearfield.h>

#include <nearfield/nearfield.hpp>

namespace {

using Q = nearfield::Fixed<27>;
using FieldProgram = nearfield::Program<Q>;

// A program and what fills up the C struct; bits_as() checks that sizes agree.
struct State {
  FieldProgram program;
  uint32_t loaded;
  uint32_t unused[(sizeof(nearfield_field) - sizeof(FieldProgram)) / 4 - 1];
};

FieldProgram program_of(const nearfield_field* field) {
  if (field == nullptr) return {};
  const State state = nearfield::bits_as<State>(*field);
  return state.loaded == 1 ? state.program : FieldProgram{};
}

}  // namespace

extern "C" {

int nearfield_load(nearfield_field* field, const void* image, size_t byte_count) {
  if (field == nullptr) return static_cast<int>(nearfield::LoadStatus::no_image);
  const FieldProgram program = nearfield::load<Q>(image, byte_count);
  *field = nearfield::bits_as<nearfield_field>(State{program, program.valid() ? 1u : 0u, {}});
  return static_cast<int>(program.status());
}

uint32_t nearfield_budget(const nearfield_field* field) {
  const FieldProgram program = program_of(field);
  if (!program.valid()) return 0;
  // Copies of the field and of the poses come on top.
  using nearfield::QueryPart;
  const nearfield::Budget copies = nearfield::cost(nearfield::kThisTarget, QueryPart::c_interface) +
                                   program.slot_count() * nearfield::cost(nearfield::kThisTarget, QueryPart::c_pose);
  return (program.budget() + copies).gradient;
}

nearfield_clearance nearfield_clearance_at(const nearfield_field* field, const int32_t point[3],
                                           const nearfield_pose* slots, uint32_t slot_count) {
  nearfield::Pose<Q> poses[NEARFIELD_SLOT_LIMIT];
  constexpr uint32_t most = NEARFIELD_SLOT_LIMIT;
  const uint32_t count = slots == nullptr ? 0 : slot_count < most ? slot_count : most;
  for (uint32_t i = 0; i < count; ++i) poses[i] = nearfield::bits_as<nearfield::Pose<Q>>(slots[i]);
  if (point == nullptr) return {NEARFIELD_INVALID, nearfield::least_of<int32_t>, {0, 0, 0}};
  const nearfield::Vector3<Q> p = {Q::from_raw(point[0]), Q::from_raw(point[1]), Q::from_raw(point[2])};
  const nearfield::Clearance<Q> c = nearfield::clearance(program_of(field), p, poses, count);
  return {static_cast<int32_t>(c.status), c.distance.raw(), {c.direction.x.raw(), c.direction.y.raw(), c.direction.z.raw()}};
}

}  // extern "C"
