// Where an algebraic field's value is not its own, because a number on the way to it left the number range.
#pragma once

#include <string>
#include <vector>

#include "compile/field_compiler.hpp"

namespace nearfield::host {

// Whether a functional spline, Liming's blend or an I-patch of these operands' values saturates, the operands
// included; numbers saturate at plus and minus `limit`.
bool saturates(const FieldNode& blend, const std::vector<double>& operands, double limit);

// A field's products and patches, of which the value does not tell that they saturated. Those in declared
// boxes are left out: their certificate says that they do not.
template <class S>
class SaturationWatch {
 public:
  // `root` must outlive this. InputError as compile_field().
  SaturationWatch(const FieldNode& root, const std::string& file, const SlotOfLink& slot_of_link);

  // Whether any of them does at p, or `sample`, the field's there, has a number at the end of the range.
  // Preconditions as Program::evaluate().
  bool saturated(const Sample<S>& sample, const nearfield::Vector3<S>& p,
                 const nearfield::Slots<S>& slots) const;

 private:
  struct Blend {
    const FieldNode* node;
    std::vector<CompiledField<S>> operands;
  };
  void watch(const FieldNode& node, const std::string& file, const SlotOfLink& slot_of_link);

  std::vector<const FieldNode*> frames_;  // around the node that is being looked at, from the outermost on
  std::vector<Blend> blends_;
};

}  // namespace nearfield::host
