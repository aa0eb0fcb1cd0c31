// A fixed stream of pseudo-random queries, and a digest of every bit of the answers. Freestanding, integers
// only: the same on the host and on a target.
#pragma once

#include <golden/clearance_of_any.hpp>
#include <golden/node_writer.hpp>
#include <golden/stream.hpp>
#include <nearfield/curve/kernel.hpp>
#include <nearfield/curve/potential.hpp>
#include <nearfield/curve/tabulated_form.hpp>
#include <nearfield/modify/sine.hpp>
#include <nearfield/query/clearance.hpp>

#include <stddef.h>
#include <stdint.h>

#include <work_cell/digest.hpp>

namespace nearfield::golden {

using work_cell::Digest;

// count * 2^-22 metres, |count| < 2^24: exact for float and for 22 fraction bits or more, rounded down for
// fewer.
template <class S>
constexpr S from_steps(int32_t count) {
  if constexpr (!ScalarTraits<S>::is_fixed)
    return static_cast<float>(count) * (1.0f / 4194304.0f);
  else if constexpr (S::fraction_bits >= 22)
    return S::from_raw(shift_left(count, S::fraction_bits - 22));
  else
    return S::from_raw(count >> (22 - S::fraction_bits));
}
// Anywhere within the domain of S.
template <class S>
constexpr S anywhere(Stream& stream) {
  if constexpr (ScalarTraits<S>::is_fixed)
    return S::from_raw(stream.integer_of_bits(30));
  else
    return static_cast<float>(stream.integer_of_bits(25)) * (1.0f / 1048576.0f);
}
// What no query may accept.
template <class S>
constexpr S beyond(Stream& stream) {
  const bool negative = (stream.next() & 1u) != 0;
  if constexpr (ScalarTraits<S>::is_fixed) {
    const auto raw = static_cast<int32_t>(0x20000001u + stream.below(0x5fffffffu));
    return S::from_raw(negative ? -raw : raw);
  } else {
    constexpr uint32_t patterns[] = {0x41800001u, 0x7f7fffffu, 0x7f800000u, 0x7fc00000u};
    return bits_as<float>(patterns[stream.below(4)] | (negative ? 0x80000000u : 0u));
  }
}

// Points where things happen: near the shapes, on symmetry planes and domain borders, anywhere, and out of
// range.
template <class S>
Vector3<S> point_from(Stream& stream) {
  const auto near = [&stream] { return from_steps<S>(stream.integer_of_bits(23)); };
  const auto coarse = [&stream] { return from_steps<S>(stream.integer_of_bits(4) * (1 << 19)); };
  const S limit = ScalarTraits<S>::domain();
  Vector3<S> p;
  switch (stream.below(16)) {
    case 0:
      return {anywhere<S>(stream), anywhere<S>(stream), anywhere<S>(stream)};
    case 1:
      return {coarse(), coarse(), coarse()};
    case 2:
      return {near(), S{}, S{}};
    case 3:
      return {coarse(), near(), coarse()};
    case 4:
      p = {near(), limit, -limit};
      return p;
    case 5:
      p = {near(), near(), near()};
      if (stream.below(4) == 0) p.y = beyond<S>(stream);
      return p;
    default:
      return {near(), near(), near()};
  }
}

// A turn about one of the axes and a shift; about one in sixty is no pose at all.
template <class S>
Pose<S> pose_from(Stream& stream) {
  const SineCosine<S> turn = sine_cosine(from_steps<S>(stream.integer_of_bits(24)));
  const Unit<S> one = ScalarTraits<S>::unit_one(), zero{}, s = turn.sine, c = turn.cosine;
  Pose<S> pose;
  switch (stream.below(3)) {
    case 0:
      pose.rotation = {{{one, zero, zero}, {zero, c, -s}, {zero, s, c}}};
      break;
    case 1:
      pose.rotation = {{{c, zero, s}, {zero, one, zero}, {-s, zero, c}}};
      break;
    default:
      pose.rotation = {{{c, -s, zero}, {s, c, zero}, {zero, zero, one}}};
      break;
  }
  pose.translation = {from_steps<S>(stream.integer_of_bits(21)), from_steps<S>(stream.integer_of_bits(21)),
                      from_steps<S>(stream.integer_of_bits(21))};
  switch (stream.below(180)) {
    case 0:
      pose.translation.z = beyond<S>(stream);
      break;
    case 1:
      pose.rotation.row[1] = -pose.rotation.row[1];
      break;
    case 2:
      pose.rotation.row[2].z = zero;
      break;
    default:
      break;
  }
  return pose;
}

// The fields. Constants are converted by the compiler.
template <class S>
struct Scene {
  static constexpr Table<S, 32> kernel = bake<S, 32>(exterior(step::polynomial<3>, 0.25));
  static constexpr Table<S, 64> wide_kernel = bake<S, 64>(exterior(step::polynomial<2>, 1.0));
  static constexpr Table<S, 2> potential = bake<S, 2>(over_square(potential::wyvill));

