// Weights of I-patches (blend/patch.hpp), chosen from what the patch is to pass through. In `double`, for baking: never
// linked into a target.
#pragma once

namespace nearfield {

// valid is false where the weight has no effect (a point on the bounds); the weight is 0 then.
struct PatchWeight {
  double value = 0.0;
  bool valid = false;
};

// Of a patch at one point: the operands' values there, `primaries` the ribbons' P or the corners' C.
struct PatchSample {
  const double* primaries = nullptr;
  const double* bounds = nullptr;
};

namespace detail {

constexpr double reciprocal_power(double bound, int exponent) {
  const double size = bound < 0.0 ? -bound : bound;
  double power = 1.0;
  for (int i = 0; i < exponent; ++i) power *= size;
  return 1.0 / power;
}
constexpr bool off_the_bounds(const double* bounds, int side_count) {
  for (int i = 0; i < side_count; ++i) {
    if (!(bounds[i] < 0.0 || bounds[i] > 0.0)) return false;
  }
  return true;
}

// The patch with a centre's weight w is (without + w) / normaliser.
struct PatchTerms {
  double without = 0.0;
  double normaliser = 0.0;
};
constexpr PatchTerms ribbon_terms(int side_count, int exponent, const double* weights, const PatchSample& at) {
  PatchTerms terms;
  for (int i = 0; i < side_count; ++i) {
    const double s = reciprocal_power(at.bounds[i], exponent);
    terms.without += weights[i] * at.primaries[i] * s;
    terms.normaliser += s;
  }
  return terms;
}
constexpr PatchTerms corner_terms(int side_count, int exponent, const double* weights, const PatchSample& at) {
  PatchTerms terms;
  for (int k = 0; k < side_count; ++k) {
    const double s = reciprocal_power(at.bounds[k], exponent);
    const double both = s * reciprocal_power(at.bounds[k + 1 < side_count ? k + 1 : 0], exponent);
    terms.without += at.primaries[k] * both + weights[k] * s;
    terms.normaliser += both;
  }
  return terms;
}

// Least squares over the samples that lie off the bounds.
template <class Terms>
constexpr PatchWeight centred_weight(Terms terms_of, int side_count, int exponent, const double* weights,
                                     const PatchSample* samples, int sample_count) {
  double products = 0.0, squares = 0.0;
  for (int i = 0; i < sample_count; ++i) {
    if (!off_the_bounds(samples[i].bounds, side_count)) continue;
    const PatchTerms terms = terms_of(side_count, exponent, weights, samples[i]);
    const double effect = 1.0 / terms.normaliser;
    products += terms.without * effect * effect;
    squares += effect * effect;
  }
  if (!(squares > 0.0)) return {};
  return {-products / squares, true};
}

}  // namespace detail

// The centre's weight w of a patch whose other weights are given. One sample: the patch passes through its point.
// Several: it is centred among them, the sum of the squares of its values there is least. side_count values each.
constexpr PatchWeight ribbon_centre_weight(int side_count, int exponent, const double* weights,
                                           const PatchSample* samples, int sample_count) {
  return detail::centred_weight(detail::ribbon_terms, side_count, exponent, weights, samples, sample_count);
}
constexpr PatchWeight corner_centre_weight(int side_count, int exponent, const double* weights,
                                           const PatchSample* samples, int sample_count) {
  return detail::centred_weight(detail::corner_terms, side_count, exponent, weights, samples, sample_count);
}

// The weight w_k of a corner patch's side that leads it through a point on that side: the values there of the corners
// before and after it, and of the bounds of the sides before and after it.
constexpr PatchWeight side_weight(int exponent, double corner_before, double corner_after, double bound_before,
                                  double bound_after) {
  const double bounds[2] = {bound_before, bound_after};
  if (!detail::off_the_bounds(bounds, 2)) return {};
  return {-(corner_before * detail::reciprocal_power(bound_before, exponent) +
            corner_after * detail::reciprocal_power(bound_after, exponent)), true};
}

}  // namespace nearfield
