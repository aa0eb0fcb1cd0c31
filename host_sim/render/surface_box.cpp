#include "render/surface_box.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

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

// Halvings after which the first-order distance may pass over cells as well. Intensities are constant far
// from what they are of and steep at the surface, so that it tells little of them: the first search goes by
// proofs.
int proved_halvings(const SceneField& field, int round) {
  if (!field.certified()) return 3;
  if (field.kind() == Kind::intensity) return round == 0 ? search_depth : round < refinements ? 6 : 5;
  return field.kind() == Kind::distance ? 6 : 4;
}

double longest_edge(const Box3& box) { return std::max({box.size().x, box.size().y, box.size().z}); }

class Search {
 public:
  // `finest`: the edge of the smallest cells, m.
  // `round`: how many searches came before, which have found where to look.
  Search(const SceneField& field, int round, int depth, double finest)
      : field_(field),
        proved_alone_(depth - proved_halvings(field, round)),
        keeps_unproved_(round == 0 && field.certified() && field.kind() == Kind::intensity),
        finest_(finest) {}

  void look(const Box3& all, int depth) {
    if (found_ && found_->contains(all.low) && found_->contains(all.high)) return;
    Box3 cell = all;
    double Vector3d::*const way = found_ ? outside(*found_, cell) : nullptr;
    const Vector3d middle = cell.middle();
    if (field_.certified() && field_.is_free(middle, 0.5 * length(cell.size()))) return;
    if (depth > 0 && depth >= proved_alone_) {
      look_into(cell, way, false, depth);
      return;
    }
    const FieldAnswer answer = field_.at(middle);
    // |f| and how much it changes within the cell by the slope in its middle: no dividing by a slope of 0.
    const Vector3d half = 0.5 * cell.size();
    const double change = std::abs(answer.gradient.x) * half.x + std::abs(answer.gradient.y) * half.y +
                          std::abs(answer.gradient.z) * half.z;
    const double distance = std::abs(answer.outward);
    const bool near = distance <= change;
    // Intensities may rise so steeply that slopes elsewhere tell nothing.
    const bool steep = field_.kind() == Kind::intensity;
    const auto crosses = [&] {
      return (steep || distance <= 3.0 * change) && changes_sign(cell, answer.outward < 0.0);
    };
    if (depth == 0) {
      if (keeps_unproved_ || near || crosses()) add(cell);
      return;
    }
    const bool fine = depth < proved_alone_ - 2;  // small enough for the field to be nearly linear in it
    bool only_way = false;
    if (fine) {
      if (distance > 1.5 * change && !(steep && crosses())) return;
      if (way != nullptr && cell.size().*way <= finest_) {
        if (crosses()) {
          add(cell);
          return;
        }
        if (!near) return;
      } else if (way != nullptr) {
        // Where a face ends that is nearly even: no need to look at each piece of it.
        only_way = std::abs(answer.gradient.*way) * half.*way > 0.5 * change;
      }
    } else if (distance > 3.0 * change && !changes_sign(cell, answer.outward < 0.0)) {
      return;
    }
    look_into(cell, way, only_way, depth);
  }
  // Looks at the parts of a cell, halved along the way out of what was found and, unless that is the
  // `only_way`, along long edges, so that cells become cubes.
  void look_into(const Box3& cell, double Vector3d::*way, bool only_way, int depth) {
    const Vector3d middle = cell.middle();
    const double longest = longest_edge(cell);
    for (unsigned part = 0; part < 8; ++part) {
      Box3 child = cell;
      bool exists = true;
      for (unsigned axis = 0; axis < 3; ++axis) {
        double Vector3d::*const x = coordinates[axis];
        const bool upper = (part >> axis & 1U) != 0,
                   split = x == way || (!only_way && cell.size().*x > 0.6 * longest);
        exists = exists && (split || !upper);
        Vector3d& side = upper ? child.low : child.high;
        if (split) side.*x = middle.*x;
      }
      if (exists) look(child, only_way ? depth : depth - 1);
    }
  }
  void start_from(const Box3& box) { found_ = box; }
  // Finds points of the surface on the lines of a coarse grid: cells within their box need no look.
  void start_from_points_in(const Box3& box) {
    constexpr unsigned steps = 16, corners = steps + 1;
    const auto at = [&box](unsigned x, unsigned y, unsigned z) {
      const Vector3d size = box.size();
      return box.low + Vector3d{x * size.x / steps, y * size.y / steps, z * size.z / steps};
    };
    std::vector<bool> inside;
    for (unsigned i = 0; i < corners * corners * corners; ++i)
      inside.push_back(field_.inside(at(i % corners, i / corners % corners, i / (corners * corners))));
    for (unsigned i = 0; i < inside.size(); ++i) {
      const unsigned x = i % corners, y = i / corners % corners, z = i / (corners * corners);
      if (x < steps && inside[i] != inside[i + 1]) add_crossing(at(x, y, z), at(x + 1, y, z), inside[i]);
      if (y < steps && inside[i] != inside[i + corners])
        add_crossing(at(x, y, z), at(x, y + 1, z), inside[i]);
      if (z < steps && inside[i] != inside[i + corners * corners])
        add_crossing(at(x, y, z), at(x, y, z + 1), inside[i]);
    }
  }
  const std::optional<Box3>& found() const { return found_; }

