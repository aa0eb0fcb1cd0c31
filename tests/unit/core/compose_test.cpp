// A field as a static composition and as a program: the same bits. And which questions are refused.
#include <golden/clearance_of_any.hpp>
#include <golden/node_writer.hpp>
#include <nearfield/curve/kernel.hpp>
#include <nearfield/curve/potential.hpp>
#include <nearfield/curve/tabulated_form.hpp>
#include <nearfield/query/clearance.hpp>
#include <reference/random.hpp>

#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <functional>
#include <limits>
#include <vector>

namespace {

using namespace nearfield;
using reference::Random;

template <class S>
struct Tables {
  static constexpr Table<S, 32> kernel = bake<S, 32>(exterior(step::polynomial<3>, 0.25));
  static constexpr Table<S, 32> wide_kernel = bake<S, 32>(exterior(step::polynomial<2>, 1.0));
  static constexpr Table<S, 2> potential = bake<S, 2>(over_square(potential::wyvill));
};

template <class S>
S metres(reference::Real real) {
  if constexpr (ScalarTraits<S>::is_fixed)
    return S(static_cast<double>(real));
  else
    return static_cast<float>(real);
}

// Random parts of fields, small enough that every composition below stays in range in every number type.
// Not inlined: copies in every test would take most of the time of compiling them.
template <class S>
class Parts {
 public:
  explicit Parts(uint64_t seed) : random_(seed) {}

  [[gnu::noinline]] S length(reference::Real low, reference::Real high) {
    return metres<S>(random_.uniform(low, high));
  }
  [[gnu::noinline]] Vector3<S> point(reference::Real reach) {
    return {length(-reach, reach), length(-reach, reach), length(-reach, reach)};
  }
  [[gnu::noinline]] Sphere<S> sphere() { return {point(0.4L), length(0.01L, 0.5L)}; }
  [[gnu::noinline]] Capsule<S> capsule() {
    const Vector3<S> a = point(0.4L);
    const Vector3<S> b = random_.chance(0.1L) ? a : point(0.4L);
    return {a, b, random_.chance(0.1L) ? S{} : length(0.01L, 0.3L)};
  }
  [[gnu::noinline]] Box<S> box() {
    return {point(0.4L), {length(0.01L, 0.4L), length(0.01L, 0.4L), length(0.01L, 0.4L)}};
  }
  [[gnu::noinline]] Cylinder<S> cylinder() {
    return {point(0.4L), length(0.01L, 0.4L), length(0.01L, 0.4L)};
  }
  [[gnu::noinline]] auto soft_point() {
    return with_potential(SoftPoint<S>{point(0.4L), Influence<S>(length(0.2L, 1), length(-1, 1))},
                          Tables<S>::potential);
  }
  [[gnu::noinline]] auto soft_segment() {
    const Capsule<S> segment(point(0.4L), point(0.4L), S{});
    return with_potential(SoftSegment<S>{segment, Influence<S>(length(0.2L, 1), length(-1, 1))},
                          Tables<S>::potential);
  }
  [[gnu::noinline]] Pose<S> pose(reference::Real reach) {
    Pose<S> pose;
    const reference::Mat3 rotation = random_.rotation();
    for (int i = 0; i < 3; ++i) {
      const auto row = static_cast<size_t>(i);
      const auto entry = [&rotation, row](size_t column) {
        const reference::Real real = reference_entry(rotation, row, column);
        if constexpr (ScalarTraits<S>::is_fixed)
          return Unit<S>(static_cast<double>(real));
        else
          return static_cast<float>(real);
      };
      pose.rotation.row[i] = {entry(0), entry(1), entry(2)};
    }
    pose.translation = point(reach);
    return pose;
  }
  S blend_radius() { return length(0.02L, 0.4L); }
  uint32_t slot() { return static_cast<uint32_t>(random_.integer(0, 2)); }
  Random& random() { return random_; }

