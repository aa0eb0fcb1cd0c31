// Static composition: fields as C++ values, built from shapes and blends, inlined by the compiler.
#pragma once

#include <nearfield/field/budget.hpp>

namespace nearfield {

// Composite nodes. Leaves are the shapes themselves.
template <class Shape> struct WithTable {
  using Scalar = typename Shape::Scalar;
  static constexpr Kind kind = Shape::kind;
  Shape shape;
  TableView<Scalar> table;
};
template <class Blend, class A, class B> struct Blended {
  using Scalar = typename Blend::Scalar;
  static constexpr Kind kind = Blend::kind;
  Blend blend;
  A a;
  B b;
  TableView<Scalar> table;
  TableFacts facts;
};
template <class A> struct Placed {
  using Scalar = typename A::Scalar;
  static constexpr Kind kind = A::kind;
  Pose<Scalar> pose;
  A a;
};
template <class A> struct InSlot {
  using Scalar = typename A::Scalar;
  static constexpr Kind kind = A::kind;
  uint32_t slot;
  A a;
};

namespace detail {

// One meaning of each node for evaluation, certificate, budget and slots: the recursion over the node's type.
template <class Shape> struct NodeTraits {
  using S = typename Shape::Scalar;
  template <class Out> static constexpr Out evaluate(const Shape& shape, const Vector3<S>& p, const Pose<S>*) {
    return shape.template evaluate<Out>(p);
  }
  static constexpr Certificate<S> certificate(const Shape& shape, Reach<S> reach) { return shape.certificate(reach); }
  static constexpr Budget budget(const Shape&) { return cortex_m4_cost(OperationOf<Shape>::value); }
  static constexpr uint32_t slot_count(const Shape&) { return 0; }
};

template <class Shape> struct NodeTraits<WithTable<Shape>> {
  using Node = WithTable<Shape>;
  using S = typename Node::Scalar;
  template <class Out> static constexpr Out evaluate(const Node& node, const Vector3<S>& p, const Pose<S>*) {
    return node.shape.template evaluate<Out>(p, node.table);
  }
  static constexpr Certificate<S> certificate(const Node& node, Reach<S> reach) { return node.shape.certificate(reach); }
  static constexpr Budget budget(const Node&) { return cortex_m4_cost(OperationOf<Shape>::value); }
  static constexpr uint32_t slot_count(const Node&) { return 0; }
};

template <class Blend, class A, class B> struct NodeTraits<Blended<Blend, A, B>> {
  using Node = Blended<Blend, A, B>;
  using S = typename Node::Scalar;
  template <class Out> static constexpr Out evaluate(const Node& node, const Vector3<S>& p, const Pose<S>* slots) {
    const Out a = NodeTraits<A>::template evaluate<Out>(node.a, p, slots);
    const Out b = NodeTraits<B>::template evaluate<Out>(node.b, p, slots);
    if constexpr (OperationOf<Blend>::uses_table) return node.blend.combine(a, b, node.table);
    else return node.blend.combine(a, b);
  }
  static constexpr Certificate<S> certificate(const Node& node, Reach<S> reach) {
    const Certificate<S> a = NodeTraits<A>::certificate(node.a, reach), b = NodeTraits<B>::certificate(node.b, reach);
    if constexpr (OperationOf<Blend>::uses_table) return node.blend.certificate(a, b, node.facts, reach.radius);
    else return node.blend.certificate(a, b);
  }
  static constexpr Budget budget(const Node& node) {
    return NodeTraits<A>::budget(node.a) + NodeTraits<B>::budget(node.b) + cortex_m4_cost(OperationOf<Blend>::value);
  }
  static constexpr uint32_t slot_count(const Node& node) {
    return greatest_of_two(NodeTraits<A>::slot_count(node.a), NodeTraits<B>::slot_count(node.b));
  }
};

template <class A> struct NodeTraits<Placed<A>> {
  using Node = Placed<A>;
  using S = typename Node::Scalar;
  template <class Out> static constexpr Out evaluate(const Node& node, const Vector3<S>& p, const Pose<S>* slots) {
    Out out = NodeTraits<A>::template evaluate<Out>(node.a, to_inner(node.pose, p), slots);
    if constexpr (Out::has_gradient) out.gradient = rotate(node.pose.rotation, out.gradient);
    return out;
  }
  static constexpr Certificate<S> certificate(const Node& node, Reach<S> reach) {
    const Reach<S> inner = inner_reach(reach, node.pose.translation);
    Certificate<S> placed = placed_certificate(NodeTraits<A>::certificate(node.a, inner), inner, PoseOrigin::constant);
    placed.valid = placed.valid && valid_pose(node.pose);
    return placed;
  }
  static constexpr Budget budget(const Node& node) {
    return NodeTraits<A>::budget(node.a) + cortex_m4_cost(Operation::enter_pose) + cortex_m4_cost(Operation::leave);
  }
  static constexpr uint32_t slot_count(const Node& node) { return NodeTraits<A>::slot_count(node.a); }
};

template <class A> struct NodeTraits<InSlot<A>> {
  using Node = InSlot<A>;
  using S = typename Node::Scalar;
  template <class Out> static constexpr Out evaluate(const Node& node, const Vector3<S>& p, const Pose<S>* slots) {
    const Pose<S>& pose = slots[node.slot];
    Out out = NodeTraits<A>::template evaluate<Out>(node.a, to_inner(pose, p), slots);
    if constexpr (Out::has_gradient) out.gradient = rotate(pose.rotation, out.gradient);
    return out;
  }
  static constexpr Certificate<S> certificate(const Node& node, Reach<S> reach) {
    const S d = ScalarTraits<S>::domain();
    const Reach<S> inner = inner_reach(reach, Vector3<S>{d, d, d});
    Certificate<S> placed = placed_certificate(NodeTraits<A>::certificate(node.a, inner), inner, PoseOrigin::run_time);
    placed.valid = placed.valid && node.slot < kSlotLimit;
    return placed;
  }
  static constexpr Budget budget(const Node& node) {
    return NodeTraits<A>::budget(node.a) + cortex_m4_cost(Operation::enter_slot) + cortex_m4_cost(Operation::leave);
  }
  static constexpr uint32_t slot_count(const Node& node) {
    return greatest_of_two(node.slot < kSlotLimit ? node.slot + 1 : kSlotLimit, NodeTraits<A>::slot_count(node.a));
  }
};

template <class Blend, class A, class B> constexpr Blended<Blend, A, B> blended(const Blend& blend, const A& a, const B& b) {
  static_assert(A::kind == Blend::kind && B::kind == Blend::kind, "a blend's operands must be of its own kind");
  return {blend, a, b, {}, {}};
}

}  // namespace detail

// Sharp set operations on distances.
template <class A, class B> constexpr auto unite(const A& a, const B& b) {
  return detail::blended(SharpUnion<typename A::Scalar>{}, a, b);
}
template <class A, class B> constexpr auto intersect(const A& a, const B& b) {
  return detail::blended(SharpIntersection<typename A::Scalar>{}, a, b);
}
template <class A, class B> constexpr auto subtract(const A& a, const B& b) {
  return detail::blended(SharpSubtraction<typename A::Scalar>{}, a, b);
}

namespace detail {

template <template <class> class Blend, class S, int K, class A, class B>
constexpr auto exterior_blended(const Table<S, K>& kernel, S blend_radius, const A& a, const B& b) {
  Blend<S> blend;
  blend.scale = ArgumentScale<S>::of(narrow<S>(product(blend_radius, kernel.range)));
  auto node = blended(blend, a, b);
  node.table = kernel.view();
  node.facts = kernel.facts;
  return node;
}

template <class T> struct SameType { using type = T; };
template <class T> using NotDeduced = typename SameType<T>::type;

}  // namespace detail

// Li's exterior blends. `kernel` is a table baked from exterior(), which must outlive the field; `blend_radius` is
// Li's delta in metres: operands closer than delta + epsilon in value are blended. Several operands are blended one
// after the other, in the order given (Li, section 4).
template <class S, int K, class A, class B>
constexpr auto unite(const Table<S, K>& kernel, detail::NotDeduced<S> blend_radius, const A& a, const B& b) {
  return detail::exterior_blended<ExteriorUnion>(kernel, blend_radius, a, b);
}
template <class S, int K, class A, class B, class... More>
constexpr auto unite(const Table<S, K>& kernel, detail::NotDeduced<S> blend_radius, const A& a, const B& b,
                     const More&... more) {
  return unite(kernel, blend_radius, unite(kernel, blend_radius, a, b), more...);
}
template <class S, int K, class A, class B>
constexpr auto intersect(const Table<S, K>& kernel, detail::NotDeduced<S> blend_radius, const A& a, const B& b) {
  return detail::exterior_blended<ExteriorIntersection>(kernel, blend_radius, a, b);
}
template <class S, int K, class A, class B>
constexpr auto subtract(const Table<S, K>& kernel, detail::NotDeduced<S> blend_radius, const A& a, const B& b) {
  return detail::exterior_blended<ExteriorSubtraction>(kernel, blend_radius, a, b);
}

// A soft skeleton with its potential, a table over the squared distance that must outlive the field.
template <class Shape, class S, int K> constexpr WithTable<Shape> with_potential(const Shape& shape, const Table<S, K>& table) {
  return {shape, table.view()};
}
// F = sum of all operands' intensities.
template <class A, class B> constexpr auto soft_sum(const A& a, const B& b) {
  return detail::blended(SoftSum<typename A::Scalar>{}, a, b);
}
template <class A, class B, class... More> constexpr auto soft_sum(const A& a, const B& b, const More&... more) {
  return soft_sum(soft_sum(a, b), more...);
}

// The same field elsewhere: at a fixed pose, or at the pose number `slot` of those passed with each query.
template <class A> constexpr Placed<A> place(const Pose<typename A::Scalar>& pose, const A& a) { return {pose, a}; }
template <class A> constexpr InSlot<A> in_slot(uint32_t slot, const A& a) { return {slot, a}; }

// A composition that has been checked once: what queries accept. An invalid one (parameters out of range) exists, but
// every query to it answers `invalid`; static_assert(field.valid()) makes it an error of compilation.
template <class Node> class Field {
 public:
  using Scalar = typename Node::Scalar;

  constexpr explicit Field(const Node& node)
      : node_(node), certificate_(certify(node)), slot_count_(detail::NodeTraits<Node>::slot_count(node)),
        budget_(kCortexM4QueryCost + detail::NodeTraits<Node>::budget(node) +
                Budget{0, slot_count_ * kCortexM4PoseCheckCost}) {}

  constexpr bool valid() const { return certificate_.valid; }
  static constexpr Kind kind() { return Node::kind; }
  constexpr const Certificate<Scalar>& certificate() const { return certificate_; }
  constexpr Budget budget() const { return budget_; }
  constexpr uint32_t slot_count() const { return slot_count_; }

  template <class Out> constexpr Out evaluate(const Vector3<Scalar>& p, const Pose<Scalar>* slots) const {
    return detail::NodeTraits<Node>::template evaluate<Out>(node_, p, slots);
  }

 private:
  static constexpr Certificate<Scalar> certify(const Node& node) {
    return detail::NodeTraits<Node>::certificate(node, domain_reach<Scalar>());
  }

  Node node_;
  Certificate<Scalar> certificate_;
  uint32_t slot_count_;
  Budget budget_;
};

template <class Node> constexpr Field<Node> field(const Node& node) { return Field<Node>(node); }

}  // namespace nearfield