 private:
  // Leaves of a cell that stands out of a box on one side alone what is outside, and returns the axis.
  static double Vector3d::*outside(const Box3& box, Box3& cell) {
    int sides = 0;
    double Vector3d::*way = nullptr;
    for (double Vector3d::*const x : coordinates) {
      const bool below = (cell.low.*x)<(box.low.*x), above = (cell.high.*x)>(box.high.*x);
      sides += (below ? 1 : 0) + (above ? 1 : 0);
      if (below || above) way = x;
    }
    if (sides != 1) return nullptr;
    if (cell.low.*way < box.low.*way)
      cell.high.*way = std::min(cell.high.*way, box.low.*way);
    else
      cell.low.*way = std::max(cell.low.*way, box.high.*way);
    return way;
  }
  bool changes_sign(const Box3& cell, bool inside) const {
    for (unsigned i = 0; i < 8; ++i) {
      const Vector3d corner{(i & 1U) != 0 ? cell.high.x : cell.low.x,
                            (i & 2U) != 0 ? cell.high.y : cell.low.y,
                            (i & 4U) != 0 ? cell.high.z : cell.low.z};
      if (field_.inside(corner) != inside) return true;
    }
    return false;
  }
  // Of two places of which only one is inside.
  void add_crossing(Vector3d from, Vector3d to, bool from_inside) {
    if (found_ && found_->contains(from) && found_->contains(to)) return;
    for (int i = 0; i < 12; ++i) {
      const Vector3d middle = 0.5 * (from + to);
      (field_.inside(middle) == from_inside ? from : to) = middle;
    }
    add({least(from, to), greatest(from, to)});
  }
  void add(const Box3& cell) {
    found_ = found_ ? Box3{least(found_->low, cell.low), greatest(found_->high, cell.high)} : cell;
  }

  const SceneField& field_;
  int proved_alone_;     // from this depth on cells are looked into whatever is in their middle
  bool keeps_unproved_;  // cells that no proof passes over
  double finest_;
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
    cell = longest_edge(within) / (1 << depth);
    Search one(field, round, depth, cell);
    one.start_from_points_in(within);
    one.look(within, depth);
    if (!one.found()) return found;
    found = one.found();
    within = intersection(grown(*found, longest_edge(*found) / 64.0), search);
  }
  // The surface reaches to within two of the cells that were found; what lies nearer to the middle needs no
  // second look.
  const int deepest = certified ? last_depth : last_depth_uncertified;
  Search last(field, refinements, deepest, longest_edge(within) / (1 << deepest));
  last.start_from(shrunk(*found, 2.0 * cell));
  last.look(within, deepest);
  return last.found();
}

}  // namespace nearfield::host
