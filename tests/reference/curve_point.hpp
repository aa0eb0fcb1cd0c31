#pragma once
/// A function of one variable together with its first two derivatives, and the polynomials the curves are
/// made of.

#include "vector.hpp"

#include <array>
#include <cstddef>
#include <stdexcept>
#include <vector>

namespace nearfield::reference {

/// Value, first and second derivative of a function of one variable, with respect to that variable.
struct CurvePoint {
  Real value{};
  Real first{};
  Real second{};
};

/// Chain rule: `outer` is taken at `inner.value`, with derivatives with respect to it.
inline CurvePoint compose(const CurvePoint& outer, const CurvePoint& inner) {
  return {outer.value, outer.first * inner.first,
          outer.second * inner.first * inner.first + outer.first * inner.second};
}

/// `outer` at the squared variable: p(r²) and its derivatives with respect to r.
inline CurvePoint compose_with_square(const CurvePoint& outer, Real r) {
  return compose(outer, {r * r, 2 * r, 2});
}

constexpr std::size_t greatest_degree = 9;

/// Polynomial of degree up to nine: coefficients[k] belongs to the k-th power.
struct PowerPolynomial {
  std::array<Real, greatest_degree + 1> coefficients{};
  std::size_t degree = 0;

  CurvePoint operator()(Real x) const {
    Real value = coefficients[degree];
    Real first = 0;
    Real half_second = 0;
    for (std::size_t k = degree; k-- > 0;) {
      half_second = half_second * x + first;
      first = first * x + value;
      value = value * x + coefficients[k];
    }
    return {value, first, 2 * half_second};
  }
};

/// (constant + slope x) · p(x); one degree higher than p, which is at most of degree eight.
inline PowerPolynomial linear_times(Real constant, Real slope, const PowerPolynomial& p) {
  PowerPolynomial product;
  product.degree = p.degree + 1;
  for (std::size_t k = 0; k <= p.degree; ++k) {
    product.coefficients[k] += constant * p.coefficients[k];
    product.coefficients[k + 1] += slope * p.coefficients[k];
  }
  return product;
}

inline PowerPolynomial operator+(const PowerPolynomial& a, const PowerPolynomial& b) {
  PowerPolynomial sum = a.degree >= b.degree ? a : b;
  const PowerPolynomial& other = a.degree >= b.degree ? b : a;
  for (std::size_t k = 0; k <= other.degree; ++k) sum.coefficients[k] += other.coefficients[k];
  return sum;
}

/// Σ bⱼ Bⱼⁿ(x) on [0, 1] and its derivatives, n! / (n − k)! Σ Δᵏbⱼ Bⱼⁿ⁻ᵏ(x) (KW). n = 1…9 is the number of
/// ordinates less one; any other number: std::invalid_argument.
class BernsteinPolynomial {
 public:
  explicit BernsteinPolynomial(const std::vector<Real>& ordinates) {
    if (ordinates.size() < 2 || ordinates.size() > greatest_degree + 1) {
      throw std::invalid_argument("Bernstein polynomial: degree is 1 to 9");
    }
    degree_ = ordinates.size() - 1;
    std::array<Real, greatest_degree + 1> differences{};
    for (std::size_t j = 0; j <= degree_; ++j) differences[j] = ordinates[j];
    Real scale = 1;
    for (std::size_t order = 0; order < 3 && order <= degree_; ++order) {
      const std::size_t reduced = degree_ - order;
      Real binomial = scale;
      for (std::size_t j = 0; j <= reduced; ++j) {
        weights_[0][order][j] = binomial * differences[j];
        weights_[1][order][reduced - j] = binomial * differences[j];
        binomial = binomial * static_cast<Real>(reduced - j) / static_cast<Real>(j + 1);
      }
      for (std::size_t j = 0; j < reduced; ++j) differences[j] = differences[j + 1] - differences[j];
      scale *= static_cast<Real>(reduced);
    }
  }

  CurvePoint operator()(Real x) const {
    const bool mirrored = x > 0.5L;
    const Real larger = mirrored ? x : 1 - x;
    const Real ratio = (mirrored ? 1 - x : x) / larger;
    const Weights& weights = weights_[mirrored ? 1 : 0];
    std::array<Real, 3> sums{weights[0][degree_], 0, 0};
    for (std::size_t j = degree_; j-- > 0;) {
      sums = {sums[0] * ratio + weights[0][j], sums[1] * ratio + weights[1][j],
              sums[2] * ratio + weights[2][j]};
    }
    Real power = 1;
    for (std::size_t k = 2; k < degree_; ++k) power *= larger;
    if (degree_ == 1) return {larger * sums[0], sums[1], 0};
    return {power * larger * larger * sums[0], power * larger * sums[1], power * sums[2]};
  }

 private:
  /// For the value and both derivatives: the ordinates times their binomial coefficients, then zeros.
  using Weights = std::array<std::array<Real, greatest_degree + 1>, 3>;

  /// In ascending order, and in descending order for the nearer end at 1.
  std::array<Weights, 2> weights_{};
  std::size_t degree_ = 0;
};

}  // namespace nearfield::reference