  static constexpr Unit<S> unit(double real) { return Unit<S>(static_cast<Unit<S>>(real)); }
  static constexpr S metres(double real) { return S(static_cast<S>(real)); }
  static constexpr Vector3<S> at(double x, double y, double z) { return {metres(x), metres(y), metres(z)}; }
  static constexpr Pose<S> pose(double c, double s, const Vector3<S>& translation) {
    return {{{{unit(c), unit(-s), unit(0)}, {unit(s), unit(c), unit(0)}, {unit(0), unit(0), unit(1)}}},
            translation};
  }

  static constexpr Sphere<S> ball{at(0.25, -0.5, 0.125), metres(0.3)};
  static constexpr Capsule<S> arm{at(-0.5, -0.25, 0.0), at(0.5, 0.5, 0.25), metres(0.0625)};
  static constexpr Capsule<S> bare{at(-0.75, 0.5, -0.5), at(-0.75, 0.5, -0.5), metres(0.5)};
  static constexpr Box<S> block{at(-0.25, 0.5, 0.375), at(0.2, 0.1, 0.4)};
  static constexpr Cylinder<S> post{at(0.125, 0.25, -0.5), metres(0.15), metres(0.45)};

  static constexpr auto soft = soft_sum(
      with_potential(SoftPoint<S>{at(0.25, 0.25, 0.0), Influence<S>(metres(0.9), metres(1.0))}, potential),
      with_potential(SoftSegment<S>{Capsule<S>(at(-0.5, 0.0, 0.0), at(0.5, 0.25, 0.5), metres(0.0)),
                                    Influence<S>(metres(0.7), metres(0.75))},
                     potential),
      with_potential(SoftPoint<S>{at(-0.25, -0.25, 0.25), Influence<S>(metres(0.5), metres(-0.5))},
                     potential));

