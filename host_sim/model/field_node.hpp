#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "curves/curve_settings.hpp"
#include "model/operators.hpp"
#include "model/placement.hpp"
#include "text/source_position.hpp"

namespace nearfield::host {

// One node of a field's tree, checked against its operator's description.
struct FieldNode {
  const OperatorDescription* operator_ = nullptr;  // one of all_operators() once read
  FieldKind kind = FieldKind::distance;            // what it yields
  std::string name;                                // may be empty
  Placement placement;              // in the frame of `link` if given, otherwise of the node above
  std::optional<std::string> link;  // `LINK` of the arm or `person/LINK`
  std::map<std::string, std::vector<double>> parameters;  // every one of the operator, defaults filled in
  std::map<std::string, std::string> choices;             // every one of the operator, defaults filled in;
                                                          // of a curve its name as given
  std::map<std::string, ConfiguredCurve> curves;          // every one of the operator
  std::vector<FieldNode> operands;
  SourcePosition position;
  std::map<std::string, SourcePosition> given;  // where the values of the keys stand that the node has
  std::string path;                             // e.g. `field.operands[2]`

  // A parameter that is one number. std::out_of_range when the operator has none of that key.
  double number(const std::string& key) const { return parameters.at(key).front(); }
  // A parameter that is three numbers. std::out_of_range when the operator has none of that key.
  Vector3d vector(const std::string& key) const {
    const std::vector<double>& numbers = parameters.at(key);
    return {numbers.at(0), numbers.at(1), numbers.at(2)};
  }
  // A parameter that is one or several points.
  std::vector<Vector3d> points(const std::string& key) const {
    const std::vector<double>& numbers = parameters.at(key);
    std::vector<Vector3d> points;
    for (std::size_t i = 0; i + 2 < numbers.size(); i += 3) {
      points.push_back({numbers[i], numbers[i + 1], numbers[i + 2]});
    }
    return points;
  }
  // Where to point at for a key: its value, or the node when it has none.
  SourcePosition place_of(const std::string& key) const {
    const auto found = given.find(key);
    return found != given.end() ? found->second : position;
  }
};

}  // namespace nearfield::host
