#include <tick_costs/straightforward.hpp>

#include <float_blends.hpp>

namespace nearfield::straightforward {
namespace {

// Solids of the cell along the axes of the room, metres, as in host_sim/scenes/work_cell.json.
struct Block {
  Point center, half;
};
struct Post {
  Point center;
  float radius, half_height;
};
constexpr Block kBlocks[] = {{{0.1f, 0.0f, -0.025f}, {0.6f, 0.8f, 0.025f}},
                                    {{0.5f, -0.36f, 0.025f}, {0.12f, 0.15f, 0.025f}},
                                    {{0.5f, 0.36f, 0.05f}, {0.12f, 0.1f, 0.05f}}};
constexpr Post kPosts[] = {{{0.57f, 0.38f, 0.15f}, 0.02f, 0.05f}, {{0.8f, -0.1f, 0.0f}, 0.06f, 0.75f}};
constexpr float kBlendRadius = 0.05f, kRisingRange = 0.0125f;
constexpr float kInverseSteepest = 1.0f / 1.03917f;  // blended distances rise by no more a metre

// What spreads an intensity, each about a segment or a point (of length 0), in the room or a link of the person.
struct Spreading {
  int link;  // -1: the room
  Point from, axis;
  float length, influence_radius, weight;
};
constexpr Spreading kSpreading[] = {
    {-1, {0.65f, -0.7f, 0.0f}, {0.0f, 1.0f, 0.0f}, 1.4f, 0.4f, 0.4f},
    {-1, {0.5f, -0.36f, 0.025f}, {0.0f, 0.0f, 0.0f}, 0.0f, 0.4f, 0.6f},
    {-1, {0.5f, 0.36f, 0.05f}, {0.41997903f, 0.11999401f, 0.89995507f}, 0.16667333f, 0.5f, 0.8f},
    {-1, {0.8f, -0.1f, -0.75f}, {0.0f, 0.0f, 1.0f}, 1.5f, 0.5f, 1.0f},
    {4, {0.0f, 0.0f, 0.1f}, {0.0f, 0.0f, 1.0f}, 0.32f, 0.9f, 1.0f},
    {5, {0.0f, 0.0f, 0.0f}, {0.0f, 0.0f, 0.0f}, 0.0f, 0.7f, 1.0f},
    {7, {0.0f, 0.0f, 0.0f}, {0.0f, 0.0f, -1.0f}, 0.3f, 0.6f, 1.0f},
    {8, {0.0f, 0.0f, 0.0f}, {0.0f, 0.0f, -1.0f}, 0.4f, 0.6f, 1.0f},
};

float sign_of(float x) { return x < 0.0f ? -1.0f : 1.0f; }
float magnitude(float x) { return x < 0.0f ? -x : x; }

template <bool with_gradient> Distance to_block(const Block& block, const Point& p) {
  const Point q = difference(p, block.center);
  const float x = magnitude(q.x) - block.half.x, y = magnitude(q.y) - block.half.y, z = magnitude(q.z) - block.half.z;
  if (x <= 0.0f && y <= 0.0f && z <= 0.0f) {
    if (x >= y && x >= z) return {x, sign_of(q.x), 0.0f, 0.0f};
    if (y >= z) return {y, 0.0f, sign_of(q.y), 0.0f};
    return {z, 0.0f, 0.0f, sign_of(q.z)};
  }
  const Point beyond = {x > 0.0f ? x : 0.0f, y > 0.0f ? y : 0.0f, z > 0.0f ? z : 0.0f};
  const float distance = root(squared(beyond));
  if constexpr (!with_gradient) return {distance, 0.0f, 0.0f, 0.0f};
  const float inverse = 1.0f / distance;
  return {distance, sign_of(q.x) * beyond.x * inverse, sign_of(q.y) * beyond.y * inverse, sign_of(q.z) * beyond.z * inverse};
}

template <bool with_gradient> Distance to_post(const Post& post, const Point& p) {
  const Point q = difference(p, post.center);
  const float away = root(q.x * q.x + q.y * q.y), wall = away - post.radius, cap = magnitude(q.z) - post.half_height;
  const float inverse = with_gradient && away > 0.0f ? 1.0f / away : 0.0f;
  if (wall <= 0.0f || cap <= 0.0f) {
    if (wall >= cap) return {wall, q.x * inverse, q.y * inverse, 0.0f};
    return {cap, 0.0f, 0.0f, sign_of(q.z)};
  }
  const float distance = root(wall * wall + cap * cap);
  if constexpr (!with_gradient) return {distance, 0.0f, 0.0f, 0.0f};
  const float outwards = wall / distance;
  return {distance, q.x * inverse * outwards, q.y * inverse * outwards, sign_of(q.z) * cap / distance};
}

template <bool with_gradient> Distance blended(const Distance& a, const Distance& b) {
  const float apart = a.value - b.value;
  if (apart >= kBlendRadius + kRisingRange) return b;
  if (apart <= -(kBlendRadius + kRisingRange)) return a;
  return exterior_union<with_gradient>(a, b, kBlendRadius, kRisingRange);
}

template <bool with_gradient> Distance to_cell(const Point& p) {
  Distance nearest = to_block<with_gradient>(kBlocks[0], p);
  for (int i = 1; i < 3; ++i) nearest = blended<with_gradient>(nearest, to_block<with_gradient>(kBlocks[i], p));
  for (const Post& post : kPosts) nearest = blended<with_gradient>(nearest, to_post<with_gradient>(post, p));
  return nearest;
}

// The search for the stretch of a body where it may be nearest to the cell.
class CellSearch {
 public:
  explicit CellSearch(const Segment* bodies) : bodies_(bodies) {}

