// Quadrics by name, in `double`: for constants and for the host, never linked into a target. Each is its
// polynomial over `size`, metres; with twice the radius the gradient on the surface is a unit vector (of
// cones: with 1 it is the distance from the apex times the sine of twice the half angle).
#pragma once

#include <nearfield/number/elementary.hpp>
#include <nearfield/shape/algebraic.hpp>

namespace nearfield {

// p^T matrix p + linear . p + constant, the matrix symmetric.
struct RealQuadric {
  double matrix[3][3] = {};
  double linear[3] = {};
  double constant = 0.0;

  // The same surface elsewhere: its local origin at (x, y, z).
  constexpr RealQuadric moved(double x, double y, double z) const {
    const double to[3] = {x, y, z};
    RealQuadric result = *this;
    for (int i = 0; i < 3; ++i) {
      double row = 0.0;
      for (int j = 0; j < 3; ++j) row += matrix[i][j] * to[j];
      result.linear[i] -= 2.0 * row;
      result.constant += (row - linear[i]) * to[i];
    }
    return result;
  }
  // Turned by a rotation: nine numbers, by rows.
  constexpr RealQuadric turned(const double* rotation) const {
    RealQuadric result;
    result.constant = constant;
    for (int i = 0; i < 3; ++i) {
      for (int k = 0; k < 3; ++k) {
        result.linear[i] += rotation[3 * i + k] * linear[k];
        for (int j = 0; j < 3; ++j) {
          for (int l = 0; l < 3; ++l)
            result.matrix[i][j] += rotation[3 * i + k] * matrix[k][l] * rotation[3 * j + l];
        }
      }
    }
    return result;
  }
  // Whether all coefficients are within +-limit: of a scalar's quadric, its domain's number.
  constexpr bool fits(double limit) const {
    bool result = magnitude(constant) <= limit;
    for (int i = 0; i < 3; ++i) {
      result = result && magnitude(linear[i]) <= limit;
      for (int j = 0; j < 3; ++j) result = result && magnitude(matrix[i][j]) <= limit;
    }
    return result;
  }
  template <class S>
  constexpr Quadric<S> rounded() const {
    const auto s = [](double x) { return static_cast<S>(x); };
    return {{s(matrix[0][0]), s(matrix[1][1]), s(matrix[2][2])},
            {s(matrix[1][2]), s(matrix[0][2]), s(matrix[0][1])},
            {s(linear[0]), s(linear[1]), s(linear[2])},
            s(constant)};
  }
};

// (|p|^2 - radius^2) / size.
constexpr RealQuadric algebraic_sphere(double radius, double size) {
  const double k = 1.0 / size;
  return {{{k, 0.0, 0.0}, {0.0, k, 0.0}, {0.0, 0.0, k}}, {}, -radius * radius / size};
}
constexpr RealQuadric algebraic_sphere(double radius) { return algebraic_sphere(radius, 2.0 * radius); }

// (x^2 + y^2 - radius^2) / size: about the z axis.
constexpr RealQuadric algebraic_cylinder(double radius, double size) {
  const double k = 1.0 / size;
  return {{{k, 0.0, 0.0}, {0.0, k, 0.0}, {}}, {}, -radius * radius / size};
}
constexpr RealQuadric algebraic_cylinder(double radius) { return algebraic_cylinder(radius, 2.0 * radius); }

// ((x^2 + y^2) cos^2 - z^2 sin^2) / size of the half angle, radians in (0, pi / 2): both halves of a cone
// about the z axis, the apex at the origin.
constexpr RealQuadric algebraic_cone(double half_angle, double size) {
  const double c = exact_cos(half_angle), s = exact_sin(half_angle);
  return {{{c * c / size, 0.0, 0.0}, {0.0, c * c / size, 0.0}, {0.0, 0.0, -s * s / size}}, {}, 0.0};
}

}  // namespace nearfield
