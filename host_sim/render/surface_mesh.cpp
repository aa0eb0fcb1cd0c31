#include "render/surface_mesh.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <unordered_map>

#include "render/cell_polygons.hpp"
#include "render/renderer.hpp"
#include "render/view.hpp"

namespace nearfield::host {
namespace {

constexpr std::size_t block = 8;  // cells each way, looked at together
constexpr int halvings = 48;

class Mesher {
 public:
  Mesher(const SceneField& field, const MeshSettings& settings) : field_(field), settings_(settings) {
    const Vector3d size = settings.box.size();
    step_ = std::max({size.x, size.y, size.z}) / static_cast<double>(settings.resolution);
    const auto cells = [this](double edge) {
      return static_cast<std::size_t>(std::max(1.0, std::ceil(edge / step_ - 1e-6)));
    };
    cells_ = {cells(size.x), cells(size.y), cells(size.z)};
    // The last layer ends with the box.
    inside_.assign((cells_[0] + 1) * (cells_[1] + 1) * (cells_[2] + 1), 0);
  }

  Meshing mesh(const ReportProgress& report) {
    Meshing result;
    result.cells = cells_[0] * cells_[1] * cells_[2];
    result.passed_over = sample([&](double done) {
      if (report) report(0.7 * done);
    });
    if (touches_border()) {
      if (!settings_.close) {
        result.leaves_box = true;
        return result;
      }
      clear_border();
    }
    find_crossings();
    result.mesh.vertices.resize(crossings_.size());
    const std::size_t part = 1024;
    for_each_row((crossings_.size() + part - 1) / part, settings_.threads,
                 [&](std::size_t row) {
                   for (std::size_t i = row * part; i < std::min((row + 1) * part, crossings_.size()); ++i) {
                     result.mesh.vertices[i] = vertex_on(crossings_[i]);
                   }
                 },
                 [&](double done) {
                   if (report) report(0.7 + 0.3 * done);
                 });
    add_triangles(result.mesh);
    return result;
  }

 private:
  struct Crossing {
    std::size_t corner;  // where its edge starts
    unsigned axis;
    bool closes;  // the end outside is so because the box ends there
  };

  std::size_t index(std::size_t x, std::size_t y, std::size_t z) const {
    return (z * (cells_[1] + 1) + y) * (cells_[0] + 1) + x;
  }
  std::array<std::size_t, 3> strides() const { return {1, cells_[0] + 1, (cells_[0] + 1) * (cells_[1] + 1)}; }
  Vector3d corner(std::size_t x, std::size_t y, std::size_t z) const {
    const auto at = [this](std::size_t i, double low, double high) {
      return std::min(low + static_cast<double>(i) * step_, high);
    };
    const Box3& box = settings_.box;
    return {at(x, box.low.x, box.high.x), at(y, box.low.y, box.high.y), at(z, box.low.z, box.high.z)};
  }
  Vector3d corner(std::size_t i) const {
    const std::array<std::size_t, 3> by = strides();
    return corner(i % by[1], i / by[1] % (cells_[1] + 1), i / by[2]);
  }

  // Signs at all corners, layers of blocks at a time; what a block's ball is proved to hold all of needs no
  // evaluation. Returns how many cells were passed over.
  std::size_t sample(const ReportProgress& report) {
    const std::size_t layers = (cells_[2] + block) / block;
    std::vector<std::size_t> passed(layers, 0);
    for_each_row(
        layers, settings_.threads,
        [&](std::size_t layer) {
          for (std::size_t y = 0; y <= cells_[1]; y += block) {
            for (std::size_t x = 0; x <= cells_[0]; x += block)
              passed[layer] += sample_block(x, y, layer * block);
          }
        },
        report);
    std::size_t sum = 0;
    for (const std::size_t one : passed) sum += one;
    return std::min(sum, cells_[0] * cells_[1] * cells_[2]);
  }
  std::size_t sample_block(std::size_t x, std::size_t y, std::size_t z) {
    const std::size_t end_x = std::min(x + block, cells_[0] + 1), end_y = std::min(y + block, cells_[1] + 1),
                      end_z = std::min(z + block, cells_[2] + 1);
    const Box3 all{corner(x, y, z), corner(end_x - 1, end_y - 1, end_z - 1)};
    const double radius = 0.5 * length(all.size());
    const bool proved = field_.certified() && field_.free_radius(all.middle(), radius) > radius;
    const bool sign = proved && field_.inside(all.middle());
    for (std::size_t k = z; k < end_z; ++k) {
      for (std::size_t j = y; j < end_y; ++j) {
        for (std::size_t i = x; i < end_x; ++i) {
          inside_[index(i, j, k)] = (proved ? sign : field_.inside(corner(i, j, k))) ? 1 : 0;
        }
      }
    }
    return proved ? (end_x - x) * (end_y - y) * (end_z - z) : 0;
  }

