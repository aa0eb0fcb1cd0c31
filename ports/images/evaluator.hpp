// An image that loads programs and asks them for clearances.
#pragma once

#include <nearfield/field/builder.hpp>
#include <nearfield/nearfield.hpp>

#include <images/report.hpp>

namespace nearfield::images {

using Q = Fixed<27>;
inline volatile int32_t sink;

template <class Operations, class Image> int run(const Image& image) {
  const Program<Q, Operations> program = load<Q, Operations>(image.words(), image.size() * 4);
  if (!program.valid()) {
    board::write("the image does not load\n");
    return 1;
  }
  for (int32_t i = 0; i < 100; ++i) {
    const Vector3<Q> p = {Q::from_raw(i * 2654435), Q::from_raw(-i * 2654435), Q::from_raw(i * 1327217)};
    Clearance<Q> answer = clearance(program, p);
    if constexpr (Operations::has(Operation::soft_point)) {
      if (program.kind() == Kind::intensity) answer = soft_clearance(program, p);
    }
    sink = answer.distance.raw();
    sink = answer.direction.x.raw();
  }
  return 0;
}

}  // namespace nearfield::images
