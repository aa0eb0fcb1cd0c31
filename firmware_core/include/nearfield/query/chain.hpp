// Robots: a chain (or tree) of links moved by joints, with capsules and balls for bodies, of fixed capacity.
#pragma once

#include <nearfield/field/budget.hpp>
#include <nearfield/modify/frame.hpp>
#include <nearfield/modify/sine.hpp>
#include <nearfield/shape/capsule.hpp>

namespace nearfield {

enum class JointKind : uint8_t { fixed, revolute, prismatic };

// A joint moves the link after its parent: link frame = parent frame * origin * motion(value about or along axis).
// `variable` numbers the joint value that drives it, value = multiplier * variable + offset (URDF's mimic; 1 and 0
// for a joint of its own). Radians or metres; limits apply to the variable times multiplier plus offset, and no joint
// turns farther than 16 rad either way.
template <class S> struct Joint {
  JointKind kind = JointKind::fixed;
  uint16_t parent = 0;
  uint16_t variable = 0;
  Pose<S> origin;
  Vector3<Unit<S>> axis;
  S multiplier = ScalarTraits<S>::one();
  S offset{};
  S lower = ScalarTraits<S>::least();
  S upper = ScalarTraits<S>::greatest();
};

// A ball (length 0) or capsule fixed to a link, in the link's frame; all of it within half the domain (2 m for
// Fixed<27>) of the link's origin, so that differences between placed bodies stay in range.
template <class S> struct Body {
  uint16_t link = 0;
  Capsule<S> capsule;
};

// Two bodies of the same robot that must be kept apart.
struct BodyPair {
  uint16_t first = 0;
  uint16_t second = 0;
};

enum class KinematicsStatus : uint8_t {
  invalid = 0,            // the chain itself is not valid
  joint_out_of_limits,    // a joint value beyond its limits, or NaN: poses are not to be used
  out_of_range,           // a link would leave the domain
  ok,
};

// Product of two poses: `inner` seen from the frame in which `outer` is given. Rounding: one per entry.
template <class S> constexpr Rotation<S> compose(const Rotation<S>& outer, const Rotation<S>& inner) {
  Rotation<S> result;
  const Vector3<Unit<S>> x = inner.column(0), y = inner.column(1), z = inner.column(2);
  for (int i = 0; i < 3; ++i) {
    const Vector3<Unit<S>>& row = outer.row[i];
    result.row[i] = {narrow_in_range<Unit<S>>(dot(row, x)), narrow_in_range<Unit<S>>(dot(row, y)),
                     narrow_in_range<Unit<S>>(dot(row, z))};
  }
  return result;
}

// Rotation by an angle (radians) about a unit axis, right-handed (Rodrigues). One rounding per entry.
template <class S> constexpr Rotation<S> rotation_about(const Vector3<Unit<S>>& axis, S angle) {
  using U = Unit<S>;
  const SineCosine<S> turn = sine_cosine(angle);
  const U one = ScalarTraits<S>::unit_one();
  const auto diagonal = [&](U k) {
    const U square = narrow_in_range<U>(product(k, k));
    return narrow_in_range<U>(product(square, one) + product(turn.cosine, one) - product(square, turn.cosine));
  };
  const auto mixed = [&](U a, U b) {
    const U ab = narrow_in_range<U>(product(a, b));
    return product(ab, one) - product(ab, turn.cosine);
  };
  const auto xy = mixed(axis.x, axis.y), yz = mixed(axis.y, axis.z), zx = mixed(axis.z, axis.x);
  const auto sx = product(turn.sine, axis.x), sy = product(turn.sine, axis.y), sz = product(turn.sine, axis.z);
  Rotation<S> r;
  r.row[0] = {diagonal(axis.x), narrow_in_range<U>(xy - sz), narrow_in_range<U>(zx + sy)};
  r.row[1] = {narrow_in_range<U>(xy + sz), diagonal(axis.y), narrow_in_range<U>(yz - sx)};
  r.row[2] = {narrow_in_range<U>(zx - sy), narrow_in_range<U>(yz + sx), diagonal(axis.z)};
  return r;
}

// How far a computed link frame may be from the true one (real joint values, real geometry), worst case.
template <class S> struct PoseError {
  uint32_t rotation = 0;  // operator norm, in units of 2^-30 (float: 2^-21)
  S position{};           // metres
};

// Link 0 is the root, at `base`; link i + 1 is moved by joint i. Parents come before children.
// Built once, by add_joint() and add_body(); valid() tells whether everything fitted and was in range.
template <class S, int MaxLinks, int MaxBodies> class Chain {
 public:
  using Scalar = S;
  static constexpr int max_links = MaxLinks;
  static constexpr int max_bodies = MaxBodies;

  constexpr Chain() = default;
  constexpr explicit Chain(const Pose<S>& base) : base_(base), valid_(valid_pose(base)) {
    errors_[0] = {2, ScalarTraits<S>::rounding_unit(ScalarTraits<S>::domain())};
  }

  // Returns the number of the link that the joint moves.
  constexpr uint16_t add_joint(const Joint<S>& joint) {
    const bool fits = links_ < MaxLinks && joint.parent < links_ && joint.variable < MaxLinks &&
                      valid_pose(joint.origin) && joint.lower <= joint.upper && valid_axis(joint);
    if (!fits) {
      valid_ = false;
      return 0;
    }
    Joint<S>& added = joints_[links_ - 1];
    added = joint;
    if (joint.kind == JointKind::revolute) {
      added.lower = greatest_of_two(joint.lower, -angle_limit());
      added.upper = least_of_two(joint.upper, angle_limit());
    }
    if (joint.kind != JointKind::fixed && joint.variable >= variables_) {
      variables_ = static_cast<uint16_t>(joint.variable + 1);
    }
    errors_[links_] = error_after(errors_[joint.parent], joint);
    return links_++;
  }
  constexpr void add_body(const Body<S>& body) {
    const S limit = ScalarTraits<S>::half(ScalarTraits<S>::domain());
    if (bodies_ >= MaxBodies || body.link >= links_ || !body.capsule.valid() || !(body.capsule.radius > S{}) ||
        !(body.capsule.extent() <= limit)) {
      valid_ = false;
      return;
    }
    body_list_[bodies_] = body;
    body_errors_[bodies_] = body_error_of(body);
    ++bodies_;
  }

  constexpr bool valid() const { return valid_; }
  constexpr uint16_t link_count() const { return links_; }
  constexpr uint16_t body_count() const { return bodies_; }
  constexpr uint16_t variable_count() const { return variables_; }
  constexpr const Joint<S>& joint(int i) const { return joints_[i]; }
  constexpr const Body<S>& body(int i) const { return body_list_[i]; }
  // Every point of body i as computed lies within this distance (metres) of where it really is.
  constexpr S body_error(int i) const { return body_errors_[i]; }

  // Poses of all links in the frame of the base, from `values[variable_count()]` (radians, metres).
  // Cost: at most poses_budget().
  constexpr KinematicsStatus link_poses(const S* values, Pose<S>* poses) const {
    if (!valid_) return KinematicsStatus::invalid;
    poses[0] = base_;
    for (int i = 0; i + 1 < links_; ++i) {
      const Joint<S>& joint = joints_[i];
      const Pose<S>& parent = poses[joint.parent];
      Pose<S> moved = joint.origin;
      if (joint.kind != JointKind::fixed) {
        // A value at the end of the number range may stand for one beyond it.
        ArithmeticStatus status;
        const S driven = narrow<S>(product(joint.multiplier, values[joint.variable]), status);
        const S value = add(driven, joint.offset, status);
        if (status.saturated || !within(value, joint.lower, joint.upper) || value >= ScalarTraits<S>::greatest() ||
            value <= ScalarTraits<S>::least()) {
          return KinematicsStatus::joint_out_of_limits;
        }
        if (joint.kind == JointKind::revolute) {
          moved.rotation = compose(joint.origin.rotation, rotation_about(joint.axis, value));
        } else {
          const Vector3<S> slide = {narrow_in_range<S>(product(value, joint.axis.x)),
                                    narrow_in_range<S>(product(value, joint.axis.y)),
                                    narrow_in_range<S>(product(value, joint.axis.z))};
          moved.translation = moved.translation + rotate(joint.origin.rotation, slide);
        }
      }
      Pose<S>& link = poses[i + 1];
      link.rotation = compose(parent.rotation, moved.rotation);
      link.translation = rotate(parent.rotation, moved.translation) + parent.translation;
      if (!coordinates_in_domain(link.translation)) return KinematicsStatus::out_of_range;
    }
    return KinematicsStatus::ok;
  }

  // Worst-case instructions of link_poses().
  constexpr uint32_t poses_budget(const Target& target = kThisTarget) const {
    uint32_t revolute = 0;
    for (int i = 0; i + 1 < links_; ++i) revolute += joints_[i].kind == JointKind::revolute ? 1u : 0u;
    const uint32_t others = links_ - (links_ == 0 ? 0u : 1u) - revolute;
    const Budget sum = target.cost(QueryPart::link_poses) + revolute * target.cost(QueryPart::revolute_joint) +
                       others * target.cost(QueryPart::other_joint);
    return detail::budget_in<S>(sum).value;
  }

  // Body i in the frame of the base, from its link's pose. Cost: target.cost(QueryPart::placed_body).
  constexpr Capsule<S> placed_body(int i, const Pose<S>* poses) const {
    const Body<S>& body = body_list_[i];
    const Pose<S>& pose = poses[body.link];
    return {to_outer(pose, body.capsule.from), rotate(pose.rotation, body.capsule.axis), body.capsule.length,
            body.capsule.radius};
  }

 private:
  static constexpr bool valid_axis(const Joint<S>& joint) {
    if (joint.kind == JointKind::fixed) return true;
    return Capsule<S>({}, joint.axis, ScalarTraits<S>::one(), S{}).valid();
  }

  // Where sine and cosine are certified: 16 rad, or what the scalar holds.
  static constexpr S angle_limit() {
    return least_of_two(ScalarTraits<S>::times(ScalarTraits<S>::one(), 16), ScalarTraits<S>::greatest());
  }

  // Rotation, in units: rounded origin 2, two products 3, and for a revolute joint the rounded result 2, sine and
  // cosine, an axis that is not a coordinate axis 5, the joint value's own rounding through multiplier and offset.
  // Position, in rounding units: origin and product 2, sums 1; a prismatic joint's value and axis 3 more.
  static constexpr PoseError<S> error_after(const PoseError<S>& parent, const Joint<S>& joint) {
    using T = ScalarTraits<S>;
    PoseError<S> error = parent;
    const S unit = T::rounding_unit(T::domain());
    const S lever = length_of<S>(sum_of_squares(joint.origin.translation.x, joint.origin.translation.y,
                                                joint.origin.translation.z)) + unit;
    error.position = parent.position + T::rotation_units_times(lever, parent.rotation) + T::times(unit, 3);
    error.rotation = parent.rotation + 5;
    if (joint.kind == JointKind::revolute) {
      error.rotation += 2 + 2 * kSineErrorUnits + 5 + T::angle_units(joint.multiplier, joint.offset);
    } else if (joint.kind == JointKind::prismatic) {
      const S travel = greatest_of_two(absolute(joint.lower), absolute(joint.upper));
      error.position = error.position + T::rotation_units_times(travel, parent.rotation + 4) + T::times(unit, 3);
    }
    return error;
  }
  // Rounding units: start sqrt(3)/2, its product sqrt(3)/2, sum 0, axis 1/2, length 1, radius 1/2.
  constexpr S body_error_of(const Body<S>& body) const {
    using T = ScalarTraits<S>;
    const PoseError<S>& link = errors_[body.link];
    return link.position + T::rotation_units_times(body.capsule.extent(), link.rotation + 2) +
           T::times(T::rounding_unit(T::domain()), 4);
  }

  Pose<S> base_;
  Joint<S> joints_[size_t{MaxLinks}] = {};
  Body<S> body_list_[size_t{MaxBodies}] = {};
  PoseError<S> errors_[size_t{MaxLinks}] = {{2, ScalarTraits<S>::rounding_unit(ScalarTraits<S>::domain())}};
  S body_errors_[size_t{MaxBodies}] = {};
  uint16_t links_ = 1, bodies_ = 0, variables_ = 0;
  bool valid_ = true;
};

}  // namespace nearfield
