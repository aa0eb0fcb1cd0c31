#include "curves/catalogue.hpp"

#include <iterator>

#include <nearfield/curve/curves.hpp>

namespace nearfield::host {
namespace {

template <class Curve>
auto parameters_of(int) -> decltype(std::vector<CurveParameter>(std::begin(Curve::parameters), std::end(Curve::parameters))) {
  return {std::begin(Curve::parameters), std::end(Curve::parameters)};
}
template <class Curve> std::vector<CurveParameter> parameters_of(long) { return {}; }

template <class Curve> CatalogueEntry entry_of(CurveFamily family) {
  return {Curve::name, family, parameters_of<Curve>(0),
          [](const std::vector<ParameterValues>& values) { return AnyCurve(Curve::from(values.data())); }};
}

}  // namespace

const std::vector<CatalogueEntry>& curve_catalogue() {
  static const std::vector<CatalogueEntry> catalogue{
#define NEARFIELD_ENTRY(Curve) entry_of<Curve>(CurveFamily::step),
      NEARFIELD_STEP_CURVES(NEARFIELD_ENTRY)
#undef NEARFIELD_ENTRY
#define NEARFIELD_ENTRY(Curve) entry_of<Curve>(CurveFamily::potential),
          NEARFIELD_POTENTIAL_CURVES(NEARFIELD_ENTRY)
#undef NEARFIELD_ENTRY
  };
  return catalogue;
}

const CatalogueEntry* find_curve(std::string_view name) {
  for (const CatalogueEntry& entry : curve_catalogue()) {
    if (entry.name == name) return &entry;
  }
  return nullptr;
}

std::vector<ParameterValues> initial_values(const CatalogueEntry& entry) {
  std::vector<ParameterValues> values;
  for (const CurveParameter& parameter : entry.parameters) {
    ParameterValues& value = values.emplace_back();
    value.count = parameter.initial_count;
    for (int i = 0; i < parameter.initial_count; ++i) value.values[i] = parameter.initial[i];
  }
  return values;
}

}  // namespace nearfield::host