  template <class Use>
  void for_each_border_corner(const Use& use) {
    for (std::size_t z = 0; z <= cells_[2]; ++z) {
      for (std::size_t y = 0; y <= cells_[1]; ++y) {
        const bool whole_row = z == 0 || z == cells_[2] || y == 0 || y == cells_[1];
        for (std::size_t x = 0; x <= cells_[0]; x += whole_row ? 1 : cells_[0]) use(inside_[index(x, y, z)]);
      }
    }
  }
  bool touches_border() {
    bool any = false;
    for_each_border_corner([&any](std::uint8_t inside) { any = any || inside != 0; });
    return any;
  }
  void clear_border() {
    for_each_border_corner([](std::uint8_t& inside) { inside = inside != 0 ? cut_off : 0; });
  }
  bool is_inside(std::size_t i) const { return inside_[i] == 1; }

  void find_crossings() {
    const std::array<std::size_t, 3> by = strides();
    for (std::size_t z = 0; z <= cells_[2]; ++z) {
      for (std::size_t y = 0; y <= cells_[1]; ++y) {
        for (std::size_t x = 0; x <= cells_[0]; ++x) {
          const std::size_t at = index(x, y, z);
          const bool more[3] = {x < cells_[0], y < cells_[1], z < cells_[2]};
          for (unsigned axis = 0; axis < 3; ++axis) {
            if (!more[axis] || is_inside(at) == is_inside(at + by[axis])) continue;
            vertex_of_[3 * at + axis] = static_cast<std::uint32_t>(crossings_.size());
            crossings_.push_back({at, axis, inside_[at] == cut_off || inside_[at + by[axis]] == cut_off});
          }
        }
      }
    }
  }

  SurfaceMesh::Vertex vertex_on(const Crossing& crossing) const {
    Vector3d inner = corner(crossing.corner), outer = corner(crossing.corner + strides()[crossing.axis]);
    if (!is_inside(crossing.corner)) std::swap(inner, outer);
    if (crossing.closes) return {outer, normalised(outer - inner)};
    for (int i = 0; i < halvings; ++i) {
      const Vector3d middle = 0.5 * (inner + outer);
      (field_.inside(middle) ? inner : outer) = middle;
    }
    const bool outer_is_nearer = std::abs(field_.outward(outer)) <= std::abs(field_.outward(inner));
    const Vector3d p = outer_is_nearer ? outer : inner;
    return {p, surface_normal(field_, p, 0.01 * step_).direction};
  }

  void add_triangles(SurfaceMesh& mesh) const {
    const std::array<std::size_t, 3> by = strides();
    for (std::size_t z = 0; z < cells_[2]; ++z) {
      for (std::size_t y = 0; y < cells_[1]; ++y) {
        for (std::size_t x = 0; x < cells_[0]; ++x) {
          const std::size_t at = index(x, y, z);
          const auto corner_index = [&](unsigned i) {
            return at + (i & 1U) * by[0] + (i >> 1 & 1U) * by[1] + (i >> 2 & 1U) * by[2];
          };
          std::uint8_t inside = 0;
          for (unsigned i = 0; i < 8; ++i)
            inside = static_cast<std::uint8_t>(inside | (is_inside(corner_index(i)) ? 1U << i : 0U));
          if (inside == 0 || inside == 255) continue;
          for (const CellPolygon& polygon : cell_polygons(inside)) {
            std::vector<std::uint32_t> vertices;
            for (const unsigned edge : polygon)
              vertices.push_back(vertex_of_.at(3 * corner_index(cell_edge(edge).from) + edge / 4));
            triangulate(polygon, vertices, mesh);
          }
        }
      }
    }
  }

