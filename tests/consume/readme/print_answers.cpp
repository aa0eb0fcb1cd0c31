// Prints what README.md says that its examples answer. The headers and example.c are its code blocks.
#include "firmware.hpp"
#include "image.hpp"

#include <nearfield/field/builder.hpp>

#include <stdio.h>

extern "C" {
int start(const void* image, size_t byte_count);
int may_move(const int32_t tool[3]);
}

namespace {

// The field of the first example as an image.
nf::ImageBuilder<Q, 300> cell_image() {
  nf::ImageBuilder<Q, 300> builder;
  const uint32_t table = builder.table(kRounding);
  nf::AdditiveUnion<Q> blend;
  blend.scale = nf::ArgumentScale<Q>::of(nf::narrow<Q>(nf::product(Q(0.05), kRounding.range)));
  builder.operation(nf::Box<Q>{{0.0, 0.0, -0.05}, {0.8, 0.6, 0.05}})
      .operation(nf::Capsule<Q>{{0.3, 0.2, 0.0}, {0.3, 0.2, 0.5}, 0.04})
      .operation(blend, table);
  builder.finish();
  return builder;
}

const char* name_of(nf::ClearanceStatus status) {
  switch (status) {
    case nf::ClearanceStatus::clear: return "clear";
    case nf::ClearanceStatus::touching: return "touching";
    case nf::ClearanceStatus::undecided: return "undecided";
    case nf::ClearanceStatus::invalid: break;
  }
  return "invalid";
}

bool same(const nf::Clearance<Q>& a, const nf::Clearance<Q>& b) {
  return a.status == b.status && a.distance == b.distance && a.direction == b.direction;
}

}  // namespace

int main() {
  const nf::ImageBuilder<Q, 300> image = cell_image();
  const size_t byte_count = image.size() * sizeof(uint32_t);
  const int32_t somewhere[3] = {0, 0, 1 << 27};
  if (may_move(somewhere) != 0 || start(image.words(), byte_count) != 0) return 1;

  const nf::Vector3<Q> tools[] = {
      {0.0, 0.0, 0.5}, {0.45, 0.2, 0.3}, {0.4, 0.2, 0.06}, {0.3, 0.2, 0.51}, {0.0, 0.0, 5.0}};
  for (const nf::Vector3<Q>& tool : tools) {
    const nf::Clearance<Q> c = nf::clearance(kCell, tool);
    const int32_t raw[3] = {tool.x.raw(), tool.y.raw(), tool.z.raw()};
    if (!same(c, clearance_in_image(image.words(), byte_count, tool))) return 1;
    if (may_move(raw) != (c.status == nf::ClearanceStatus::clear && c.distance > Q(0.02) ? 1 : 0)) return 1;
    printf("(%.2f, %.2f, %.2f) %s", tool.x.to_double(), tool.y.to_double(), tool.z.to_double(),
           name_of(c.status));
    if (c.status != nf::ClearanceStatus::invalid) {
      printf(" %.7f m, away (%.3f, %.3f, %.3f)", c.distance.to_double(), c.direction.x.to_double(),
             c.direction.y.to_double(), c.direction.z.to_double());
    }
    printf(", speed %.4f\n", allowed_speed(tool).to_double());
  }
  return 0;
}