  static constexpr auto smooth = unite(kernel, metres(0.2), ball, arm, block, post);
  static constexpr auto sharp = subtract(intersect(unite(ball, block), post), bare);
  static constexpr auto carved =
      subtract(wide_kernel, metres(0.125), intersect(kernel, metres(0.25), block, ball), post);
  static constexpr auto turned =
      place(pose(0.6, 0.8, at(0.25, 0.125, -0.25)), unite(kernel, metres(0.1), block, post));
  static constexpr auto nested = unite(
      place(pose(0.8, -0.6, at(-0.125, 0.25, 0.5)), in_slot(1, subtract(kernel, metres(0.15), block, ball))),
      arm);
  static constexpr auto moving =
      unite(wide_kernel, metres(0.3), in_slot(0, arm), in_slot(1, unite(post, turned)));
  static constexpr auto soft_placed =
      soft_sum(place(pose(0.28, 0.96, at(0.5, 0.0, 0.25)), soft), in_slot(0, soft));
};

// All that a query can return, for a field in either form.
template <class S, class AnyField>
void add_answer(Digest& digest, const AnyField& field, const Vector3<S>& p, const Pose<S>* slots,
                uint32_t count) {
  using T = ScalarTraits<S>;
  const auto add_vector = [&digest](const Vector3<S>& v) {
    digest.add(T::word(v.x));
    digest.add(T::word(v.y));
    digest.add(T::word(v.z));
  };
  const Clearance<S> answer = clearance_of_any(field, p, slots, count);
  digest.add(static_cast<uint32_t>(answer.status));
  digest.add(T::word(answer.distance));
  add_vector(answer.direction);
  const Slots<S> given(slots, count);
  if (!field.valid() || !coordinates_in_domain(p) || !nearfield::detail::slots_given(field, given) ||
      !nearfield::detail::valid_slots(field, given))
    return;
  digest.add(T::word(field.template evaluate<Value<S>>(p, slots).value));
  const Sample<S> sample = field.template evaluate<Sample<S>>(p, slots);
  digest.add(T::word(sample.value));
  add_vector(sample.gradient);
}

template <class S, class AnyField>
void add_facts(Digest& digest, const AnyField& field) {
  const Certificate<S>& certificate = field.certificate();
  digest.add(field.valid() ? 1 : 0);
  digest.add(field.slot_count());
  digest.add(static_cast<uint32_t>(certificate.lipschitz.raw()));
  digest.add(ScalarTraits<S>::word(certificate.erosion));
  digest.add(ScalarTraits<S>::word(certificate.inflation));
  digest.add(ScalarTraits<S>::word(certificate.error));
}

// The operations of the fields, so that the smallest board has room for the programs of three scalars.
using StreamOperations =
    OnlyOperations<Operation::sphere, Operation::capsule, Operation::box, Operation::cylinder, Operation::soft_point,
                   Operation::soft_segment, Operation::sharp_union, Operation::sharp_intersection,
                   Operation::sharp_subtraction, Operation::soft_sum, Operation::additive_union,
                   Operation::additive_intersection, Operation::additive_subtraction, Operation::enter_scale>;
template <class S>
using StreamProgram = Program<S, StreamOperations>;

template <class S>
using Writer = NodeWriter<S, 640, StreamOperations>;
// The same field as an image.
template <class S, class Node>
StreamProgram<S> program_of(Writer<S>& writer, const Node& node) {
  writer.table(Scene<S>::kernel);
  writer.table(Scene<S>::wide_kernel);
  writer.table(Scene<S>::potential);
  writer.write(node);
  writer.builder().finish();
  return load<S, StreamOperations>(writer.builder().words(), writer.builder().size() * size_t{4});
}

// Digest of the first `queries` queries of the stream in the number type S. No allocation; 12 KiB of stack.
template <class S>
uint64_t query_digest(uint32_t queries) {
  using Fields = Scene<S>;
  Stream stream(0x6e656172u);
  Digest digest;

  const auto smooth = field(Fields::smooth);
  const auto sharp = field(Fields::sharp);
  const auto carved = field(Fields::carved);
  const auto moving = field(Fields::moving);
  const auto soft = field(Fields::soft);
  Writer<S> images[4];
  const StreamProgram<S> nested = program_of(images[0], Fields::nested);
  const StreamProgram<S> carved_program = program_of(images[1], Fields::carved);
  const StreamProgram<S> soft_placed = program_of(images[2], Fields::soft_placed);
  const StreamProgram<S> turned = program_of(images[3], unite(Fields::turned, Fields::sharp));

  add_facts<S>(digest, smooth);
  add_facts<S>(digest, sharp);
  add_facts<S>(digest, carved);
  add_facts<S>(digest, moving);
  add_facts<S>(digest, soft);
  add_facts<S>(digest, nested);
  add_facts<S>(digest, carved_program);
  add_facts<S>(digest, soft_placed);
  add_facts<S>(digest, turned);

  for (uint32_t i = 0; i < queries; ++i) {
    const Pose<S> slots[2] = {pose_from<S>(stream), pose_from<S>(stream)};
    const Vector3<S> p = point_from<S>(stream);
    const uint32_t count = stream.below(32) == 0 ? 1 : 2;
    switch (stream.below(9)) {
      case 0:
        add_answer(digest, smooth, p, slots, count);
        break;
      case 1:
        add_answer(digest, sharp, p, slots, count);
        break;
      case 2:
        add_answer(digest, carved, p, slots, count);
        break;
      case 3:
        add_answer(digest, moving, p, slots, count);
        break;
      case 4:
        add_answer(digest, soft, p, slots, count);
        break;
      case 5:
        add_answer(digest, nested, p, slots, count);
        break;
      case 6:
        add_answer(digest, carved_program, p, slots, count);
        break;
      case 7:
        add_answer(digest, soft_placed, p, slots, count);
        break;
      default:
        add_answer(digest, turned, p, slots, count);
        break;
    }
  }
  return digest.value();
}

}  // namespace nearfield::golden