  // The triangles of least area altogether, none of whose inner edges lies in a face of the cell: there a
  // neighbour might have the same edge. Without such a triangulation, one about a vertex more.
  void triangulate(const CellPolygon& polygon, const std::vector<std::uint32_t>& vertices,
                   SurfaceMesh& mesh) const {
    const std::size_t n = polygon.size();
    constexpr double forbidden = std::numeric_limits<double>::infinity();
    std::array<std::array<double, 12>, 12> least{};
    std::array<std::array<std::size_t, 12>, 12> apex{};
    const auto allowed = [&](std::size_t i, std::size_t j) {
      return j - i == 1 || j - i == n - 1 || !share_face(polygon[i], polygon[j]);
    };
    for (std::size_t span = 2; span < n; ++span) {
      for (std::size_t i = 0; i + span < n; ++i) {
        const std::size_t j = i + span;
        least[i][j] = forbidden;
        if (!allowed(i, j)) continue;
        for (std::size_t k = i + 1; k < j; ++k) {
          const double sum = least[i][k] + least[k][j] + area(mesh, vertices[i], vertices[k], vertices[j]);
          if (sum < least[i][j]) {
            least[i][j] = sum;
            apex[i][j] = k;
          }
        }
      }
    }
    if (least[0][n - 1] < forbidden) {
      add_from(0, n - 1, apex, vertices, mesh);
      return;
    }
    const std::uint32_t middle = add_middle(vertices, mesh);
    for (std::size_t i = 0; i < n; ++i)
      mesh.triangles.push_back({middle, vertices[i], vertices[(i + 1) % n]});
  }
  static void add_from(std::size_t i, std::size_t j, const std::array<std::array<std::size_t, 12>, 12>& apex,
                       const std::vector<std::uint32_t>& vertices, SurfaceMesh& mesh) {
    if (j - i < 2) return;
    const std::size_t k = apex[i][j];
    mesh.triangles.push_back({vertices[i], vertices[k], vertices[j]});
    add_from(i, k, apex, vertices, mesh);
    add_from(k, j, apex, vertices, mesh);
  }
  static double area(const SurfaceMesh& mesh, std::uint32_t a, std::uint32_t b, std::uint32_t c) {
    const Vector3d& p = mesh.vertices[a].position;
    return length(cross(mesh.vertices[b].position - p, mesh.vertices[c].position - p));
  }
  // The mean of a polygon's vertices, moved along the field's gradient onto the surface where that is within
  // a cell.
  std::uint32_t add_middle(const std::vector<std::uint32_t>& vertices, SurfaceMesh& mesh) const {
    Vector3d mean;
    for (const std::uint32_t v : vertices)
      mean = mean + 1.0 / static_cast<double>(vertices.size()) * mesh.vertices[v].position;
    const Vector3d along = surface_normal(field_, mean, 0.01 * step_).direction;
    Vector3d inner = mean - step_ * along, outer = mean + step_ * along;
    if (field_.in_domain(inner) && field_.in_domain(outer) && field_.inside(inner) && !field_.inside(outer)) {
      for (int i = 0; i < halvings; ++i) {
        const Vector3d middle = 0.5 * (inner + outer);
        (field_.inside(middle) ? inner : outer) = middle;
      }
      mean = outer;
    }
    mesh.vertices.push_back({mean, surface_normal(field_, mean, 0.01 * step_).direction});
    return static_cast<std::uint32_t>(mesh.vertices.size() - 1);
  }

  static constexpr std::uint8_t cut_off = 2;  // inside, but treated as outside

  const SceneField& field_;
  const MeshSettings& settings_;
  double step_ = 1.0;
  std::array<std::size_t, 3> cells_{};
  std::vector<std::uint8_t> inside_;  // 0, 1 or cut_off, of each corner
  std::vector<Crossing> crossings_;
  std::unordered_map<std::size_t, std::uint32_t> vertex_of_;  // by 3 * corner + axis
};

}  // namespace

Meshing mesh_of(const SceneField& field, const MeshSettings& settings, const ReportProgress& report) {
  return Mesher(field, settings).mesh(report);
}

}  // namespace nearfield::host
