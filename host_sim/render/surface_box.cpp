#include "render/surface_box.hpp"

#include <algorithm>
#include <cmath>

namespace nearfield::host {
namespace {

constexpr int refinements = 2;  // searches, each in what the one before has found
// Halvings of the search's longest edge; without a proof many more cells are looked into.
constexpr int search_depth = 7, search_depth_uncertified = 6;
// The same of the search for where the surface ends.
constexpr int last_depth = 9, last_depth_uncertified = 7;

Vector3d least(const Vector3d& a, const Vector3d& b) {
  return {std::min(a.x, b.x), std::min(a.y, b.y), std::min(a.z, b.z)};
}
Vector3d greatest(const Vector3d& a, const Vector3d& b) {
  return {std::max(a.x, b.x), std::max(a.y, b.y), std::max(a.z, b.z)};
}

constexpr double Vector3d::*coordinates[] = {&Vector3d::x, &Vector3d::y, &Vector3d::z};

double longest_edge(const Box3& box) { return std::max({box.size().x, box.size().y, box.size().z}); }

class Search {
 public:
  Search(const SceneField& field, int depth) : field_(field), coarse_(depth - 3) {}

  void look(const Box3& cell, int depth) {
    if (found_ && found_->contains(cell.low) && found_->contains(cell.high)) return;
    const Vector3d middle = cell.middle();
    const double radius = 0.5 * length(cell.size());
    if (field_.certified() && field_.free_radius(middle, radius) >= radius) return;
    const FieldAnswer answer = field_.at(middle);
    // |f| over the slope, without dividing by a slope of 0.
    const double slope = length(answer.gradient), distance = std::abs(answer.outward);
    if (depth == 0) {
      const double reach = slope * radius;
      if (distance <= reach || (distance <= 3.0 * reach && changes_sign(cell, answer.outward < 0.0)))
        add(cell);
      return;
    }
    // Certified fields need no guess; of others the coarse cells are all looked into.
    if (!field_.certified() && depth < coarse_) {
      const bool fine = depth < coarse_ - 2;  // small enough for the field to be nearly linear in it
      if (distance > (fine ? 1.5 : 3.0) * slope * radius &&
          (fine || !changes_sign(cell, answer.outward < 0.0)))
        return;
    }
    // Only long edges, so that cells become cubes.
    const double longest = longest_edge(cell);
    for (unsigned part = 0; part < 8; ++part) {
      Box3 child = cell;
      bool exists = true;
      for (unsigned axis = 0; axis < 3; ++axis) {
        double Vector3d::*const x = coordinates[axis];
        const bool upper = (part >> axis & 1U) != 0, split = cell.high.*x - cell.low.*x > 0.6 * longest;
        exists = exists && (split || !upper);
        Vector3d& side = upper ? child.low : child.high;
        if (split) side.*x = middle.*x;
      }
      if (exists) look(child, depth - 1);
    }
  }
  void start_from(const Box3& box) { found_ = box; }
  const std::optional<Box3>& found() const { return found_; }

 private:
  bool changes_sign(const Box3& cell, bool inside) const {
    for (unsigned i = 0; i < 8; ++i) {
      const Vector3d corner{(i & 1U) != 0 ? cell.high.x : cell.low.x,
                            (i & 2U) != 0 ? cell.high.y : cell.low.y,
                            (i & 4U) != 0 ? cell.high.z : cell.low.z};
      if (field_.inside(corner) != inside) return true;
    }
    return false;
  }
  void add(const Box3& cell) {
    found_ = found_ ? Box3{least(found_->low, cell.low), greatest(found_->high, cell.high)} : cell;
  }

  const SceneField& field_;
  int coarse_;  // depth from which on cells are looked into whatever is in their middle
  std::optional<Box3> found_;
};

// At least a point in the middle is left.
Box3 shrunk(const Box3& box, double by) {
  const Box3 less = grown(box, -by);
  const Vector3d middle = box.middle();
  return {least(less.low, middle), greatest(less.high, middle)};
}

}  // namespace

Box3 grown(const Box3& box, double by) {
  const Vector3d margin{by, by, by};
  return {box.low - margin, box.high + margin};
}
Box3 intersection(const Box3& a, const Box3& b) { return {greatest(a.low, b.low), least(a.high, b.high)}; }
Box3 domain_box(const SceneField& field) {
  const double d = field.domain();
  return {{-d, -d, -d}, {d, d, d}};
}

std::optional<Box3> surface_box(const SceneField& field, const Box3& search) {
  const bool certified = field.certified();
  const int depth = certified ? search_depth : search_depth_uncertified;
  Box3 within = search;
  std::optional<Box3> found;
  double cell = 0.0;
  for (int round = 0; round < refinements; ++round) {
    Search one(field, depth);
    one.look(within, depth);
    if (!one.found()) return found;
    found = one.found();
    cell = longest_edge(within) / (1 << depth);
    within = intersection(grown(*found, longest_edge(*found) / 64.0), search);
  }
  // The surface reaches to within two of the cells that were found; what lies nearer to the middle needs no
  // second look.
  Search last(field, certified ? last_depth : last_depth_uncertified);
  last.start_from(shrunk(*found, 2.0 * cell));
  last.look(within, certified ? last_depth : last_depth_uncertified);
  return last.found();
}

}  // namespace nearfield::host
