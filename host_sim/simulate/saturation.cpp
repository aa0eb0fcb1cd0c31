#include "simulate/saturation.hpp"

#include <cmath>

#include <nearfield/field/program.hpp>
#include <nearfield/shape/algebraic_bounds.hpp>

namespace nearfield::host {
namespace {

enum class Watched { no, product, ribbons, corners };

Watched what_is(const FieldNode& node) {
  const std::string_view name = node.operator_->name;
  if (name == "functional_spline" || name == "liming") return Watched::product;
  if (name == "ribbon_patch") return Watched::ribbons;
  return name == "corner_patch" ? Watched::corners : Watched::no;
}

bool is_frame(const FieldNode& node) { return node.operator_->any_kind && node.operands.size() == 1; }

// A result that stays at the end of the range once it has reached it.
class Saturating {
 public:
  explicit Saturating(double limit) : limit_(limit) {}
  double take(double value) {
    reached = reached || !(std::abs(value) < limit_);
    return value;
  }
  double product(const std::vector<double>& factors, std::size_t first, std::size_t last) {
    double all = factors[first];
    for (std::size_t i = first + 1; i < last; ++i) all = take(all * factors[i]);
    return all;
  }
  bool reached = false;

 private:
  double limit_;
};

// As nearfield/blend/liming.hpp evaluates it.
void take_spline(Saturating& numbers, const FieldNode& blend, const std::vector<double>& operands) {
  const bool is_liming = blend.operator_->name == "liming";
  const std::size_t primaries = is_liming ? 2 : static_cast<std::size_t>(blend.number("primaries"));
  const int exponent = is_liming ? 2 : static_cast<int>(blend.number("exponent"));
  const double lambda = blend.number("lambda");
  const double of_primaries = numbers.product(operands, 0, primaries);
  const double bound = numbers.product(operands, primaries, operands.size());
  double of_bounds = bound;
  for (int i = 1; i < exponent; ++i) of_bounds = numbers.take(of_bounds * bound);
  const double first = numbers.take((1.0 - lambda) * of_primaries), second = numbers.take(lambda * of_bounds);
  numbers.take(first + second);
}

// A node below the frames around it, and nothing else.
FieldNode framed(const FieldNode& node, const std::vector<const FieldNode*>& frames) {
  FieldNode result = node;
  for (std::size_t i = frames.size(); i > 0; --i) {
    FieldNode frame = *frames[i - 1];
    frame.operands = {result};
    frame.kind = node.kind;
    result = frame;
  }
  return result;
}

}  // namespace

bool saturates(const FieldNode& blend, const std::vector<double>& operands, double limit) {
  Saturating numbers(limit);
  for (const double operand : operands) numbers.take(operand);
  const Watched watched = what_is(blend);
  if (watched == Watched::product) take_spline(numbers, blend, operands);
  if (watched == Watched::ribbons) {
    const std::vector<double>& weights = blend.parameters.at("side_weights");
    for (std::size_t i = 0; i < weights.size(); ++i) numbers.take(weights[i] * operands[2 * i]);
  }
  return numbers.reached;
}

template <class S>
SaturationWatch<S>::SaturationWatch(const FieldNode& root, const std::string& file,
                                    const SlotOfLink& slot_of_link) {
  watch(root, file, slot_of_link);
}

template <class S>
void SaturationWatch<S>::watch(const FieldNode& node, const std::string& file,
                               const SlotOfLink& slot_of_link) {
  if (node.operator_->name == "declared_box") return;
  if (is_frame(node)) frames_.push_back(&node);
  if (what_is(node) != Watched::no) {
    Blend blend{&node, {}};
    for (const FieldNode& operand : node.operands) {
      blend.operands.push_back(compile_field<S>(framed(operand, frames_), file, slot_of_link));
    }
    blends_.push_back(std::move(blend));
  }
  for (const FieldNode& operand : node.operands) watch(operand, file, slot_of_link);
  if (is_frame(node)) frames_.pop_back();
}

template <class S>
bool SaturationWatch<S>::saturated(const Sample<S>& sample, const nearfield::Vector3<S>& p,
                                   const nearfield::Slots<S>& slots) const {
  const auto real = [](S number) { return ScalarTraits<S>::to_double(number); };
  // A little before the end, since products are taken in double here.
  const double limit = real(algebraic_limit<S>()) * (1.0 - std::ldexp(1.0, -20));
  for (const S number : {sample.value, sample.gradient.x, sample.gradient.y, sample.gradient.z}) {
    if (!(std::abs(real(number)) < limit)) return true;
  }
  for (const Blend& blend : blends_) {
    std::vector<double> values;
    for (const CompiledField<S>& operand : blend.operands) {
      const Program<S> program(operand.image.data(), operand.inspection);
      values.push_back(real(program.template evaluate<Value<S>>(p, slots).value));
    }
    if (saturates(*blend.node, values, limit)) return true;
  }
  return false;
}

template class SaturationWatch<Fixed<27>>;
template class SaturationWatch<Fixed<24>>;
template class SaturationWatch<Fixed<16>>;
template class SaturationWatch<float>;

}  // namespace nearfield::host
