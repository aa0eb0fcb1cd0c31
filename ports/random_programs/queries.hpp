// The worst queries of one program that a search finds.
#pragma once

#include <nearfield/nearfield.hpp>

#include <random_programs/draw.hpp>

namespace nearfield::costs {

struct Worst {
  uint32_t measured = 0;
  uint32_t budget = 0;
};

class Queries {
 public:
  Queries(const Program<Q>& program, uint32_t seed) : program_(program), draw_(~uint64_t{seed}) {
    for (Pose<Q>& pose : poses_) pose = draw_.pose();
    for (Q& parameter : parameters_) parameter = draw_.between(100, 900);
  }

  Worst worst_value() {
    return {worst([this](const Vector3<Q>& p) { return of_value(p); }), program_.budget(kTarget).value};
  }
  Worst worst_clearance() {
    return {worst([this](const Vector3<Q>& p) { return of_clearance(p); }), program_.budget(kTarget).gradient};
  }
  // Whether a soft clearance is answered at all.
  bool may_be_soft() const { return detail::may_be_asked_softly(program_, {}, slots()); }
  Worst worst_soft_clearance() {
    return {worst([this](const Vector3<Q>& p) { return of_soft_clearance(p); }), soft_clearance_budget(program_, kTarget)};
  }

 private:
  static constexpr int anywhere = 48, at_surface = 8, uphill = 80;

  Slots<Q> slots() const { return {poses_, 4, parameters_, 4}; }
  // Not in line: the count is that of the call.
  static __attribute__((noinline)) Value<Q> value_at(const Program<Q>& program, const Vector3<Q>& p, const Slots<Q>& slots) {
    return program.evaluate<Value<Q>>(p, slots);
  }
  static __attribute__((noinline)) Clearance<Q> clearance_at(const Program<Q>& program, const Vector3<Q>& p,
                                                             const Slots<Q>& slots) {
    return clearance(program, p, slots);
  }
  static __attribute__((noinline)) Clearance<Q> soft_clearance_at(const Program<Q>& program, const Vector3<Q>& p,
                                                                  const Slots<Q>& slots) {
    return soft_clearance(program, p, slots);
  }
  template <class Query> uint32_t counted(Query&& query, const Vector3<Q>& p) const {
    const Slots<Q> given = slots();
    board::start_instruction_count();
    const auto answer = query(program_, p, given);
    const uint32_t count = board::stop_instruction_count();
    if constexpr (__is_same(decltype(answer), const Value<Q>)) sink = answer.value.raw();
    else sink = answer.distance.raw();
    return count;
  }
  uint32_t of_value(const Vector3<Q>& p) const { return counted(value_at, p); }
  uint32_t of_clearance(const Vector3<Q>& p) const { return counted(clearance_at, p); }
  uint32_t of_soft_clearance(const Vector3<Q>& p) const { return counted(soft_clearance_at, p); }

  // Points anywhere and on the surface between those of different signs; then small and large steps from the worst so far.
  template <class Cost> uint32_t worst(Cost&& cost) {
    Vector3<Q> worst_place, inside, outside;
    bool has_inside = false, has_outside = false;
    uint32_t greatest = 0;
    const auto try_at = [&](const Vector3<Q>& p) {
      const uint32_t count = cost(p);
      if (count < greatest) return;
      greatest = count;
      worst_place = p;
    };
    for (int i = 0; i < anywhere; ++i) {
      const Vector3<Q> p = draw_.point();
      try_at(p);
      const bool is_inside = value_at(program_, p, slots()).value < Q{};
      (is_inside ? inside : outside) = p;
      (is_inside ? has_inside : has_outside) = true;
      if (has_inside && has_outside && i % (anywhere / at_surface) == 0) try_at(surface_between(inside, outside));
    }
    for (int i = 0; i < uphill; ++i) try_at(draw_.near(worst_place));
    return greatest;
  }
  Vector3<Q> surface_between(Vector3<Q> inside, Vector3<Q> outside) const {
    using T = ScalarTraits<Q>;
    for (int i = 0; i < 24; ++i) {
      const Vector3<Q> middle = {T::half(inside.x) + T::half(outside.x), T::half(inside.y) + T::half(outside.y),
                                 T::half(inside.z) + T::half(outside.z)};
      (value_at(program_, middle, slots()).value < Q{} ? inside : outside) = middle;
    }
    return outside;
  }

  const Program<Q>& program_;
  Draw draw_;
  Pose<Q> poses_[4];
  Q parameters_[4];
};

}  // namespace nearfield::costs
