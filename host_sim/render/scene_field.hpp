// A scene's field as pictures and meshes see it: in real numbers, evaluated by the program of a scalar.
#pragma once

#include <array>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <nearfield/shape/sample.hpp>

#include "compile/field_scalar.hpp"
#include "model/scene_description.hpp"
#include "model/vector3d.hpp"

namespace nearfield::host {

// Where f is more than 0 is outside, whatever the kind: f = value - level, of intensities level - value.
struct FieldAnswer {
  double outward = 0.0;  // f
  Vector3d gradient;     // of f, per m; {0, 0, 0} where the value has saturated
  // Saturated, or of an algebraic field so large that what it is made of may have: then neither its length
  // nor its direction need hold.
  bool gradient_doubtful = false;
};

// What is proved of f, as double and rounded to the careful side.
struct FieldProof {
  std::optional<double> rate;  // |f(p) - f(q)| <= rate |p - q|, per m; nothing where none is known
  double error = 0.0;          // greatest |evaluated - exact| where a rate is known
};

// All members may be called by several threads at once. Points are m, |coordinates| at most domain(); they
// are rounded to the scalar first.
class SceneField {
 public:
  virtual ~SceneField() = default;

  virtual Kind kind() const = 0;
  virtual double level() const = 0;   // of the value, that makes the surface
  virtual double domain() const = 0;  // m
  virtual const FieldProof& proof() const = 0;
  // Whether free_radius() may be more than 0 anywhere.
  virtual bool certified() const = 0;

  virtual double value(const Vector3d& p) const = 0;    // of the field itself
  virtual double outward(const Vector3d& p) const = 0;  // f
  virtual FieldAnswer at(const Vector3d& p) const = 0;
  // A radius in m, from 0, such that the sign of f is the same for certain throughout a ball about p. Of
  // intensities without a rate only where f > 0. `guess`: a radius near which to look (cost alone depends on
  // it, and of intensities how much is found).
  virtual double free_radius(const Vector3d& p, double guess) const = 0;

  // Whether free_radius() can be `radius` or more: one look where that searches.
  virtual bool is_free(const Vector3d& p, double radius) const = 0;

  // free_radius() from f alone, by the rate; 0 without one. Cheaper, and of intensities less.
  virtual double free_radius_where(double outward) const = 0;

  bool inside(const Vector3d& p) const { return outward(p) < 0.0; }
  bool in_domain(const Vector3d& p) const {
    return std::abs(p.x) <= domain() && std::abs(p.y) <= domain() && std::abs(p.z) <= domain();
  }
};

// The value on the surface of fields of a kind: 0 of distances and algebraic fields, 1/2 of intensities and
// rays.
double surface_level(Kind kind);
const char* name_of(Kind kind);

// `level`: instead of surface_level(). `parameters`: of the field's parameter slots. InputError as
// evaluation_csv().
std::unique_ptr<SceneField> scene_field(const SceneDescription& scene, FieldScalar scalar,
                                        const std::vector<double>& parameters = {},
                                        std::optional<double> level = std::nullopt);

}  // namespace nearfield::host
