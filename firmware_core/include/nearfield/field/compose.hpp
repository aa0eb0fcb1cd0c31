// Static composition: fields as C++ values, built from shapes and blends, inlined by the compiler.
#pragma once

#include <nearfield/field/apply.hpp>
#include <nearfield/field/budget.hpp>
#include <nearfield/field/slots.hpp>

namespace nearfield {

// The nodes of a composition: an operation with its operands, seen by way of NodeTraits.
template <class... Node> struct NodeList {
  static constexpr int count = 0;
};
template <class First, class... Rest> struct NodeList<First, Rest...> {
  static constexpr int count = 1 + static_cast<int>(sizeof...(Rest));
  First first;
  NodeList<Rest...> rest;
};

// Leaves without a table are the shapes themselves. View: how the table is seen, TableView<Scalar> but for narrower
// tables; where an operation has none it stays empty.
template <class T, class View, class... Operand> struct Combined {
  using Scalar = typename T::Scalar;
  static constexpr Kind kind = T::kind;
  T operation;
  View table;
  TableFacts facts;
  NodeList<Operand...> operands;
};
template <class A> struct Placed {
  using Scalar = typename A::Scalar;
  static constexpr Kind kind = A::kind;
  Pose<Scalar> pose;
  A a;
};
template <class A> struct InBox {
  using Scalar = typename A::Scalar;
  static constexpr Kind kind = Kind::distance;
  DeclaredBox<Scalar> box;
  A a;
};
template <class A> struct Scaled {
  using Scalar = typename A::Scalar;
  static constexpr Kind kind = A::kind;
  UniformScale<Scalar> scale;
  A a;
};
template <class A> struct InSlot {
  using Scalar = typename A::Scalar;
  static constexpr Kind kind = A::kind;
  uint32_t slot;
  A a;
};

namespace detail {

// One meaning of each node for evaluation, greatest values, certificate, budget and slots: the recursion over the node's
// type.
template <class Shape> struct NodeTraits {
  using S = typename Shape::Scalar;
  template <class Out> static constexpr Out evaluate(const Shape& shape, const Vector3<S>& p, const Slots<S>&) {
    return shape.template evaluate<Out>(p);
  }
  static constexpr bool has_highest = passes_highest<Shape>;
  static constexpr Highest<S> highest(const Shape& shape, const Vector3<S>& p, const Ball<S>& ball, const Slots<S>&) {
    if constexpr (has_own_highest<Shape>) return shape.highest(p, ball);
    else return shape.template evaluate<Highest<S>>(p);
  }
  static constexpr Certificate<S> certificate(const Shape& shape, Reach<S> reach) { return shape.certificate(reach); }
  static constexpr Budget budget(const Shape& shape, const Target& target) { return target.cost_of(shape); }
  static constexpr uint32_t slot_count(const Shape&) { return 0; }
  static constexpr uint32_t parameter_count(const Shape&) { return 0; }
};

// Whether sample_table() may be asked for slopes: as in an image.
template <class View> constexpr bool slopes_fit(const View& table) {
  return table.slope_headroom <= 3 && table.slope_headroom <= table.index_bits;
}

// How many slots there are when this is the last one; one too many of a slot that there cannot be.
constexpr uint32_t parameter_slots_up_to(uint32_t slot) { return slot < kParameterLimit ? slot + 1 : kParameterLimit + 1; }

// The same of the operands, into arrays.
template <class... Operand> struct NodeListTraits;
template <> struct NodeListTraits<> {
  template <class Out, class S> static constexpr void evaluate(Out*, const NodeList<>&, const Vector3<S>&, const Slots<S>&) {}
  static constexpr bool has_highest = true;
  template <class S>
  static constexpr void highest(Highest<S>*, const NodeList<>&, const Vector3<S>&, const Ball<S>&, const Slots<S>&) {}
  template <class S> static constexpr void certificates(Certificate<S>*, const NodeList<>&, Reach<S>) {}
  static constexpr Budget budget(const NodeList<>&, const Target&) { return {}; }
  static constexpr uint32_t slot_count(const NodeList<>&) { return 0; }
  static constexpr uint32_t parameter_count(const NodeList<>&) { return 0; }
};
template <class First, class... Rest> struct NodeListTraits<First, Rest...> {
  using List = NodeList<First, Rest...>;
  using Others = NodeListTraits<Rest...>;
  template <class Out, class S>
  static constexpr void evaluate(Out* out, const List& list, const Vector3<S>& p, const Slots<S>& slots) {
    *out = NodeTraits<First>::template evaluate<Out>(list.first, p, slots);
    Others::template evaluate<Out, S>(out + 1, list.rest, p, slots);
  }
  static constexpr bool has_highest = NodeTraits<First>::has_highest && Others::has_highest;
  template <class S>
  static constexpr void highest(Highest<S>* out, const List& list, const Vector3<S>& p, const Ball<S>& ball,
                                const Slots<S>& slots) {
    *out = NodeTraits<First>::highest(list.first, p, ball, slots);
    Others::template highest<S>(out + 1, list.rest, p, ball, slots);
  }
  template <class S> static constexpr void certificates(Certificate<S>* out, const List& list, Reach<S> reach) {
    *out = NodeTraits<First>::certificate(list.first, reach);
    Others::template certificates<S>(out + 1, list.rest, reach);
  }
  static constexpr Budget budget(const List& list, const Target& target) {
    return NodeTraits<First>::budget(list.first, target) + Others::budget(list.rest, target);
  }
  static constexpr uint32_t slot_count(const List& list) {
    return greatest_of_two(NodeTraits<First>::slot_count(list.first), Others::slot_count(list.rest));
  }
  static constexpr uint32_t parameter_count(const List& list) {
    return greatest_of_two(NodeTraits<First>::parameter_count(list.first), Others::parameter_count(list.rest));
  }
};

template <class T, class View, class... Operand> struct NodeTraits<Combined<T, View, Operand...>> {
  using Node = Combined<T, View, Operand...>;
  using S = typename Node::Scalar;
  using Operands = NodeListTraits<Operand...>;
  static constexpr int count = NodeList<Operand...>::count;

  template <class Out> static constexpr Out evaluate(const Node& node, const Vector3<S>& p, const Slots<S>& slots) {
    Out of[static_cast<size_t>(count == 0 ? 1 : count)] = {};
    Operands::template evaluate<Out, S>(of, node.operands, p, slots);
    return applied(node, p, slots, of);
  }
  static constexpr bool has_highest = passes_highest<T> && Operands::has_highest;
  static constexpr Highest<S> highest(const Node& node, const Vector3<S>& p, const Ball<S>& ball, const Slots<S>& slots) {
    Highest<S> of[static_cast<size_t>(count == 0 ? 1 : count)] = {};
    Operands::template highest<S>(of, node.operands, p, ball, slots);
    if constexpr (!has_own_highest<T>) {
      return applied(node, p, slots, of);
    } else {
      const auto with = [&](const auto&... operands) {
        return apply_highest(node.operation, p, ball, node.table, slots.parameters, operands...);
      };
      if constexpr (count == 0) return with();
      else if constexpr (count == 1) return with(of[0]);
      else return with(of[0], of[1]);
    }
  }
  static constexpr Certificate<S> certificate(const Node& node, Reach<S> reach) {
    if constexpr (count == 0) {
      Certificate<S> own = node.operation.certificate(reach, node.facts);
      own.valid = own.valid && slopes_fit(node.table);
      return own;
    } else {
      Certificate<S> of[static_cast<size_t>(count)] = {};
      Operands::template certificates<S>(of, node.operands, reach);
      Certificate<S> all = certificate_of(node.operation, of, count, node.facts, reach);
      all.valid = all.valid && slopes_fit(node.table) && table_fits(node.operation, node.table);
      if constexpr (takes_parameter_of<T>) all.valid = all.valid && node.operation.slot < kParameterLimit;
      return all;
    }
  }
  static constexpr Budget budget(const Node& node, const Target& target) {
    return Operands::budget(node.operands, target) + target.cost_of(node.operation);
  }
  static constexpr uint32_t slot_count(const Node& node) { return Operands::slot_count(node.operands); }
  static constexpr uint32_t parameter_count(const Node& node) {
    const uint32_t of_operands = Operands::parameter_count(node.operands);
    if constexpr (takes_parameter_of<T>) return greatest_of_two(of_operands, parameter_slots_up_to(node.operation.slot));
    else return of_operands;
  }

 private:
  template <class Out>
  static constexpr Out applied(const Node& node, const Vector3<S>& p, const Slots<S>& slots, const Out* of) {
    const auto with = [&](const auto&... operands) {
      return apply<Out>(node.operation, p, node.table, slots.parameters, operands...);
    };
    if constexpr (operand_count_of<T> == kAnyNumber) return apply_to_all<Out>(node.operation, node.table, of);
    else if constexpr (count == 0) return with();
    else if constexpr (count == 1) return with(of[0]);
    else return with(of[0], of[1]);
  }
};

// What a field inside another passes on: `operation` enters it.
template <class Node, Operation operation> struct EnteredNode {
  using Inner = NodeTraits<decltype(Node::a)>;
  static constexpr bool has_highest = Inner::has_highest;
  static constexpr Budget budget(const Node& node, const Target& target) {
    return Inner::budget(node.a, target) + target.cost(operation);
  }
  static constexpr uint32_t slot_count(const Node& node) { return Inner::slot_count(node.a); }
  static constexpr uint32_t parameter_count(const Node& node) { return Inner::parameter_count(node.a); }
};

template <class A> struct NodeTraits<Placed<A>> : EnteredNode<Placed<A>, Operation::enter_pose> {
  using Node = Placed<A>;
  using S = typename Node::Scalar;
  template <class Out> static constexpr Out evaluate(const Node& node, const Vector3<S>& p, const Slots<S>& slots) {
    Out out = NodeTraits<A>::template evaluate<Out>(node.a, to_inner(node.pose, p), slots);
    if constexpr (Out::has_gradient) out.gradient = rotate(node.pose.rotation, out.gradient);
    return out;
  }
  static constexpr Highest<S> highest(const Node& node, const Vector3<S>& p, const Ball<S>& ball, const Slots<S>& slots) {
    return NodeTraits<A>::highest(node.a, to_inner(node.pose, p),
                                  inner_ball(ball, node.pose.translation, PoseOrigin::constant), slots);
  }
  static constexpr Certificate<S> certificate(const Node& node, Reach<S> reach) {
    const Reach<S> inner = inner_reach(reach, node.pose.translation);
    Certificate<S> placed =
        placed_certificate(NodeTraits<A>::certificate(node.a, inner), A::kind, inner, PoseOrigin::constant);
    placed.valid = placed.valid && valid_pose(node.pose);
    return placed;
  }
};

template <class A> struct NodeTraits<Scaled<A>> : EnteredNode<Scaled<A>, Operation::enter_scale> {
  using Node = Scaled<A>;
  using S = typename Node::Scalar;
  template <class Out> static constexpr Out evaluate(const Node& node, const Vector3<S>& p, const Slots<S>& slots) {
    return node.scale.to_outer(A::kind, NodeTraits<A>::template evaluate<Out>(node.a, node.scale.to_inner(p), slots));
  }
  static constexpr Highest<S> highest(const Node& node, const Vector3<S>& p, const Ball<S>& ball, const Slots<S>& slots) {
    return node.scale.to_outer(
        A::kind, NodeTraits<A>::highest(node.a, node.scale.to_inner(p), node.scale.to_inner(ball), slots));
  }
  static constexpr Certificate<S> certificate(const Node& node, Reach<S> reach) {
    return node.scale.certificate(NodeTraits<A>::certificate(node.a, node.scale.reach(reach)), A::kind, reach);
  }
};

template <class A> struct NodeTraits<InBox<A>> : EnteredNode<InBox<A>, Operation::enter_box> {
  using Node = InBox<A>;
  using S = typename Node::Scalar;
  template <class Out> static constexpr Out evaluate(const Node& node, const Vector3<S>& p, const Slots<S>& slots) {
    return node.box.at(p, NodeTraits<A>::template evaluate<Out>(node.a, node.box.nearest_inside(p), slots));
  }
  static constexpr Highest<S> highest(const Node& node, const Vector3<S>& p, const Ball<S>&, const Slots<S>& slots) {
    return evaluate<Highest<S>>(node, p, slots);
  }
  static constexpr Certificate<S> certificate(const Node& node, Reach<S> reach) {
    return node.box.certificate(NodeTraits<A>::certificate(node.a, node.box.reach()), reach);
  }
};

template <class A> struct NodeTraits<InSlot<A>> : EnteredNode<InSlot<A>, Operation::enter_slot> {
  using Node = InSlot<A>;
  using S = typename Node::Scalar;
  template <class Out> static constexpr Out evaluate(const Node& node, const Vector3<S>& p, const Slots<S>& slots) {
    const Pose<S>& pose = slots.poses[node.slot];
    Out out = NodeTraits<A>::template evaluate<Out>(node.a, to_inner(pose, p), slots);
    if constexpr (Out::has_gradient) out.gradient = rotate(pose.rotation, out.gradient);
    return out;
  }
  static constexpr Highest<S> highest(const Node& node, const Vector3<S>& p, const Ball<S>& ball, const Slots<S>& slots) {
    const Pose<S>& pose = slots.poses[node.slot];
    return NodeTraits<A>::highest(node.a, to_inner(pose, p), inner_ball(ball, pose.translation, PoseOrigin::run_time),
                                  slots);
  }
  static constexpr Certificate<S> certificate(const Node& node, Reach<S> reach) {
    const S d = ScalarTraits<S>::domain();
    const Reach<S> inner = inner_reach(reach, Vector3<S>{d, d, d});
    Certificate<S> placed =
        placed_certificate(NodeTraits<A>::certificate(node.a, inner), A::kind, inner, PoseOrigin::run_time);
    placed.valid = placed.valid && node.slot < kSlotLimit;
    return placed;
  }
  static constexpr uint32_t slot_count(const Node& node) {
    return greatest_of_two(node.slot < kSlotLimit ? node.slot + 1 : kSlotLimit, NodeTraits<A>::slot_count(node.a));
  }
};

constexpr NodeList<> list() { return {}; }
template <class First, class... Rest> constexpr NodeList<First, Rest...> list(const First& first, const Rest&... rest) {
  return {first, list(rest...)};
}

template <class T> struct SameType { using type = T; };
template <class T> using NotDeduced = typename SameType<T>::type;

}  // namespace detail

// Any operation with its operands, in order. One with a table takes it first; the table must outlive the field.
template <class T, class... Operand> constexpr auto combine(const T& operation, const Operand&... operand) {
  static_assert(((Operand::kind == detail::operand_kind_of<T>) && ...), "an operand is of the wrong kind");
  static_assert(!detail::uses_table<T>, "this operation needs a table");
  static_assert(detail::operand_count_of<T> == kAnyNumber || detail::operand_count_of<T> == static_cast<int>(sizeof...(Operand)),
                "not the number of operands that the operation takes");
  return Combined<T, TableView<typename T::Scalar>, Operand...>{operation, {}, {}, detail::list(operand...)};
}
template <class T, class S, int segments, int degree, int bits, class... Operand>
constexpr auto combine(const T& operation, const Table<S, segments, degree, bits>& table, const Operand&... operand) {
  static_assert(((Operand::kind == detail::operand_kind_of<T>) && ...), "an operand is of the wrong kind");
  static_assert(detail::uses_table<T>, "this operation has no table");
  static_assert(detail::operand_count_of<T> == kAnyNumber || detail::operand_count_of<T> == static_cast<int>(sizeof...(Operand)),
                "not the number of operands that the operation takes");
  return Combined<T, TableView<S, degree, bits>, Operand...>{operation, table.view(), table.facts, detail::list(operand...)};
}
// A temporary table would be gone before the field is asked.
template <class T, class S, int segments, int degree, int bits, class... Operand>
constexpr auto combine(const T&, const Table<S, segments, degree, bits>&&, const Operand&...) = delete;

// Sharp set operations on distances.
template <class A, class B> constexpr auto unite(const A& a, const B& b) {
  return combine(SharpUnion<typename A::Scalar>{}, a, b);
}
template <class A, class B> constexpr auto intersect(const A& a, const B& b) {
  return combine(SharpIntersection<typename A::Scalar>{}, a, b);
}
template <class A, class B> constexpr auto subtract(const A& a, const B& b) {
  return combine(SharpSubtraction<typename A::Scalar>{}, a, b);
}

namespace detail {

template <template <class> class Blend, class S, int segments, int degree, int bits, class A, class B>
constexpr auto additive(const Table<S, segments, degree, bits>& kernel, S length, const A& a, const B& b) {
  Blend<S> blend;
  blend.scale = ArgumentScale<S>::of(narrow<S>(product(length, kernel.range)));
  return combine(blend, kernel, a, b);
}

}  // namespace detail

// Additive blends. `kernel` is a table baked from one of curve/kernel.hpp, which must outlive the field; `length`, metres,
// is what it is scaled with: delta of Li's exterior blend, epsilon of his interior one, the range of a polynomial, and of
// log-sum-exp the range as well. Several operands are blended one after the other, in the order given (Li, section 4).
template <class S, int segments, int degree, int bits, class A, class B>
constexpr auto unite(const Table<S, segments, degree, bits>& kernel, detail::NotDeduced<S> length, const A& a, const B& b) {
  return detail::additive<AdditiveUnion>(kernel, length, a, b);
}
template <class S, int segments, int degree, int bits, class A, class B, class... More>
constexpr auto unite(const Table<S, segments, degree, bits>& kernel, detail::NotDeduced<S> length, const A& a, const B& b,
                     const More&... more) {
  return unite(kernel, length, unite(kernel, length, a, b), more...);
}
template <class S, int segments, int degree, int bits, class A, class B>
constexpr auto intersect(const Table<S, segments, degree, bits>& kernel, detail::NotDeduced<S> length, const A& a, const B& b) {
  return detail::additive<AdditiveIntersection>(kernel, length, a, b);
}
template <class S, int segments, int degree, int bits, class A, class B>
constexpr auto subtract(const Table<S, segments, degree, bits>& kernel, detail::NotDeduced<S> length, const A& a, const B& b) {
  return detail::additive<AdditiveSubtraction>(kernel, length, a, b);
}
template <class S, int segments, int degree, int bits, class A, class... More>
constexpr auto unite(const Table<S, segments, degree, bits>&&, detail::NotDeduced<S>, const A&, const More&...) = delete;
template <class S, int segments, int degree, int bits, class A, class B>
constexpr auto intersect(const Table<S, segments, degree, bits>&&, detail::NotDeduced<S>, const A&, const B&) = delete;
template <class S, int segments, int degree, int bits, class A, class B>
constexpr auto subtract(const Table<S, segments, degree, bits>&&, detail::NotDeduced<S>, const A&, const B&) = delete;

// A soft skeleton with its potential, a table over the squared distance that must outlive the field.
template <class Shape, class S, int segments>
constexpr auto with_potential(const Shape& shape, const Table<S, segments>& table) {
  return combine(shape, table);
}
template <class Shape, class S, int segments>
constexpr auto with_potential(const Shape&, const Table<S, segments>&&) = delete;
// F = sum of all operands' intensities.
template <class A, class B> constexpr auto soft_sum(const A& a, const B& b) {
  return combine(SoftSum<typename A::Scalar>{}, a, b);
}
template <class A, class B, class... More> constexpr auto soft_sum(const A& a, const B& b, const More&... more) {
  return soft_sum(soft_sum(a, b), more...);
}

// The same field elsewhere: at a fixed pose, or at the pose number `slot` of those passed with each query.
template <class A> constexpr Placed<A> place(const Pose<typename A::Scalar>& pose, const A& a) { return {pose, a}; }
template <class A> constexpr InSlot<A> in_slot(uint32_t slot, const A& a) { return {slot, a}; }

// The same field `factor` times as large about the local origin; a frame of that size is a scale within a pose.
template <class A> constexpr Scaled<A> scaled(detail::NotDeduced<typename A::Scalar> factor, const A& a) {
  return {UniformScale<typename A::Scalar>(factor), a};
}

// The distance that an algebraic field gives within the box |x| <= half.x ... about the local origin: see DeclaredBox.
template <class A> constexpr InBox<A> in_box(const Vector3<typename A::Scalar>& half, const A& a) {
  static_assert(A::kind == Kind::algebraic, "an operand is of the wrong kind");
  using S = typename A::Scalar;
  DeclaredBox<S> box;
  box.half = half;
  return {DeclaredBox<S>(half, detail::NodeTraits<A>::certificate(a, box.reach()).lipschitz), a};
}

// A composition that has been checked once: what queries accept. An invalid one (parameters out of range) exists, but
// every query to it answers `invalid`; static_assert(field.valid()) makes it an error of compilation.
template <class Node> class Field {
 public:
  using Scalar = typename Node::Scalar;

  constexpr explicit Field(const Node& node)
      : node_(node), certificate_(certify(node)), slot_count_(detail::NodeTraits<Node>::slot_count(node)),
        parameter_count_(detail::NodeTraits<Node>::parameter_count(node)) {}

  constexpr bool valid() const { return certificate_.valid; }
  static constexpr Kind kind() { return Node::kind; }
  constexpr const Certificate<Scalar>& certificate() const { return certificate_; }
  // Worst-case instructions of a value, and of a clearance with all that it checks. Measured of Fixed<27>; of
  // other scalars 100,000,000.
  constexpr Budget budget(const Target& target = kThisTarget) const {
    return detail::budget_in<Scalar>(target.query_cost(slot_count_, parameter_count_) +
                                     detail::NodeTraits<Node>::budget(node_, target));
  }
  constexpr uint32_t slot_count() const { return slot_count_; }
  constexpr uint32_t parameter_count() const { return parameter_count_; }

  template <class Out> constexpr Out evaluate(const Vector3<Scalar>& p, const Slots<Scalar>& slots) const {
    return detail::NodeTraits<Node>::template evaluate<Out>(node_, p, slots);
  }

  // Of an intensity: whether highest() tells anything.
  static constexpr bool has_highest() { return kind() == Kind::intensity && detail::NodeTraits<Node>::has_highest; }
  // Nowhere within `radius` metres of p is the intensity greater than this and certificate().error together.
  constexpr Highest<Scalar> highest(const Vector3<Scalar>& p, Scalar radius, const Slots<Scalar>& slots) const {
    return detail::NodeTraits<Node>::highest(node_, p, Ball<Scalar>{radius, domain_reach<Scalar>().radius}, slots);
  }

 private:
  static constexpr Certificate<Scalar> certify(const Node& node) {
    return detail::NodeTraits<Node>::certificate(node, domain_reach<Scalar>());
  }

  Node node_;
  Certificate<Scalar> certificate_;
  uint32_t slot_count_;
  uint32_t parameter_count_;
};

template <class Node> constexpr Field<Node> field(const Node& node) { return Field<Node>(node); }

}  // namespace nearfield
