// Builds a field image, loads it, and writes both it and the answers to some points for a program in C to
// compare: write_answers IMAGE ANSWERS. An answer is a line of integers: point, status, distance, direction.
#include <nearfield/field/builder.hpp>
#include <nearfield/nearfield.hpp>

#include <cstdio>

using namespace nearfield;
using Q = Fixed<27>;

static_assert(__cplusplus >= 201703L, "nearfield::core asks for C++17");

namespace {

// A ball at the frame's origin blended with a box in slot 0.
ImageBuilder<Q, 300> field_image() {
  static constexpr auto rounding = bake<Q>(exterior(step::polynomial<3>, 0.25));
  ImageBuilder<Q, 300> builder;
  const uint32_t table = builder.table(rounding);
  builder.operation(Sphere<Q>{{0.0, 0.0, 0.0}, 0.25});
  builder.enter_slot(0).operation(Box<Q>{{0.0, 0.0, 0.0}, {0.25, 0.125, 0.5}}).leave();
  AdditiveUnion<Q> blend;
  blend.scale = ArgumentScale<Q>::of(Q(0.125));
  builder.operation(blend, table);
  builder.finish();
  return builder;
}

bool write_image(const char* file, const uint32_t* words, uint32_t count) {
  std::FILE* to = std::fopen(file, "wb");
  if (to == nullptr) return false;
  const bool written = std::fwrite(words, sizeof(uint32_t), count, to) == count;
  return std::fclose(to) == 0 && written;
}

}  // namespace

int main(int count, char** arguments) {
  if (count != 3) return 2;
  const ImageBuilder<Q, 300> builder = field_image();
  const Program<Q> program = load<Q>(builder.words(), builder.size() * sizeof(uint32_t));
  if (!program.valid() || !write_image(arguments[1], builder.words(), builder.size())) return 1;
  std::FILE* answers = std::fopen(arguments[2], "w");
  if (answers == nullptr) return 1;

  Pose<Q> slot;  // also in answers.c
  slot.rotation.row[0] = {0.0, -1.0, 0.0};
  slot.rotation.row[1] = {1.0, 0.0, 0.0};
  slot.translation = {0.75, 0.0, 0.0};
  for (int x = -5; x <= 5; ++x) {
    for (int y = -5; y <= 5; ++y) {
      const Vector3<Q> p = {Q::from_raw(x * 123456789), Q::from_raw(y * 98765432),
                            Q::from_raw((x - y) * 1234567)};
      const Clearance<Q> c = clearance(program, p, &slot, 1);
      std::fprintf(answers, "%d %d %d %d %d %d %d %d\n", p.x.raw(), p.y.raw(), p.z.raw(),
                   static_cast<int>(c.status), c.distance.raw(), c.direction.x.raw(), c.direction.y.raw(),
                   c.direction.z.raw());
    }
  }
  return std::fclose(answers) == 0 ? 0 : 1;
}
