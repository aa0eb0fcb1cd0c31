// Every curve, one line each: the host's commands, scenes and tests go through these lists.
// Exact forms in `double`, for baking: never linked into a target.
#pragma once

#include <nearfield/curve/parametric_bezier.hpp>
#include <nearfield/curve/potential_spline.hpp>
#include <nearfield/curve/range_control.hpp>
#include <nearfield/curve/step.hpp>

#define NEARFIELD_STEP_CURVES(X) \
  X(step::Heaviside)             \
  X(step::Polynomial)            \
  X(step::BSplineIntegral)       \
  X(step::RisingCutoff)          \
  X(step::RisingCutoffSquared)   \
  X(step::CutoffFromPolynomial)  \
  X(step::Logistic)

#define NEARFIELD_POTENTIAL_CURVES(X)  \
  X(potential::Cubic)                  \
  X(potential::Wyvill)                 \
  X(potential::NaturalSpline)          \
  X(potential::Bezier)                 \
  X(potential::BSpline)                \
  X(potential::Arctangent)             \
  X(potential::ArctangentClamped)      \
  X(potential::ParametricBezier)       \
  X(potential::ParametricBezierPoints) \
  X(potential::Blanc)