  void start(int body) {
    const float middle = 0.5f * bodies_[body].length, free_radius = free_at(body, middle);
    add({middle, middle, free_radius, free_radius, free_radius - middle - bodies_[body].radius, body});
  }
  void refine(int left, float tolerance) {
    while (left > 0 && least_attained_ - stretches_[weakest_].bound > tolerance) {
      const Stretch weak = stretches_[weakest_];
      const float length = bodies_[weak.body].length;
      const bool whole = weak.from == weak.to;
      if (whole && left < 2) break;
      left -= whole ? 2 : 1;
      const float low = whole ? 0.0f : weak.from, high = whole ? length : weak.to;
      const float middle = whole ? weak.from : 0.5f * (low + high);
      const float free_low = whole ? free_at(weak.body, low) : weak.free_from;
      const float free_high = whole ? free_at(weak.body, high) : weak.free_to;
      const float free_middle = whole ? weak.free_from : free_at(weak.body, middle);
      stretches_[weakest_] = between(weak.body, low, free_low, middle, free_middle);
      add(between(weak.body, middle, free_middle, high, free_high));
      for (int i = 0; i < count_; ++i) {
        if (stretches_[i].bound < stretches_[weakest_].bound) weakest_ = i;
      }
    }
  }
  float bound() const { return stretches_[weakest_].bound; }
  int nearest_body() const { return nearest_body_; }
  Point nearest_place() const { return place(nearest_body_, nearest_along_); }

 private:
  struct Stretch {
    float from, to, free_from, free_to, bound;
    int body;
  };

  Point place(int body, float along) const { return sum(bodies_[body].from, times(along, bodies_[body].axis)); }
  // The radius of a ball that nothing of the cell is in.
  float free_at(int body, float along) {
    const float value = to_cell<false>(place(body, along)).value, free_radius = value > 0.0f ? value * kInverseSteepest : value;
    const float attained = free_radius - bodies_[body].radius;
    if (attained < least_attained_) {
      least_attained_ = attained;
      nearest_body_ = body;
      nearest_along_ = along;
    }
    return free_radius;
  }
  // What two such balls leave between their centres: where they meet, or by the rate at which distance can change.
  Stretch between(int body, float from, float free_from, float to, float free_to) const {
    const float low = least(free_from, free_to), high = free_from + free_to - low, half = 0.5f * (to - from);
    float bound = 0.5f * (low + high) - half;
    if (low > half) {
      const float ring = root(low * low - half * half);
      if (bound < ring) bound = ring;
    }
    return {from, to, free_from, free_to, least(bound, low) - bodies_[body].radius, body};
  }
  void add(const Stretch& stretch) {
    stretches_[count_] = stretch;
    if (stretch.bound < stretches_[weakest_].bound) weakest_ = count_;
    ++count_;
  }

