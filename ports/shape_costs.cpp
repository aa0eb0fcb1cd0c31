// What shapes cost on this core as static fields, next to what a user would write instead in float: the worst instruction
// counts over some hundred points, in line in a loop. Fails if the counter is not exact or a shape is not near its direct
// formula.
#include <nearfield/curve/potential.hpp>
#include <nearfield/curve/tabulated_form.hpp>
#include <nearfield/field/compose.hpp>
#include <nearfield/query/chain.hpp>

#include <board/console.hpp>
#include <board/cost_rows.hpp>

#include <float_shapes.hpp>

namespace {

using namespace nearfield;
using board::Several;
using Q = Fixed<27>;

constexpr uint32_t kPoints = 240;
// Within 2 m, in units of 2^-27 m; every tenth on an axis.
int32_t coordinate(uint32_t seed) { return static_cast<int32_t>(seed * 2654435761u) >> 3; }
Several<int32_t, 3> fixed_point(uint32_t i) {
  return {{coordinate(3 * i + 1), i % 10 == 0 ? 0 : coordinate(3 * i + 2), i % 10 == 0 ? 0 : coordinate(3 * i + 3)}};
}
float to_metres(int32_t raw) { return static_cast<float>(raw) * (1.0f / 134217728.0f); }
Several<float, 3> float_point(uint32_t i) {
  const Several<int32_t, 3> p = fixed_point(i);
  return {{to_metres(p.word[0]), to_metres(p.word[1]), to_metres(p.word[2])}};
}
// The same, at least 1.2 m away from the origin along x: outside of the box below.
Several<int32_t, 3> fixed_outside(uint32_t i) {
  Several<int32_t, 3> p = fixed_point(i);
  p.word[0] = p.word[0] / 4 + (p.word[0] < 0 ? -161061274 : 161061274);
  return p;
}
Several<float, 3> float_outside(uint32_t i) {
  const Several<int32_t, 3> p = fixed_outside(i);
  return {{to_metres(p.word[0]), to_metres(p.word[1]), to_metres(p.word[2])}};
}
Vector3<Q> at(const Several<int32_t, 3>& in) {
  return {Q::from_raw(in.word[0]), Q::from_raw(in.word[1]), Q::from_raw(in.word[2])};
}
straightforward::Point at(const Several<float, 3>& in) { return {in.word[0], in.word[1], in.word[2]}; }

constexpr auto kPotential = bake<Q, 2>(over_square(potential::wyvill));
constexpr Sphere<Q> kBall = {{}, 0.3};
constexpr auto kFloatPotential = bake<float, 1>(over_square(potential::wyvill));
constexpr SoftPoint<float> kFloatSoftBall = {{}, Influence<float>(2.0f, 1.0f)};
constexpr SoftPoint<Q> kSoftBall = {{}, Influence<Q>(Q(2.0), Q(1.0))};
constexpr Capsule<Q> kCapsule(Vector3<Q>{-0.3, 0.1, 0.0}, Vector3<Q>{0.4, 0.2, 0.3}, Q(0.1));
constexpr Box<Q> kBox = {{}, {0.3, 0.2, 0.4}};
constexpr Pose<Q> pose() {
  Pose<Q> pose;
  pose.rotation = rotation_about<Q>({0.6, 0.0, 0.8}, Q(0.7));
  pose.translation = {0.1, 0.0, 0.2};
  return pose;
}
constexpr Pose<Q> kPose = pose();

template <class Out> Out placed_box(const Vector3<Q>& p) {
  Out out = kBox.evaluate<Out>(to_inner(kPose, p));
  if constexpr (Out::has_gradient) out.gradient = rotate(kPose.rotation, out.gradient);
  return out;
}

template <class Shape> board::Cost fixed_cost(Shape shape, Several<int32_t, 3> (*points)(uint32_t) = fixed_point) {
  return {board::worst_instruction_count(
              [shape](const Several<int32_t, 3>& in) {
                return shape(Value<Q>{}, at(in)).value.raw();
              },
              points, kPoints),
          board::worst_instruction_count(
              [shape](const Several<int32_t, 3>& in) {
                const Sample<Q> s = shape(Sample<Q>{}, at(in));
                return Several<int32_t, 4>{{s.value.raw(), s.gradient.x.raw(), s.gradient.y.raw(), s.gradient.z.raw()}};
              },
              points, kPoints)};
}
// 64 capsules that a wrist could be surrounded by; the nearest one's number and distance.
struct Capsules {
  Capsule<Q> all[64];
};
constexpr Capsules capsules() {
  Capsules made;
  for (int i = 0; i < 64; ++i) {
    const auto tenth = [](int k) { return Q::from_raw(k * 13421773); };
    made.all[i] = Capsule<Q>(Vector3<Q>{tenth(i % 4 - 2), tenth(i / 4 % 4 - 2), tenth(i / 16 - 2)},
                             Vector3<Q>{tenth(i % 3), tenth(i % 5), tenth(i % 7)}, Q(0.05));
  }
  return made;
}
constexpr Capsules kCapsules = capsules();
struct Segments {
  straightforward::Segment all[64];
};
constexpr straightforward::Segment segment_of(const Capsule<Q>& capsule) {
  const auto metres = [](auto x) { return static_cast<float>(x.raw()) * (1.0f / 134217728.0f); };
  const float unit = 1.0f / 1073741824.0f;
  return {{metres(capsule.from.x), metres(capsule.from.y), metres(capsule.from.z)},
          {static_cast<float>(capsule.axis.x.raw()) * unit, static_cast<float>(capsule.axis.y.raw()) * unit,
           static_cast<float>(capsule.axis.z.raw()) * unit},
          metres(capsule.length), metres(capsule.radius)};
}
struct FloatCapsules {
  Capsule<float> all[64];
};
constexpr FloatCapsules kFloatCapsules = [] {
  FloatCapsules made;
  for (int i = 0; i < 64; ++i) {
    const straightforward::Segment s = segment_of(kCapsules.all[i]);
    made.all[i] = {{s.from.x, s.from.y, s.from.z}, {s.axis.x, s.axis.y, s.axis.z}, s.length, s.radius};
  }
  return made;
}();
constexpr Segments kSegments = [] {
  Segments made{};
  for (int i = 0; i < 64; ++i) made.all[i] = segment_of(kCapsules.all[i]);
  return made;
}();

bool failed = false;

void row(const char* name, board::Cost cost) { failed = !board::write_row(name, cost) || failed; }
void value_row(const char* name, uint32_t count) {
  board::write_padded(name, 40);
  board::write_right_aligned(count, 7);
  board::write("\n");
  failed = failed || count == 0;
}

constexpr straightforward::Segment kSegment = segment_of(kCapsule);

constexpr straightforward::Frame kFrame = [] {
  straightforward::Frame frame{};
  const auto& row = kPose.rotation.row;
  constexpr float unit = 1.0f / 1073741824.0f;
  const Unit<Q> terms[9] = {row[0].x, row[0].y, row[0].z, row[1].x, row[1].y, row[1].z, row[2].x, row[2].y, row[2].z};
  for (int i = 0; i < 9; ++i) frame.m[i] = static_cast<float>(terms[i].raw()) * unit;
  frame.t = {0.1f, 0.0f, 0.2f};
  return frame;
}();

float squared_distance_in_float(const straightforward::Point& p) {
  return straightforward::squared_to_segment(kSegment, p);
}
float to_box_in_float(const straightforward::Point& p) {
  return straightforward::outside_box(kFrame, {0.3f, 0.2f, 0.4f}, p);
}
float metres_of(Q x) { return to_metres(x.raw()); }

void check(const char* name, bool holds) {
  if (holds || failed) return;
  board::write(name);
  board::write(": not near the direct formula\n");
  failed = true;
}
bool near(float a, float b, float tolerance) { return a - b < tolerance && b - a < tolerance; }

}  // namespace

