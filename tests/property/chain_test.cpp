/// Link poses and placed bodies of random chains, judged by forward kinematics from unrounded parameters and
/// unrounded joint values.

#include <nearfield/query/capsule_pair.hpp>
#include <nearfield/query/chain.hpp>

#include "property/conversion.hpp"
#include "property/failures.hpp"
#include "reference/kinematics.hpp"
#include "reference/random.hpp"

#include <algorithm>
#include <array>
#include <cstdio>
#include <limits>
#include <vector>

namespace nearfield::property {
namespace {

using reference::Random;
using reference::Vec3;

constexpr int chains_per_scalar = 20000;
constexpr std::size_t most_joints = 8;
template <class S>
using TestedChain = Chain<S, 9, 9>;

// A joint as it really is: what drives it, and within which limits.
struct Drive {
  std::size_t variable = 0;
  Real multiplier = 1, offset = 0;
};
struct TrueBody {
  std::size_t link = 0;
  Vec3 a, b;
};

struct Habits {
  bool mimics = false;  // multipliers and offsets, of joints that follow others and of joints of their own
  std::size_t joints = most_joints;
  Real size = 0.5L;  // metres: of origins, slides and bodies
  long long least_bodies = chains_per_scalar;
};

// Joint values are within this, in radians or metres: the range for which sine_cosine() states its error in
// Fixed.
constexpr Real greatest_value = 16;

template <class S>
class ChainTrial {
 public:
  ChainTrial(std::uint64_t seed, Habits habits) : random_(seed), habits_(habits) {}

  void run() {
    for (int i = 0; i < chains_per_scalar; ++i) {
      make();
      ASSERT_TRUE(chain_.valid());
      judge();
    }
    body_.expect_none("bodies within body_error of the truth");
    rotation_.expect_none("link poses pass valid_pose()");
    status_.expect_none("values within the limits give poses");
    EXPECT_GE(bodies_, habits_.least_bodies);
    std::printf(
        "%s, up to %zu joints%s, %.1Lf m: %lld bodies, %lld chains out of range; greatest error %.3Lf of the "
        "certified, %.2Le m\n",
        ScalarName<S>::text().c_str(), habits_.joints, habits_.mimics ? " with mimics" : "", habits_.size,
        bodies_, out_of_range_, greatest_share_, greatest_error_);
  }

 private:
  Real size() const { return habits_.size; }

  void make() {
    tree_ = {};
    drives_.clear();
    bodies_of_chain_.clear();
    values_.clear();
    base_ = random_.pose(size());
    chain_ = TestedChain<S>(rounded_pose<S>(base_));
    const std::size_t joints =
        static_cast<std::size_t>(random_.integer(1, static_cast<std::int64_t>(habits_.joints)));
    tree_.link_count = joints + 1;
    for (std::size_t i = 0; i < joints; ++i) add_joint(i);
    for (std::size_t link = 0; link <= joints; ++link) {
      if (link == joints || random_.chance(0.5L)) add_body(link);
    }
  }