 private:
  static reference::Real reference_entry(const reference::Mat3& rotation, size_t row, size_t column) {
    const reference::Vec3 axis = {column == 0 ? 1.0L : 0.0L, column == 1 ? 1.0L : 0.0L,
                                  column == 2 ? 1.0L : 0.0L};
    const reference::Vec3 turned = rotation * axis;
    return row == 0 ? turned.x : row == 1 ? turned.y : turned.z;
  }
  Random random_;
};

template <class S>
uint32_t word(S x) {
  return ScalarTraits<S>::word(x);
}
template <class S>
[[gnu::noinline]] void expect_same_vector(const Vector3<S>& a, const Vector3<S>& b) {
  EXPECT_EQ(word(a.x), word(b.x));
  EXPECT_EQ(word(a.y), word(b.y));
  EXPECT_EQ(word(a.z), word(b.z));
}

// What every form of a field says about itself.
template <class S>
struct Facts {
  bool valid;
  Kind kind;
  uint32_t slot_count;
  Certificate<S> certificate;
  Budget budget;
};
template <class AnyField, class S = typename AnyField::Scalar>
Facts<S> facts_of(const AnyField& field) {
  return {field.valid(), field.kind(), field.slot_count(), field.certificate(), field.budget()};
}

// What every form of a field answers at a point.
template <class S>
struct Answers {
  Sample<S> sample;
  Value<S> value;
  Clearance<S> clearance;
};
constexpr uint32_t kSlots = 3;
template <class AnyField, class S = typename AnyField::Scalar>
Answers<S> answers_of(const AnyField& field, const Vector3<S>& p, const Pose<S>* slots) {
  return {field.template evaluate<Sample<S>>(p, slots), field.template evaluate<Value<S>>(p, slots),
          golden::clearance_of_any(field, p, slots, kSlots)};
}

// The composition's type is forgotten here, so that only its evaluation is compiled for each type of node.
template <class S>
using AnswersAt = std::function<Answers<S>(const Vector3<S>& p, const Pose<S>* slots)>;

template <class S>
using Writer = golden::NodeWriter<S, 900>;

template <class S>
class Comparison {
 public:
  explicit Comparison(Parts<S>& parts) : parts_(parts) {}

  // The node as a field and as a program, at `count` points.
  template <class Node>
  [[gnu::noinline]] void expect_same(const char* name, const Node& node, int count) {
    SCOPED_TRACE(name);
    const auto composed = field(node);
    Writer<S> writer;
    add_tables(writer);
    writer.write(node);
    expect_same_as_image(
        facts_of(composed),
        [&composed](const Vector3<S>& p, const Pose<S>* slots) { return answers_of(composed, p, slots); },
        writer, count);
  }

 private:
  static void add_tables(Writer<S>& writer);
  void expect_same_as_image(const Facts<S>& composed, const AnswersAt<S>& composed_at, Writer<S>& writer,
                            int count);
  static void expect_same_answers(const Answers<S>& a, const Answers<S>& b, Kind kind);