int main() {
  if (!board::prepare_instruction_counter()) return 1;
  using straightforward::FieldValue;
  board::write("worst instructions of shapes on " NEARFIELD_CORE ": value, value and gradient\n");
  const auto in_field = [](const auto& shape) {
    return [&shape](auto out, const Vector3<Q>& p) { return shape.template evaluate<decltype(out)>(p); };
  };
  row("ball potential", fixed_cost([](auto out, const Vector3<Q>& p) {
        return kSoftBall.evaluate<decltype(out)>(p, kPotential.view());
      }));
  row("float: ball potential",
      {board::worst_instruction_count(
           [](const Several<float, 3>& in) { return straightforward::ball_potential<false>(at(in), 0.25f).value; },
           float_point, kPoints),
       board::worst_instruction_count(
           [](const Several<float, 3>& in) {
             const FieldValue f = straightforward::ball_potential<true>(at(in), 0.25f);
             return Several<float, 4>{{f.value, f.gradient.x, f.gradient.y, f.gradient.z}};
           },
           float_point, kPoints)});
  row("Nearfield in float: ball potential",
      {board::worst_instruction_count(
           [](const Several<float, 3>& in) {
             return kFloatSoftBall.evaluate<Value<float>>({in.word[0], in.word[1], in.word[2]}, kFloatPotential.view()).value;
           },
           float_point, kPoints),
       board::worst_instruction_count(
           [](const Several<float, 3>& in) {
             const Sample<float> s =
                 kFloatSoftBall.evaluate<Sample<float>>({in.word[0], in.word[1], in.word[2]}, kFloatPotential.view());
             return Several<float, 4>{{s.value, s.gradient.x, s.gradient.y, s.gradient.z}};
           },
           float_point, kPoints)});
  row("ball distance", fixed_cost(in_field(kBall)));
  row("capsule distance", fixed_cost(in_field(kCapsule)));
  row("rotated box, outside", fixed_cost([](auto out, const Vector3<Q>& p) { return placed_box<decltype(out)>(p); },
                                         fixed_outside));
  value_row("float: rotated box, outside",
            board::worst_instruction_count([](const Several<float, 3>& in) { return to_box_in_float(at(in)); },
                                           float_outside, kPoints));
  value_row("capsule, squared distance",
            board::worst_instruction_count(
                [](const Several<int32_t, 3>& in) {
                  const Vector3<Q> offset = kCapsule.offset_to(at(in));
                  return static_cast<int32_t>(sum_of_squares(offset.x, offset.y, offset.z) >> 32);
                },
                fixed_point, kPoints));
  value_row("float: capsule, squared distance",
            board::worst_instruction_count(
                [](const Several<float, 3>& in) { return squared_distance_in_float(at(in)); }, float_point, kPoints));
  value_row("square root",
            board::worst_instruction_count(
                [](const Several<int32_t, 3>& in) {
                  const uint64_t x = static_cast<uint64_t>(static_cast<uint32_t>(in.word[0])) << 32 |
                                     static_cast<uint32_t>(in.word[1]);
                  return static_cast<int32_t>(integer_sqrt(x >> (in.word[2] & 31)));
                },
                fixed_point, kPoints));
  value_row("float: square root",
            board::worst_instruction_count(
                [](const Several<float, 3>& in) { return straightforward::root(in.word[0] * in.word[0]); }, float_point,
                kPoints));
  value_row("length of an offset",
            board::worst_instruction_count(
                [](const Several<int32_t, 3>& in) {
                  const Vector3<Q> v = at(in);
                  return length_of<Q>(sum_of_squares(v.x, v.y, v.z)).raw();
                },
                fixed_point, kPoints));
  value_row("point into a frame",
            board::worst_instruction_count(
                [](const Several<int32_t, 3>& in) {
                  const Vector3<Q> p = to_inner(kPose, at(in));
                  return Several<int32_t, 3>{{p.x.raw(), p.y.raw(), p.z.raw()}};
                },
                fixed_point, kPoints));
  value_row("nearest of 64 capsules",
            board::worst_instruction_count(
                [](const Several<int32_t, 3>& in) {
                  const Vector3<Q> p = at(in);
                  Q least = ScalarTraits<Q>::greatest();
                  for (const Capsule<Q>& each : kCapsules.all) {
                    least = least_of_two(least, each.evaluate<Value<Q>>(p).value);
                  }
                  return least.raw();
                },
                fixed_point, 40));
  value_row("float: nearest of 64 capsules",
            board::worst_instruction_count(
                [](const Several<float, 3>& in) {
                  const straightforward::Point p = at(in);
                  float least = 1e9f;
                  for (const straightforward::Segment& each : kSegments.all) {
                    const float distance = straightforward::root(straightforward::squared_to_segment(each, p)) - each.radius;
                    least = distance < least ? distance : least;
                  }
                  return least;
                },
                float_point, 40));
  value_row("Nearfield in float: nearest of 64 capsules",
            board::worst_instruction_count(
                [](const Several<float, 3>& in) {
                  float least = ScalarTraits<float>::greatest();
                  for (const Capsule<float>& each : kFloatCapsules.all) {
                    least = least_of_two(least, each.evaluate<Value<float>>({in.word[0], in.word[1], in.word[2]}).value);
                  }
                  return least;
                },
                float_point, 40));

  for (uint32_t i = 0; i < kPoints; ++i) {
    const Vector3<Q> p = at(fixed_point(i)), outside = at(fixed_outside(i));
    const straightforward::Point exact = at(float_point(i)), exact_outside = at(float_outside(i));
    const Value<Q> soft = kSoftBall.evaluate<Value<Q>>(p, kPotential.view());
    check("ball potential", near(metres_of(soft.value), straightforward::ball_potential<false>(exact, 0.25f).value, 1e-4f));
    const float distance = metres_of(kCapsule.evaluate<Value<Q>>(p).value) + 0.1f;
    check("capsule", near(distance * distance, squared_distance_in_float(exact), 1e-5f));
    check("rotated box", near(metres_of(placed_box<Value<Q>>(outside).value), to_box_in_float(exact_outside), 1e-5f));
  }
  return failed ? 1 : 0;
}
