#include <nearfield/nearfield.hpp>

namespace nf = nearfield;
using Q = nf::Fixed<27>;  // metres: -16 to 16, in steps of 7.5 nm

// Li's smooth union as a table in flash, made by the compiler: H_3, epsilon / delta = 0.25.
constexpr auto kRounding = nf::bake<Q>(nf::exterior(nf::step::polynomial<3>, 0.25));

// A table and a post on it, blended over delta = 5 cm.
constexpr auto kCell = nf::field(nf::unite(kRounding, 0.05,
    nf::Box<Q>{{0.0, 0.0, -0.05}, {0.8, 0.6, 0.05}},             // centre, half edges
    nf::Capsule<Q>{{0.3, 0.2, 0.0}, {0.3, 0.2, 0.5}, 0.04}));    // both ends, radius

static_assert(kCell.valid());                                    // parameters and ranges were checked
static_assert(kCell.certificate().lipschitz < nf::Rate(1.01));
static_assert(kCell.certificate().error < Q(0.0000002));         // metres: table and all roundings
static_assert(kCell.budget().gradient < 900);                    // instructions a query, Cortex-M4

constexpr nf::SpeedRamp<Q> kRamp(0.02, 0.2);                     // metres: stop below, free from

inline Q allowed_speed(const nf::Vector3<Q>& tool) {             // 0 ... 1; every millisecond
  const nf::Clearance<Q> c = nf::clearance(kCell, tool);         // status, distance, direction (away)
  return kRamp.override_for(c);                                  // anything but clear stops
}
