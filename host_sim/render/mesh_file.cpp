#include "render/mesh_file.hpp"

#include <cstring>

#include "text/number.hpp"

namespace nearfield::host {
namespace {

// The bytes of a number, the lowest first.
template <class Bits, class Number>
void append(std::string& text, Number number) {
  static_assert(sizeof(Bits) == sizeof(Number), "as many bits as the number has");
  Bits bits;
  std::memcpy(&bits, &number, sizeof bits);
  for (std::size_t i = 0; i < sizeof bits; ++i) text += static_cast<char>(bits >> 8 * i & 0xFFU);
}

std::string one_line(const std::string& text) {
  std::string line;
  for (const char c : text) line += static_cast<unsigned char>(c) < 0x20U ? ' ' : c;
  return line;
}

}  // namespace

std::string ply_of(const SurfaceMesh& mesh, const std::string& comment) {
  std::string text = "ply\nformat binary_little_endian 1.0\ncomment " + one_line(comment) +
                     "\nelement vertex " + std::to_string(mesh.vertices.size()) +
                     "\nproperty double x\nproperty double y\nproperty double z\n"
                     "property float nx\nproperty float ny\nproperty float nz\nelement face " +
                     std::to_string(mesh.triangles.size()) +
                     "\nproperty list uchar uint vertex_indices\nend_header\n";
  for (const SurfaceMesh::Vertex& v : mesh.vertices) {
    for (const double x : {v.position.x, v.position.y, v.position.z}) append<std::uint64_t>(text, x);
    for (const double x : {v.normal.x, v.normal.y, v.normal.z})
      append<std::uint32_t>(text, static_cast<float>(x));
  }
  for (const auto& triangle : mesh.triangles) {
    text += '\3';
    for (const std::uint32_t vertex : triangle) append<std::uint32_t>(text, vertex);
  }
  return text;
}

std::string obj_of(const SurfaceMesh& mesh, const std::string& comment) {
  const auto list = [](const Vector3d& v) {
    return ' ' + format_number(v.x) + ' ' + format_number(v.y) + ' ' + format_number(v.z) + '\n';
  };
  std::string text = "# " + one_line(comment) + "\n";
  for (const SurfaceMesh::Vertex& v : mesh.vertices) text += "v" + list(v.position);
  for (const SurfaceMesh::Vertex& v : mesh.vertices) text += "vn" + list(v.normal);
  for (const auto& triangle : mesh.triangles) {
    text += 'f';
    for (const std::uint32_t vertex : triangle) {
      const std::string number = std::to_string(vertex + 1);
      text += ' ' + number + "//" + number;
    }
    text += '\n';
  }
  return text;
}

}  // namespace nearfield::host