  const Segment* bodies_;
  Stretch stretches_[most_bodies + most_refinements];
  int count_ = 0, weakest_ = 0, nearest_body_ = 0;
  float least_attained_ = 1e30f, nearest_along_ = 0.0f;
};

// Intensity and gradient of all that spreads.
FieldValue presence(const Point& p, const Frame* person_poses) {
  FieldValue all = {0.0f, {0.0f, 0.0f, 0.0f}};
  for (const Spreading& each : kSpreading) {
    const Point inner = each.link < 0 ? p : to_inner(person_poses[each.link], p);
    const Point r = difference(inner, each.from);
    const Point offset = difference(r, times(clamped(dot(r, each.axis), 0.0f, each.length), each.axis));
    const float inverse_square = 1.0f / (each.influence_radius * each.influence_radius), u = squared(offset) * inverse_square;
    if (u >= 1.0f) continue;
    const Jet falling = wyvill<true>(u);
    const Point gradient = times(2.0f * each.weight * inverse_square * falling.slope, offset);
    all.value += each.weight * falling.value;
    all.gradient = sum(all.gradient, each.link < 0 ? gradient : turned_out(person_poses[each.link], gradient));
  }
  return all;
}

float speed_at(const Ramp& ramp, float clearance) {
  return polynomial_step<false>((clearance - ramp.stop) / (ramp.free - ramp.stop)).value;
}

}  // namespace

Tick tick(const Cell& data, const float* arm_joints, const float* person_joints) {
  Frame arm_poses[8], person_poses[9];
  Segment bodies[most_bodies];
  link_poses(data.arm.hinges, data.arm.hinge_count, arm_joints, arm_poses);
  link_poses(data.person.hinges, data.person.hinge_count, person_joints, person_poses);
  for (int i = 0; i < data.arm.limb_count; ++i) bodies[i] = placed(data.arm.limbs[i], arm_poses);

  Tick out;
  CellSearch search(bodies);
  for (int i = 0; i < data.arm.limb_count; ++i) {
    if (data.checked[i] != 0) search.start(i);
  }
  search.refine(data.refinements, data.tolerance);
  const Distance nearest = to_cell<true>(search.nearest_place());
  out.cell = {search.bound(), {nearest.x, nearest.y, nearest.z}, search.nearest_body(), 0};

  Pair to_person, to_itself;
  for (int j = 0; j < data.person.limb_count; ++j) {
    const Segment limb = placed(data.person.limbs[j], person_poses);
    for (int i = 0; i < data.arm.limb_count; ++i) {
      to_person.consider(bodies[i], limb, static_cast<uint16_t>(i), static_cast<uint16_t>(j));
    }
  }
  for (int k = 0; k < data.self_pair_count; ++k) {
    const LimbPair& pair = data.self_pairs[k];
    to_itself.consider(bodies[pair.first], bodies[pair.second], pair.first, pair.second);
  }
  out.person = {to_person.distance, direction(to_person.gap), to_person.first, to_person.second};
  out.itself = {to_itself.distance, direction(to_itself.gap), to_itself.first, to_itself.second};

  out.speed = 0.0f;
  if (out.itself.distance > 0.0f) {
    out.speed = least(speed_at(data.of_person, out.person.distance), speed_at(data.of_cell, out.cell.distance));
  }
  const FieldValue soft = presence(arm_poses[data.tool_link].t, person_poses);
  out.intensity = soft.value;
  out.repulsion = times(-1.0f, direction(soft.gradient));
  return out;
}

}  // namespace nearfield::straightforward