  void add_joint(std::size_t i) {
    reference::Joint truth;
    truth.parent_link =
        random_.chance(0.8L) ? i : static_cast<std::size_t>(random_.integer(0, static_cast<std::int64_t>(i)));
    truth.child_link = i + 1;
    truth.origin = {random_.chance(0.3L) ? reference::Mat3{} : random_.rotation(),
                    random_.vector(-size(), size())};
    truth.axis = random_.chance(0.3L) ? Vec3{0, 0, 1} : random_.unit_vector();
    const Real kind = random_.uniform();
    truth.kind = kind < 0.65L   ? reference::JointKind::revolute
                 : kind < 0.85L ? reference::JointKind::prismatic
                                : reference::JointKind::fixed;

    Joint<S> joint;
    joint.kind = static_cast<JointKind>(truth.kind);
    joint.parent = static_cast<uint16_t>(truth.parent_link);
    joint.origin = rounded_pose<S>(truth.origin);
    if (truth.kind != reference::JointKind::fixed) joint.axis = rounded<Unit<S>>(truth.axis);
    Drive drive;
    if (truth.kind != reference::JointKind::fixed) {
      const bool slides = truth.kind == reference::JointKind::prismatic;
      const Real most = slides ? size() : random_.chance(0.5L) ? 2 * reference::pi : Real{12};
      if (habits_.mimics && random_.chance(0.6L)) {
        drive = mimicking(most);
      } else {
        drive.variable = values_.size();
        values_.push_back(random_.uniform(-most, most));
      }
      joint.variable = static_cast<uint16_t>(drive.variable);
      joint.multiplier = rounded<S>(drive.multiplier);
      joint.offset = rounded<S>(drive.offset);
      joint.lower = rounded<S>(-most * 1.001L);
      joint.upper = rounded<S>(most * 1.001L);
    }
    tree_.joints.push_back(truth);
    drives_.push_back(drive);
    EXPECT_EQ(chain_.add_joint(joint), i + 1);
  }

  // Follows an earlier variable, or a new one, without leaving +-most.
  Drive mimicking(Real most) {
    Drive drive;
    drive.variable = static_cast<std::size_t>(random_.integer(0, static_cast<std::int64_t>(values_.size())));
    drive.multiplier = random_.chance(0.3L) ? 1 : random_.chance(0.3L) ? -1 : random_.uniform(-2, 2);
    if (drive.variable == values_.size()) {
      const Real farthest =
          std::min(most / 2 / std::max(std::fabs(drive.multiplier), Real{0.01L}), greatest_value);
      values_.push_back(random_.uniform(-farthest, farthest));
    }
    const Real followed = std::fabs(drive.multiplier * values_[drive.variable]);
    if (followed > most / 2) drive.multiplier *= most / 2 / followed;
    drive.offset = random_.chance(0.3L) ? 0 : random_.uniform(-most, most) / 2;
    return drive;
  }

  void add_body(std::size_t link) {
    TrueBody truth;
    truth.link = link;
    // All of a body lies within half the domain of its link.
    const Real reach = std::min(size(), real(ScalarTraits<S>::domain()) / 8);
    truth.a = random_.vector(-reach, reach);
    truth.b = random_.chance(0.1L) ? truth.a : truth.a + random_.vector(-reach, reach);
    Body<S> body;
    body.link = static_cast<uint16_t>(link);
    body.capsule = Capsule<S>(rounded<S>(truth.a), rounded<S>(truth.b), rounded<S>(reach * 0.1L));
    chain_.add_body(body);
    bodies_of_chain_.push_back(truth);
  }

  void judge() {
    std::array<S, most_joints> values{};
    for (std::size_t i = 0; i < values_.size(); ++i) values[i] = rounded<S>(values_[i]);
    std::vector<Real> positions;
    for (const Drive& drive : drives_) {
      positions.push_back(values_.empty() ? Real{0}
                                          : drive.multiplier * values_[drive.variable] + drive.offset);
    }
    const std::vector<reference::Pose> truth = reference::forward_kinematics(tree_, positions, base_);

    std::array<Pose<S>, most_joints + 1> poses{};
    const KinematicsStatus status = chain_.link_poses(values.data(), poses.data());
    const Real domain = real(ScalarTraits<S>::domain());
    Real farthest = 0;
    for (const reference::Pose& pose : truth) {
      const Vec3& t = pose.translation;
      farthest = std::max({farthest, std::fabs(t.x), std::fabs(t.y), std::fabs(t.z)});
    }
    if (std::fabs(farthest - domain) > domain * 1e-5L) {
      const KinematicsStatus expected =
          farthest < domain ? KinematicsStatus::ok : KinematicsStatus::out_of_range;
      status_.check(status == expected, [&](std::ostream& out) {
        out << "status " << static_cast<int>(status) << " with a link at " << farthest;
      });
    }
    if (status != KinematicsStatus::ok) {
      ++out_of_range_;
      return;
    }
    for (uint16_t i = 0; i < chain_.link_count(); ++i) {
      rotation_.check(valid_pose(poses[i]), [&](std::ostream& out) { out << "link " << i; });
    }
    for (std::size_t i = 0; i < bodies_of_chain_.size(); ++i) judge_body(static_cast<int>(i), poses, truth);
  }