  Parts<S>& parts_;
};

template <class S>
void Comparison<S>::add_tables(Writer<S>& writer) {
  writer.table(Tables<S>::kernel);
  writer.table(Tables<S>::wide_kernel);
  writer.table(Tables<S>::potential);
}

template <class S>
void Comparison<S>::expect_same_as_image(const Facts<S>& composed, const AnswersAt<S>& composed_at,
                                         Writer<S>& writer, int count) {
  ASSERT_EQ(writer.builder().finish().status, LoadStatus::ok);
  const std::vector<uint32_t> image(writer.builder().words(),
                                    writer.builder().words() + writer.builder().size());
  const Program<S> program = load<S>(image.data(), image.size() * 4);
  ASSERT_EQ(program.status(), LoadStatus::ok);

  EXPECT_TRUE(composed.valid);
  EXPECT_EQ(composed.kind, program.kind());
  EXPECT_EQ(composed.slot_count, program.slot_count());
  EXPECT_EQ(composed.certificate.lipschitz, program.certificate().lipschitz);
  EXPECT_EQ(word(composed.certificate.erosion), word(program.certificate().erosion));
  EXPECT_EQ(word(composed.certificate.inflation), word(program.certificate().inflation));
  EXPECT_EQ(word(composed.certificate.error), word(program.certificate().error));
  EXPECT_GE(program.budget().value, composed.budget.value);
  EXPECT_GE(program.budget().gradient, composed.budget.gradient);
  EXPECT_GE(composed.budget.gradient, composed.budget.value);

  for (int i = 0; i < count; ++i) {
    const Pose<S> slots[kSlots] = {parts_.pose(0.5L), parts_.pose(0.5L), parts_.pose(0.5L)};
    const Vector3<S> p = parts_.point(i % 4 == 0 ? 3.9L : 1.0L);
    expect_same_answers(composed_at(p, slots), answers_of(program, p, slots), composed.kind);
  }
}

template <class S>
void Comparison<S>::expect_same_answers(const Answers<S>& a, const Answers<S>& b, Kind kind) {
  EXPECT_EQ(word(a.sample.value), word(b.sample.value));
  expect_same_vector(a.sample.gradient, b.sample.gradient);
  EXPECT_EQ(word(a.value.value), word(a.sample.value));
  EXPECT_EQ(word(b.value.value), word(a.sample.value));
  EXPECT_EQ(a.clearance.status, b.clearance.status);
  EXPECT_EQ(word(a.clearance.distance), word(b.clearance.distance));
  expect_same_vector(a.clearance.direction, b.clearance.direction);
  EXPECT_EQ(a.clearance.status == ClearanceStatus::clear, a.clearance.distance > S{});
  EXPECT_EQ(a.clearance.status == ClearanceStatus::invalid, kind == Kind::intensity);
  EXPECT_EQ(b.clearance.status == ClearanceStatus::invalid, kind == Kind::intensity);
}

template <class S>
class Composition : public testing::Test {};
using Scalars = testing::Types<Fixed<27>, Fixed<16>, float>;
TYPED_TEST_SUITE(Composition, Scalars, );

constexpr int kFields = 60;
constexpr int kPoints = 20;

TYPED_TEST(Composition, LoneShapes) {
  using S = TypeParam;
  Parts<S> parts(reference::announced_seed("Composition.LoneShapes", 701));
  Comparison<S> comparison(parts);
  for (int i = 0; i < kFields; ++i) {
    comparison.expect_same("sphere", parts.sphere(), kPoints);
    comparison.expect_same("capsule", parts.capsule(), kPoints);
    comparison.expect_same("box", parts.box(), kPoints);
    comparison.expect_same("cylinder", parts.cylinder(), kPoints);
    comparison.expect_same("soft point", parts.soft_point(), kPoints);
    comparison.expect_same("soft segment", parts.soft_segment(), kPoints);
  }
}

TYPED_TEST(Composition, SharpOperations) {
  using S = TypeParam;
  Parts<S> parts(reference::announced_seed("Composition.SharpOperations", 702));
  Comparison<S> comparison(parts);
  for (int i = 0; i < kFields; ++i) {
    comparison.expect_same("union", unite(parts.sphere(), parts.box()), kPoints);
    comparison.expect_same("intersection", intersect(parts.capsule(), parts.cylinder()), kPoints);
    comparison.expect_same("subtraction", subtract(parts.box(), parts.capsule()), kPoints);
    comparison.expect_same("all",
                           subtract(intersect(unite(parts.box(), parts.sphere()), parts.cylinder()),
                                    unite(parts.capsule(), parts.sphere())),
                           kPoints);
  }
}

TYPED_TEST(Composition, ExteriorBlends) {
  using S = TypeParam;
  const auto& kernel = Tables<S>::kernel;
  const auto& wide = Tables<S>::wide_kernel;
  Parts<S> parts(reference::announced_seed("Composition.ExteriorBlends", 703));
  Comparison<S> comparison(parts);
  for (int i = 0; i < kFields; ++i) {
    const S r = parts.blend_radius();
    comparison.expect_same("union", unite(kernel, r, parts.sphere(), parts.box()), kPoints);
    comparison.expect_same("intersection", intersect(wide, r, parts.capsule(), parts.cylinder()), kPoints);
    comparison.expect_same("subtraction", subtract(kernel, r, parts.box(), parts.capsule()), kPoints);
    comparison.expect_same(
        "chain", unite(wide, r, parts.box(), parts.sphere(), parts.capsule(), parts.cylinder()), kPoints);
    comparison.expect_same("mixed",
                           subtract(unite(kernel, r, parts.box(), intersect(parts.sphere(), parts.box())),
                                    unite(wide, r, parts.capsule(), parts.cylinder())),
                           kPoints);
  }
}

TYPED_TEST(Composition, Frames) {
  using S = TypeParam;
  const auto& kernel = Tables<S>::kernel;
  Parts<S> parts(reference::announced_seed("Composition.Frames", 704));
  Comparison<S> comparison(parts);
  for (int i = 0; i < kFields; ++i) {
    const S r = parts.blend_radius();
    comparison.expect_same("placed", place(parts.pose(0.5L), parts.cylinder()), kPoints);
    comparison.expect_same("twice as large", scaled(metres<S>(2.0L), place(parts.pose(0.2L), parts.cylinder())), kPoints);
    comparison.expect_same("larger, in a slot", in_slot(parts.slot(), scaled(metres<S>(1.25L), parts.sphere())), kPoints);
    comparison.expect_same("in a slot", in_slot(parts.slot(), unite(kernel, r, parts.box(), parts.sphere())),
                           kPoints);
    comparison.expect_same(
        "placed twice", place(parts.pose(0.2L), unite(place(parts.pose(0.2L), parts.box()), parts.capsule())),
        kPoints);
    comparison.expect_same("slot in a pose",
                           unite(kernel, r, place(parts.pose(0.2L), in_slot(parts.slot(), parts.box())),
                                 in_slot(parts.slot(), parts.sphere())),
                           kPoints);
    comparison.expect_same(
        "pose in a slot",
        in_slot(parts.slot(), subtract(place(parts.pose(0.2L), parts.box()), parts.sphere())), kPoints);
  }
}

TYPED_TEST(Composition, SoftSums) {
  using S = TypeParam;
  Parts<S> parts(reference::announced_seed("Composition.SoftSums", 705));
  Comparison<S> comparison(parts);
  for (int i = 0; i < kFields; ++i) {
    comparison.expect_same("sum", soft_sum(parts.soft_point(), parts.soft_segment(), parts.soft_point()),
                           kPoints);
    comparison.expect_same("scaled sum", scaled(metres<S>(3.0L), soft_sum(parts.soft_point(), parts.soft_segment())), kPoints);
    comparison.expect_same(
        "placed sum",
        soft_sum(place(parts.pose(0.4L), parts.soft_segment()), in_slot(parts.slot(), parts.soft_point())),
        kPoints);
  }
}

// ---------------------------------------------------------------- refusals

// What `invalid` looks like: nothing in it permits anything.
template <class S>
[[gnu::noinline]] void expect_refused(const Clearance<S>& answer, const char* what) {
  EXPECT_EQ(answer.status, ClearanceStatus::invalid) << what;
  EXPECT_EQ(word(answer.distance), word(ScalarTraits<S>::least())) << what;
  EXPECT_TRUE(is_zero(answer.direction)) << what;
}

template <class S>
Sphere<S> ball_at_origin() {
  return {{}, metres<S>(0.5L)};
}

TYPED_TEST(Composition, PointsOutsideTheDomain) {
  using S = TypeParam;
  const auto ball = field(ball_at_origin<S>());
  const S limit = ScalarTraits<S>::domain();
  EXPECT_EQ(clearance(ball, Vector3<S>{limit, -limit, limit}).status, ClearanceStatus::clear);
  std::vector<S> outside;
  if constexpr (ScalarTraits<S>::is_fixed) {
    outside = {limit + S::unit_in_last_place(), -limit - S::unit_in_last_place(), S::greatest(), S::least()};
  } else {
    const float infinity = std::numeric_limits<float>::infinity(),
                nan = std::numeric_limits<float>::quiet_NaN();
    outside = {
        std::nextafter(limit, 1e9f), -std::nextafter(limit, 1e9f), infinity, -infinity, nan, -nan, 3e38f};
  }
  for (const S bad : outside) {
    expect_refused(clearance(ball, Vector3<S>{bad, S{}, S{}}), "x");
    expect_refused(clearance(ball, Vector3<S>{S{}, bad, S{}}), "y");
    expect_refused(clearance(ball, Vector3<S>{S{}, S{}, bad}), "z");
  }
}

TYPED_TEST(Composition, MissingOrBadPoses) {
  using S = TypeParam;
  const auto moving = field(unite(in_slot(1, ball_at_origin<S>()), ball_at_origin<S>()));
  EXPECT_EQ(moving.slot_count(), 2u);
  const Vector3<S> p = {metres<S>(1), metres<S>(1), S{}};
  const Pose<S> good[2] = {};
  EXPECT_EQ(clearance(moving, p, good, 2).status, ClearanceStatus::clear);
  expect_refused(clearance(moving, p), "no poses");
  expect_refused(clearance(moving, p, static_cast<const Pose<S>*>(nullptr), 2), "null");
  expect_refused(clearance(moving, p, good, 1), "too few");
  expect_refused(clearance(moving, p, good, 0), "none");

  const Unit<S> one = ScalarTraits<S>::unit_one();
  const auto expect_bad = [&](const char* what, const auto& damage) {
    for (int which = 0; which < 2; ++which) {
      Pose<S> poses[2] = {};
      damage(poses[which]);
      EXPECT_FALSE(valid_pose(poses[which])) << what;
      expect_refused(clearance(moving, p, poses, 2), what);
    }
  };
  expect_bad("mirror", [](Pose<S>& pose) { pose.rotation.row[2] = -pose.rotation.row[2]; });
  expect_bad("point reflection", [](Pose<S>& pose) {
    for (auto& row : pose.rotation.row) row = -row;
  });
  expect_bad("zero", [](Pose<S>& pose) { pose.rotation.row[0] = {}; });
  expect_bad("two rows alike", [](Pose<S>& pose) { pose.rotation.row[1] = pose.rotation.row[0]; });
  expect_bad("shear", [](Pose<S>& pose) { pose.rotation.row[0].y = metres<Unit<S>>(0.001L); });
  expect_bad("too long a row",
             [one](Pose<S>& pose) { pose.rotation.row[0].x = one + metres<Unit<S>>(0.00001L); });
  expect_bad("too short a row",
             [one](Pose<S>& pose) { pose.rotation.row[0].x = one - metres<Unit<S>>(0.00001L); });
  expect_bad("least numbers", [](Pose<S>& pose) {
    for (auto& row : pose.rotation.row) row.x = metres<Unit<S>>(-2);
  });
  expect_bad("far", [](Pose<S>& pose) { pose.translation.y = ScalarTraits<S>::domain() + metres<S>(0.01L); });
  if constexpr (!ScalarTraits<S>::is_fixed) {
    const float nan = std::numeric_limits<float>::quiet_NaN(),
                infinity = std::numeric_limits<float>::infinity();
    for (const float bad : {nan, infinity, -infinity}) {
      expect_bad("entry", [bad](Pose<S>& pose) { pose.rotation.row[1].z = bad; });
      expect_bad("diagonal", [bad](Pose<S>& pose) { pose.rotation.row[2].z = bad; });
      expect_bad("translation", [bad](Pose<S>& pose) { pose.translation.x = bad; });
    }
  }
}

// Slots beyond those that the field has are not looked at.
TYPED_TEST(Composition, UnusedPosesDoNotMatter) {
  using S = TypeParam;
  const auto moving = field(in_slot(0, ball_at_origin<S>()));
  Pose<S> poses[2] = {};
  poses[1].rotation.row[0] = {};
  const Vector3<S> p = {metres<S>(1), S{}, S{}};
  EXPECT_EQ(clearance(moving, p, poses, 2).status, ClearanceStatus::clear);
}

template <class S>
void expect_refusals(const char* what, bool valid,
                     const std::function<Clearance<S>(const Vector3<S>&, const Pose<S>*, uint32_t)>& ask) {
  ASSERT_FALSE(valid) << what;
  const Pose<S> poses[1] = {};
  for (const Vector3<S>& p : {Vector3<S>{}, Vector3<S>{metres<S>(2), metres<S>(1), metres<S>(-1)}}) {
    expect_refused(ask(p, poses, 1), what);
  }
}

template <class Node>
[[gnu::noinline]] void expect_invalid(const char* what, const Node& node) {
  using S = typename Node::Scalar;
  const auto composed = field(node);
  expect_refusals<S>(what, composed.valid(),
                     [&composed](const Vector3<S>& p, const Pose<S>* poses, uint32_t count) {
                       return golden::clearance_of_any(composed, p, poses, count);
                     });
}

TYPED_TEST(Composition, ParametersOutOfRange) {
  using S = TypeParam;
  const S half = metres<S>(0.5L), limit = ScalarTraits<S>::domain(), beyond = limit + limit;
  const Vector3<S> origin{};
  expect_invalid("negative radius", Sphere<S>{origin, -half});
  expect_invalid("great radius", Sphere<S>{origin, beyond});
  expect_invalid("far centre", Sphere<S>{{beyond, S{}, S{}}, half});
  expect_invalid("flat box", Box<S>{origin, {half, S{}, half}});
  expect_invalid("negative box", Box<S>{origin, {half, half, -half}});
  expect_invalid("far box", Box<S>{{S{}, S{}, -beyond}, {half, half, half}});
  expect_invalid("thin cylinder", Cylinder<S>{origin, S{}, half});
  expect_invalid("flat cylinder", Cylinder<S>{origin, half, S{}});
  expect_invalid("negative capsule radius", Capsule<S>(origin, {half, S{}, S{}}, -half));
  expect_invalid("negative length", Capsule<S>(origin, {ScalarTraits<S>::unit_one(), {}, {}}, -half, half));
  expect_invalid("short axis", Capsule<S>(origin, {metres<Unit<S>>(0.9L), {}, {}}, half, half));
  expect_invalid("no axis", Capsule<S>(origin, Vector3<Unit<S>>{}, half, half));
  expect_invalid("axis of a ball", Capsule<S>(origin, {ScalarTraits<S>::unit_one(), {}, {}}, S{}, half));

  const Sphere<S> good = ball_at_origin<S>(), bad = {origin, -half};
  const auto& kernel = Tables<S>::kernel;
  expect_invalid("in a union", unite(good, bad));
  expect_invalid("in a subtraction", subtract(bad, good));
  expect_invalid("in a blend", unite(kernel, half, good, good, bad));
  expect_invalid("in a frame", place(Pose<S>{}, bad));
  expect_invalid("in a slot", in_slot(0, bad));
  expect_invalid("blend radius 0", unite(kernel, S{}, good, good));
  expect_invalid("negative blend radius", intersect(kernel, -half, good, good));
  expect_invalid("great blend radius", subtract(kernel, beyond, good, good));
  Pose<S> mirror;
  mirror.rotation.row[0] = -mirror.rotation.row[0];
  expect_invalid("mirrored frame", place(mirror, good));
  Table<S, 32> unfit = kernel;
  unfit.facts.error = greatest_of<int32_t>;
  expect_invalid("table that did not fit", unite(unfit, half, good, good));
  if constexpr (!ScalarTraits<S>::is_fixed) {
    const float infinity = std::numeric_limits<float>::infinity(),
                nan = std::numeric_limits<float>::quiet_NaN();
    for (const float strange : {infinity, -infinity, nan}) {
      expect_invalid("strange radius", Sphere<S>{origin, strange});
      expect_invalid("strange centre", Sphere<S>{{0.0f, strange, 0.0f}, half});
      expect_invalid("strange box", Box<S>{origin, {half, half, strange}});
      expect_invalid("strange cylinder", Cylinder<S>{origin, half, strange});
      expect_invalid("strange capsule", Capsule<S>(origin, {half, strange, half}, half));
      expect_invalid("strange axis", Capsule<S>(origin, {strange, 1.0f, 0.0f}, half, half));
      expect_invalid("strange blend radius", unite(kernel, strange, good, good));
    }
  }
}

TYPED_TEST(Composition, SoftParametersOutOfRange) {
  using S = TypeParam;
  const S half = metres<S>(0.5L), one = metres<S>(1), limit = ScalarTraits<S>::domain();
  const Vector3<S> origin{};
  const auto invalid_point = [&](const char* what, const Vector3<S>& center, const Influence<S>& influence) {
    expect_invalid(what, with_potential(SoftPoint<S>{center, influence}, Tables<S>::potential));
  };
  invalid_point("radius 0", origin, Influence<S>(S{}, one));
  invalid_point("negative radius", origin, Influence<S>(-half, one));
  invalid_point("great weight", origin, Influence<S>(half, limit + limit));
  invalid_point("far", {S{}, limit + half, S{}}, Influence<S>(half, one));
  Influence<S> inconsistent(half, one);
  inconsistent.radius = one;
  invalid_point("radius changed afterwards", origin, inconsistent);
  const Capsule<S> thick(origin, {half, S{}, S{}}, half);
  expect_invalid("segment with a radius",
                 with_potential(SoftSegment<S>{thick, Influence<S>(half, one)}, Tables<S>::potential));
}

// The reach of nested frames adds up: where coordinates could leave the number range, the field is not valid.
TYPED_TEST(Composition, TooFarOut) {
  using S = TypeParam;
  if constexpr (ScalarTraits<S>::is_fixed) {
    Pose<S> far;
    const S limit = ScalarTraits<S>::domain();
    far.translation = {limit, limit, limit};
    const auto once = place(far, ball_at_origin<S>());
    EXPECT_TRUE(field(once).valid());
    expect_invalid("three times", place(far, place(far, once)));
    expect_invalid("slots", in_slot(0, in_slot(0, once)));
  }
}

// A slot number that no caller can serve: one more than it is not representable.
TYPED_TEST(Composition, SlotNumberOutOfRange) {
  using S = TypeParam;
  expect_invalid("last slot number", in_slot(0xffffffffu, ball_at_origin<S>()));
}

TYPED_TEST(Composition, ProgramsThatAreNotLoadedRefuse) {
  using S = TypeParam;
  const Program<S> none;
  EXPECT_EQ(none.status(), LoadStatus::no_image);
  EXPECT_FALSE(none.valid());
  expect_refused(clearance(none, Vector3<S>{}), "no image");
}

TYPED_TEST(Composition, NearerPrefersInvalid) {
  using S = TypeParam;
  Clearance<S> invalid, near, far;
  near.status = far.status = ClearanceStatus::clear;
  near.distance = metres<S>(1);
  far.distance = metres<S>(2);
  EXPECT_EQ(nearer(near, far).distance, near.distance);
  EXPECT_EQ(nearer(far, near).distance, near.distance);
  EXPECT_EQ(nearer(near, invalid).status, ClearanceStatus::invalid);
  EXPECT_EQ(nearer(invalid, near).status, ClearanceStatus::invalid);
}

}  // namespace
