#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string_view>
#include <vector>

#include <nearfield/shape/sample.hpp>

#include "curves/catalogue.hpp"
#include "model/json_values.hpp"
#include "text/number.hpp"

namespace nearfield::host {

// What a field's value means.
using FieldKind = nearfield::Kind;

// A parameter whose value must lie between two multiples of another one's.
struct RatioRule {
  std::string_view other_key;
  double lowest = 0.0;
  double highest = 0.0;
};

// What each number of a parameter must be once it is rounded to a number type; see compile/scalar_limits.hpp.
enum class Fit : std::uint8_t {
  any,       // it has no more limits than its range, or its operator checks it with others
  number,    // within the type's domain
  not_zero,  // the same, and not 0
  length,    // the same, and above 0
  edge,      // twice a length
};

struct ParameterDescription {
  std::string_view key;
  std::size_t count = 1;                    // a number when 1, otherwise an array of so many
  NumberRange range;                        // of each number
  std::vector<double> default_values = {};  // empty: the parameter is required
  std::optional<RatioRule> ratio = {};
  bool whole = false;           // whole numbers only
  std::size_t most = 0;         // above 0: an array of `count` to so many numbers
  bool optional = false;        // without a default: no values when it is missing
  std::size_t most_points = 0;  // above 0: an array of `fewest_points` to so many arrays of `count` numbers
  std::size_t fewest_points = 1;
  std::vector<std::string_view> instead_of = {};  // other parameters, which may not be given as well
  Fit fit = Fit::any;
};

// A parameter that is one of several names; the first is the default.
struct ChoiceDescription {
  std::string_view key;
  std::vector<std::string_view> names;
};

// A parameter that is a curve of the catalogue: its name, or an object {"curve": NAME, PARAMETER: VALUE,
// ...}. Potentials may come with a range control beside them, an object {"w1": VALUE, "w2": VALUE}.
struct CurveDescription {
  std::string_view key;
  CurveFamily family = CurveFamily::step;
  std::string_view default_name;
};

// All that a reader needs to know of one kind of field node.
struct OperatorDescription {
  std::string_view name;  // its "type"
  FieldKind kind = FieldKind::distance;
  std::vector<ParameterDescription> parameters = {};
  std::vector<ChoiceDescription> choices = {};
  std::vector<CurveDescription> curves = {};
  std::size_t fewest_operands = 0;
  std::size_t most_operands = 0;  // 0: the key "operands" is not allowed
  FieldKind operand_kind = FieldKind::distance;
  bool any_kind = false;  // operands of any one kind, which is also what it yields
  PlacementParts placement = PlacementParts::none;
  bool takes_link = false;
  bool needs_placement = false;  // a position, an orientation or a link must be given
};

// Every operator there is: what operators/list.hpp lists.
const std::vector<OperatorDescription>& all_operators();

// The operator of that name, or null. Pointers stay valid for the whole program.
const OperatorDescription* find_operator(std::string_view name);

// The names of the operators that can yield a kind.
std::vector<std::string_view> operator_names(FieldKind kind);

}  // namespace nearfield::host
