// Compiles: requests like those beside, with parameters that are allowed.
#include <nearfield/nearfield.hpp>

using namespace nearfield;

constexpr ParameterValues points[] = {{4, {0, 0.4, 0.6, 1}}, {4, {1, 0.7, 0.3, 0}}};
constexpr auto spline = potential::NaturalSpline::from(points);
constexpr potential::ParametricBezierPoints parametric{0.6, 1.0, 0.4, 0.0};
constexpr auto range = potential::with_range_control(potential::Cubic{}, 0.5, 0.4);
constexpr potential::Arctangent arctangent{5, 0.5};
constexpr auto own = [](const Differentiable& x) { return 0.5 + 0.5 * sin(2.0 * x); };

static_assert(tabulate<Fixed<27>, spline, Within<12>>().error > 0, "");
static_assert(tabulate<Fixed<27>, parametric, Within<12>>().error > 0, "");
static_assert(tabulate<Fixed<27>, range, Within<12>>().error > 0, "");
static_assert(tabulate<Fixed<27>, arctangent>().error > 0, "");
static_assert(tabulate<Fixed<27>, own, Exactly<3, 4>>().error > 0, "");

using Q = Fixed<27>;
constexpr auto kernel = bake<Q>(exterior(step::polynomial<3>, 0.25));
constexpr auto potential_of_radius = bake<Q, 2>(over_square(potential::wyvill));
const Sphere<Q> ball{{}, Q(0.5)};
const SoftPoint<Q> soft_ball{{}, Influence<Q>(Q(0.5), Q(1.0))};
const AlgebraicPlane<Q> plane{{Q(1.0), {}, {}}, {}};
const auto distances = unite(kernel, Q(0.1), ball, ball);
const auto intensities = soft_sum(with_potential(soft_ball, potential_of_radius), with_potential(soft_ball, potential_of_radius));
const auto boxed = unite(in_box({Q(1.0), Q(1.0), Q(1.0)}, plane), ball);
