// Every exact curve of the core by name, with parameters that are known only when the program runs.
#pragma once

#include <functional>
#include <string_view>
#include <vector>

#include <nearfield/curve/curve.hpp>

namespace nearfield::host {

enum class CurveFamily { step, potential };

// A curve of any type, with parameters chosen at run time. Itself a curve: see nearfield/curve/curve.hpp.
class AnyCurve {
 public:
  template <class Curve>
  explicit AnyCurve(const Curve& curve)
      : evaluate_([curve](const Differentiable& x) { return curve(x); }),
        problem_(curve_problem(curve)),
        // What is wrong may be what its facts would be computed from.
        facts_(problem_ == nullptr ? curve_facts(curve) : CurveFacts{}),
        points_(problem_ == nullptr ? control_points_of(curve) : ControlPoints{}) {}

  Differentiable operator()(const Differentiable& x) const { return evaluate_(x); }
  CurveFacts facts() const { return facts_; }
  const char* problem() const { return problem_; }
  ControlPoints control_points() const { return points_; }

 private:
  std::function<Differentiable(const Differentiable&)> evaluate_;
  const char* problem_;
  CurveFacts facts_;
  ControlPoints points_;
};

// One curve of the lists of nearfield/curve/curves.hpp.
struct CatalogueEntry {
  std::string_view name;
  CurveFamily family;
  std::vector<CurveParameter> parameters;
  // From one ParameterValues for each of `parameters`, in their order.
  std::function<AnyCurve(const std::vector<ParameterValues>&)> make;
};

// Steps first, each family in the order of its list.
const std::vector<CatalogueEntry>& curve_catalogue();

// The entry of that name, or null. Pointers stay valid for the whole program.
const CatalogueEntry* find_curve(std::string_view name);

// The values that a curve has when nothing is said.
std::vector<ParameterValues> initial_values(const CatalogueEntry& entry);

}  // namespace nearfield::host