  void judge_body(int i, const std::array<Pose<S>, most_joints + 1>& poses,
                  const std::vector<reference::Pose>& truth) {
    const TrueBody& body = bodies_of_chain_[static_cast<std::size_t>(i)];
    const Capsule<S> placed = chain_.placed_body(i, poses.data());
    const reference::Segment segment = stored_segment(placed);
    const Real certified = real(chain_.body_error(i));
    const Real off = std::max(reference::distance(segment.a, reference::to_world(truth[body.link], body.a)),
                              reference::distance(segment.b, reference::to_world(truth[body.link], body.b)));
    ++bodies_;
    greatest_share_ = std::max(greatest_share_, off / certified);
    greatest_error_ = std::max(greatest_error_, off);
    body_.check(off <= certified, [&](std::ostream& out) {
      out << off << " m off, certified " << certified << " m, " << tree_.joints.size() << " joints:";
      for (std::size_t k = 0; k < drives_.size(); ++k) {
        out << " kind " << static_cast<int>(tree_.joints[k].kind) << " times " << drives_[k].multiplier
            << " plus " << drives_[k].offset << ";";
      }
    });
  }

  Random random_;
  Habits habits_;
  TestedChain<S> chain_;
  reference::Pose base_;
  reference::KinematicTree tree_;
  std::vector<Drive> drives_;
  std::vector<Real> values_;
  std::vector<TrueBody> bodies_of_chain_;
  Failures body_, rotation_, status_;
  Real greatest_share_ = 0, greatest_error_ = 0;
  long long bodies_ = 0, out_of_range_ = 0;
};

TEST(Chain, BodiesAreWithinTheirErrorInFixed27) {
  const std::uint64_t seed = reference::announced_seed("BodiesAreWithinTheirErrorInFixed27", 501);
  ChainTrial<Fixed<27>>(seed, {}).run();
  const Real reach = real(ScalarTraits<Fixed<27>>::domain());
  ChainTrial<Fixed<27>>(seed + 1000, {false, 3, reach / 3, chains_per_scalar / 4}).run();
}
TEST(Chain, BodiesAreWithinTheirErrorInFixed16) {
  const std::uint64_t seed = reference::announced_seed("BodiesAreWithinTheirErrorInFixed16", 502);
  ChainTrial<Fixed<16>>(seed, {}).run();
  const Real reach = real(ScalarTraits<Fixed<16>>::domain());
  ChainTrial<Fixed<16>>(seed + 1000, {false, 3, reach / 3, chains_per_scalar / 4}).run();
}
TEST(Chain, BodiesAreWithinTheirErrorInFloat) {
  const std::uint64_t seed = reference::announced_seed("BodiesAreWithinTheirErrorInFloat", 503);
  ChainTrial<float>(seed, {}).run();
  const Real reach = real(ScalarTraits<float>::domain());
  ChainTrial<float>(seed + 1000, {false, 3, reach / 3, chains_per_scalar / 4}).run();
}
TEST(Chain, BodiesOfMimickingJointsAreWithinTheirErrorInFixed27) {
  const std::uint64_t seed =
      reference::announced_seed("BodiesOfMimickingJointsAreWithinTheirErrorInFixed27", 504);
  ChainTrial<Fixed<27>>(seed, {true}).run();
  ChainTrial<Fixed<27>>(seed + 1000, {true, 1}).run();
}
TEST(Chain, BodiesOfMimickingJointsAreWithinTheirErrorInFixed16) {
  const std::uint64_t seed =
      reference::announced_seed("BodiesOfMimickingJointsAreWithinTheirErrorInFixed16", 505);
  ChainTrial<Fixed<16>>(seed, {true}).run();
  ChainTrial<Fixed<16>>(seed + 1000, {true, 1}).run();
  // With levers this long the rounding of an offset is most of the error.
  ChainTrial<Fixed<16>>(seed + 2000, {true, 1, 60}).run();
}
TEST(Chain, BodiesOfMimickingJointsAreWithinTheirErrorInFloat) {
  const std::uint64_t seed =
      reference::announced_seed("BodiesOfMimickingJointsAreWithinTheirErrorInFloat", 506);
  ChainTrial<float>(seed, {true}).run();
  ChainTrial<float>(seed + 1000, {true, 1}).run();
}

template <class S>
void expect_limits_respected() {
  const S one = ScalarTraits<S>::one();
  TestedChain<S> chain;
  for (const JointKind kind : {JointKind::revolute, JointKind::prismatic}) {
    Joint<S> joint;
    joint.kind = kind;
    joint.parent = static_cast<uint16_t>(chain.link_count() - 1);
    joint.variable = joint.parent;
    joint.axis = {{}, {}, ScalarTraits<S>::unit_one()};
    joint.lower = -one;
    joint.upper = one + one;
    chain.add_joint(joint);
  }
  ASSERT_TRUE(chain.valid());
  ASSERT_EQ(chain.variable_count(), 2);
  std::array<Pose<S>, 9> poses{};
  const auto status = [&](S a, S b) {
    const std::array<S, 2> values{a, b};
    return chain.link_poses(values.data(), poses.data());
  };
  const S beyond = rounded<S>(2.001L), below = rounded<S>(-1.001L);
  EXPECT_EQ(status(-one, one + one), KinematicsStatus::ok);
  EXPECT_EQ(status(one + one, -one), KinematicsStatus::ok);
  for (const S wrong : {beyond, below, ScalarTraits<S>::greatest(), ScalarTraits<S>::least()}) {
    EXPECT_EQ(status(wrong, one), KinematicsStatus::joint_out_of_limits) << static_cast<double>(real(wrong));
    EXPECT_EQ(status(one, wrong), KinematicsStatus::joint_out_of_limits) << static_cast<double>(real(wrong));
  }
  if constexpr (!ScalarTraits<S>::is_fixed) {
    const float nan = std::numeric_limits<float>::quiet_NaN(),
                infinite = std::numeric_limits<float>::infinity();
    for (const float wrong : {nan, infinite, -infinite}) {
      EXPECT_EQ(status(wrong, one), KinematicsStatus::joint_out_of_limits);
      EXPECT_EQ(status(one, wrong), KinematicsStatus::joint_out_of_limits);
    }
  }
}

TEST(Chain, LimitsAreRespectedByEveryScalar) {
  expect_limits_respected<Fixed<27>>();
  expect_limits_respected<Fixed<16>>();
  expect_limits_respected<float>();
}

// However far a slide without limits goes, and whatever it is turned by, it never comes back into the domain.
template <class S>
void expect_out_of_range_is_noticed(Random& random) {
  Failures noticed;
  const Real reach = real(ScalarTraits<S>::domain());
  for (int i = 0; i < 20000; ++i) {
    const reference::Pose base = random.pose(reach), origin = random.pose(reach);
    TestedChain<S> chain(rounded_pose<S>(base));
    Joint<S> joint;
    joint.kind = JointKind::prismatic;
    joint.origin = rounded_pose<S>(origin);
    const Vec3 axis = random.unit_vector();
    joint.axis = rounded<Unit<S>>(axis);
    chain.add_joint(joint);
    const S value = random.chance(0.1L)
                        ? ScalarTraits<S>::greatest()
                        : rounded<S>(random.uniform(-1, 1) * real(ScalarTraits<S>::greatest()));
    std::array<Pose<S>, 9> poses{};
    const KinematicsStatus status = chain.link_poses(&value, poses.data());
    const Vec3 truth = reference::to_world(base, reference::to_world(origin, real(value) * axis));
    const Real farthest = std::max({std::fabs(truth.x), std::fabs(truth.y), std::fabs(truth.z)});
    const bool at_the_end = value >= ScalarTraits<S>::greatest();  // may stand for a value beyond the range
    noticed.check(at_the_end ? status == KinematicsStatus::joint_out_of_limits
                             : farthest <= reach * 1.0001L || status == KinematicsStatus::out_of_range,
                  [&](std::ostream& out) {
                    out << "status " << static_cast<int>(status) << ", link at " << farthest << ", value "
                        << real(value);
                  });
  }
  noticed.expect_none("out_of_range");
}

TEST(Chain, LinksOutOfRangeAreNoticedByEveryScalar) {
  Random random(reference::announced_seed("LinksOutOfRangeAreNoticedByEveryScalar", 507));
  expect_out_of_range_is_noticed<Fixed<27>>(random);
  expect_out_of_range_is_noticed<Fixed<16>>(random);
  expect_out_of_range_is_noticed<float>(random);
}

// A joint that turns without end: far beyond the angles at which a sine is precise, or refused there.
template <class S>
void expect_far_angles_within_error(Random& random) {
  const Real lever = real(ScalarTraits<S>::domain()) * 0.45L,
             most = real(ScalarTraits<S>::greatest()) * 0.999L;
  Failures body_error;
  for (int i = 0; i < 50000; ++i) {
    TestedChain<S> chain;
    Joint<S> joint;
    joint.kind = JointKind::revolute;
    joint.axis = {{}, {}, ScalarTraits<S>::unit_one()};
    chain.add_joint(joint);
    const Vector3<S> start{rounded<S>(lever), {}, {}};
    chain.add_body({1, Capsule<S>(start, start, rounded<S>(0.1L))});
    const Real angle = random.uniform(-most, most);
    const S value = rounded<S>(angle);
    std::array<Pose<S>, 9> poses{};
    const KinematicsStatus status = chain.link_poses(&value, poses.data());
    ASSERT_EQ(status, std::fabs(real(value)) <= 16 ? KinematicsStatus::ok : KinematicsStatus::joint_out_of_limits);
    if (status != KinematicsStatus::ok) continue;
    const Vec3 truth{real(start.x) * std::cos(angle), real(start.x) * std::sin(angle), 0};
    const Real off = reference::distance(real(chain.placed_body(0, poses.data()).from), truth);
    const Real certified = real(chain.body_error(0));
    body_error.check(off <= certified, [&](std::ostream& out) {
      out << off << " m off at " << angle << " rad, certified " << certified;
    });
  }
  body_error.expect_none(ScalarName<S>::text() + ": body_error of a joint without limits");
}

TEST(Chain, EndlessJointsKeepTheirErrorOrAreRefused) {
  Random random(reference::announced_seed("EndlessJointsKeepTheirErrorOrAreRefused", 508));
  expect_far_angles_within_error<Fixed<27>>(random);
  expect_far_angles_within_error<Fixed<16>>(random);
  expect_far_angles_within_error<float>(random);
}

// Bodies may reach beyond the domain when their links are at its edge; their separation must not wrap.
template <class S>
void expect_separation_of_far_bodies(Random& random) {
  const Real reach = real(ScalarTraits<S>::domain());
  Failures too_large;
  int judged = 0;
  for (int i = 0; i < 50000; ++i) {
    TestedChain<S> chain;
    for (uint16_t link = 1; link <= 2; ++link) {
      // Each link at one side of the domain, its body pointing farther out from it by up to half the domain.
      const Vec3 out = (link == 1 ? 1 : -1) * reference::normalized_or_zero({1, random.uniform(0, 0.3L), 0});
      const Vec3 start = random.vector(0.05L, 0.14L) * reach;
      const Vec3 axis = reference::cross(start, out);
      const Real angle = std::atan2(reference::norm(axis), reference::dot(start, out));
      Joint<S> joint;
      joint.origin = rounded_pose<S>({reference::rotation_from_axis_angle(axis, angle), 0.98L * reach * out});
      chain.add_joint(joint);
      const Vec3 end = start - reference::normalized_or_zero(start) * random.uniform(-0.24L, 0.24L) * reach;
      chain.add_body({link, Capsule<S>(rounded<S>(start), rounded<S>(end), rounded<S>(reach * 0.01L))});
    }
    std::array<Pose<S>, 9> poses{};
    const S none{};
    if (!chain.valid() || chain.link_poses(&none, poses.data()) != KinematicsStatus::ok) continue;
    ++judged;
    const Capsule<S> a = chain.placed_body(0, poses.data()), b = chain.placed_body(1, poses.data());
    const Real truth = reference::capsule_capsule_clearance(stored_segment(a), real(a.radius),
                                                            stored_segment(b), real(b.radius));
    const Real claimed = real(separation(a, b).distance);
    too_large.check(claimed <= truth,
                    [&](std::ostream& out) { out << claimed << " claimed, " << truth << " true"; });
  }
  EXPECT_GT(judged, 40000);
  too_large.expect_none(ScalarName<S>::text() + ": separation of bodies of a valid chain");
}

// A joint value that saturates on its way must not move the arm somewhere else and read as fine.
TEST(Chain, SaturatedJointValuesAreRefused) {
  using S = Fixed<27>;
  for (const double value : {1.9, 2.5, 20.0}) {
    TestedChain<S> chain;
    Joint<S> joint;
    joint.kind = JointKind::revolute;
    joint.axis = {{}, {}, ScalarTraits<S>::unit_one()};
    joint.multiplier = S(value == 20.0 ? 1.0 : 8.0);
    chain.add_joint(joint);
    const S raw(value);
    std::array<Pose<S>, 9> poses{};
    EXPECT_EQ(chain.link_poses(&raw, poses.data()),
              value == 1.9 ? KinematicsStatus::ok : KinematicsStatus::joint_out_of_limits)
        << value;
  }
}

// What reaches farther than half the domain from its link could make differences wrap.
TEST(Chain, BodiesTooFarFromTheirLinkAreRefused) {
  using S = Fixed<27>;
  for (const double length : {1.8, 2.1}) {
    TestedChain<S> chain;
    chain.add_body({0, Capsule<S>(Vector3<S>{}, Vector3<S>{length, 0.0, 0.0}, S(0.1))});
    EXPECT_EQ(chain.valid(), length < 1.9) << length;
  }
}

TEST(Chain, SeparationOfBodiesBeyondTheDomainIsNotTooLarge) {
  Random random(reference::announced_seed("SeparationOfBodiesBeyondTheDomainIsNotTooLarge", 509));
  expect_separation_of_far_bodies<Fixed<27>>(random);
  expect_separation_of_far_bodies<Fixed<16>>(random);
  expect_separation_of_far_bodies<float>(random);
}

TEST(Chain, UnusableChainsGiveNoPoses) {
  using S = Fixed<27>;
  std::array<Pose<S>, 9> poses{};
  const std::array<S, 9> values{};
  Joint<S> without_axis;
  without_axis.kind = JointKind::revolute;
  Joint<S> orphan;
  orphan.parent = 1;
  Joint<S> bent;
  bent.origin.rotation.row[0].x = Unit<S>(0.9);
  for (const Joint<S>& joint : {without_axis, orphan, bent}) {
    TestedChain<S> chain;
    chain.add_joint(joint);
    EXPECT_FALSE(chain.valid());
    EXPECT_EQ(chain.link_poses(values.data(), poses.data()), KinematicsStatus::invalid);
  }
}

}  // namespace
}  // namespace nearfield::property
