// Queries of a scene of 96 solids on a host, in ns, next to what a user would write instead: 64 capsules, 16 boxes and 16
// balls, the nearest of which counts. Times are the least of several rounds, in which all take turns: only their ratios within
// one run mean anything.
#include <nearfield/field/builder.hpp>
#include <nearfield/query/batch.hpp>

#include <stdio.h>
#include <time.h>

namespace {

using namespace nearfield;

constexpr uint32_t kCapsules = 64, kBoxes = 16, kBalls = 16, kPoints = 4096;
constexpr int kRounds = 25;

struct Ball {
  float x, y, z, radius;
};
struct Block {
  float x, y, z, half_x, half_y, half_z;
};
struct Rod {
  float x, y, z, axis_x, axis_y, axis_z, length, radius;
  Vector3<float> end;
};
struct Scene {
  Rod rods[kCapsules];
  Block blocks[kBoxes];
  Ball balls[kBalls];
};

uint32_t state = 2463534242u;
float number(float low, float high) {
  state ^= state << 13;
  state ^= state >> 17;
  state ^= state << 5;
  return low + (high - low) * static_cast<float>(state >> 8) * (1.0f / 16777216.0f);
}
Vector3<float> place() { return {number(-2, 2), number(-2, 2), number(-2, 2)}; }

Scene random_scene() {
  Scene scene;
  for (Rod& rod : scene.rods) {
    const Vector3<float> from = place(), to = place();
    const Capsule<float> made(from, to, 0.0f);
    rod = {from.x, from.y, from.z, made.axis.x, made.axis.y, made.axis.z, made.length, number(0.02f, 0.2f), to};
  }
  for (Block& block : scene.blocks) {
    const Vector3<float> at = place();
    block = {at.x, at.y, at.z, number(0.05f, 0.4f), number(0.05f, 0.4f), number(0.05f, 0.4f)};
  }
  for (Ball& ball : scene.balls) {
    const Vector3<float> at = place();
    ball = {at.x, at.y, at.z, number(0.05f, 0.4f)};
  }
  return scene;
}

// Of numbers or of vectors of them.
template <class F> F lesser(F a, F b) { return a < b ? a : b; }
template <class F> F greater(F a, F b) { return a < b ? b : a; }
inline float root(float x) { return __builtin_sqrtf(x); }

// Four at once, by the compiler's vectors.
typedef float Four __attribute__((vector_size(16)));
inline Four root(Four x) {
  Four r = {};
  for (int i = 0; i < 4; ++i) r[i] = __builtin_sqrtf(x[i]);
  return r;
}

// Straightforward: every shape's formula, the least so far. F: float, or four points at once.
template <class F> F nearest(const Scene& scene, F x, F y, F z) {
  F least = x - x + 1e9f;
  const F zero = x - x;
  for (const Rod& rod : scene.rods) {
    F dx = x - rod.x, dy = y - rod.y, dz = z - rod.z;
    const F along = lesser(greater(dx * rod.axis_x + dy * rod.axis_y + dz * rod.axis_z, zero), zero + rod.length);
    dx -= along * rod.axis_x, dy -= along * rod.axis_y, dz -= along * rod.axis_z;
    least = lesser(least, root(dx * dx + dy * dy + dz * dz) - rod.radius);
  }
  for (const Block& block : scene.blocks) {
    const F dx = x - block.x, dy = y - block.y, dz = z - block.z;
    const F qx = greater(dx, -dx) - block.half_x, qy = greater(dy, -dy) - block.half_y, qz = greater(dz, -dz) - block.half_z;
    const F ox = greater(qx, zero), oy = greater(qy, zero), oz = greater(qz, zero);
    const F inside = lesser(greater(qx, greater(qy, qz)), zero);
    least = lesser(least, root(ox * ox + oy * oy + oz * oz) + inside);
  }
  for (const Ball& ball : scene.balls) {
    const F dx = x - ball.x, dy = y - ball.y, dz = z - ball.z;
    least = lesser(least, root(dx * dx + dy * dy + dz * dz) - ball.radius);
  }
  return least;
}

template <class S> S as(float x) {
  if constexpr (ScalarTraits<S>::is_fixed) return S(static_cast<double>(x));
  else return x;
}
template <class S> Vector3<S> as(float x, float y, float z) { return {as<S>(x), as<S>(y), as<S>(z)}; }

template <class S> using Builder = ImageBuilder<S, 2048>;
template <class S> void build(Builder<S>& builder, const Scene& scene) {
  bool first = true;
  const auto add = [&](const auto& shape) {
    builder.operation(shape);
    if (!first) builder.operation(SharpUnion<S>{});
    first = false;
  };
  for (const Rod& rod : scene.rods) {
    add(Capsule<S>(as<S>(rod.x, rod.y, rod.z), as<S>(rod.end.x, rod.end.y, rod.end.z), as<S>(rod.radius)));
  }
  for (const Block& b : scene.blocks) add(Box<S>{as<S>(b.x, b.y, b.z), as<S>(b.half_x, b.half_y, b.half_z)});
  for (const Ball& b : scene.balls) add(Sphere<S>{as<S>(b.x, b.y, b.z), as<S>(b.radius)});
  builder.finish();
}

double nanoseconds() {
  timespec now;
  clock_gettime(CLOCK_MONOTONIC, &now);
  return static_cast<double>(now.tv_sec) * 1e9 + static_cast<double>(now.tv_nsec);
}

// One way to find all distances: its least time, and what it found.
struct Way {
  const char* name;
  double least = 1e18;
  float distance[kPoints] = {};

  explicit Way(const char* what) : name(what) {}
};
template <class Work> void run(Way& way, const Work& work) {
  const double start = nanoseconds();
  work(way.distance);
  const double spent = (nanoseconds() - start) / kPoints;
  if (spent < way.least) way.least = spent;
}

float xs[kPoints], ys[kPoints], zs[kPoints];
template <class S> Vector3<S> points[kPoints];
template <class S> S distances[kPoints];
Builder<float> in_float;
Builder<Fixed<27>> in_fixed;
Way loop("float, loop by hand"), vectors("float, loop by hand, 4 points at once"), single("float, clearance()"),
    batch("float, clearance_distances()"), fixed("Fixed<27>, clearance()"),
    fixed_batch("Fixed<27>, clearance_distances()");
Way* const kWays[] = {&loop, &vectors, &single, &batch, &fixed, &fixed_batch};

template <class S> void ask_each(const Program<S>& program, float* distance) {
  for (uint32_t i = 0; i < kPoints; ++i)
    distance[i] = static_cast<float>(ScalarTraits<S>::to_double(clearance(program, points<S>[i]).distance));
}
template <class S> void ask_all(const Program<S>& program, float* distance) {
  clearance_distances(program, points<S>, kPoints, distances<S>);
  for (uint32_t i = 0; i < kPoints; ++i) distance[i] = static_cast<float>(ScalarTraits<S>::to_double(distances<S>[i]));
}

bool near(const Way& way, float tolerance) {
  for (uint32_t i = 0; i < kPoints; ++i) {
    const float off = way.distance[i] - loop.distance[i];
    if (!(off < tolerance && -off < tolerance)) {
      printf("%s: %g instead of %g\n", way.name, static_cast<double>(way.distance[i]), static_cast<double>(loop.distance[i]));
      return false;
    }
  }
  return true;
}

}  // namespace

int main() {
  const Scene scene = random_scene();
  build(in_float, scene);
  build(in_fixed, scene);
  const auto float_program = load<float>(in_float.words(), in_float.size() * 4);
  const auto fixed_program = load<Fixed<27>>(in_fixed.words(), in_fixed.size() * 4);
  for (uint32_t i = 0; i < kPoints; ++i) {
    const Vector3<float> p = place();
    xs[i] = p.x, ys[i] = p.y, zs[i] = p.z;
    points<float>[i] = p;
    points<Fixed<27>>[i] = as<Fixed<27>>(p.x, p.y, p.z);
  }
  for (int round = 0; round < kRounds; ++round) {
    run(loop, [&](float* distance) {
      for (uint32_t i = 0; i < kPoints; ++i) distance[i] = nearest(scene, xs[i], ys[i], zs[i]);
    });
    run(vectors, [&](float* distance) {
      for (uint32_t i = 0; i < kPoints; i += 4) {
        Four x, y, z;
        __builtin_memcpy(&x, xs + i, sizeof(x));
        __builtin_memcpy(&y, ys + i, sizeof(y));
        __builtin_memcpy(&z, zs + i, sizeof(z));
        const Four least = nearest(scene, x, y, z);
        __builtin_memcpy(distance + i, &least, sizeof(least));
      }
    });
    run(single, [&](float* distance) { ask_each(float_program, distance); });
    run(batch, [&](float* distance) { ask_all(float_program, distance); });
    run(fixed, [&](float* distance) { ask_each(fixed_program, distance); });
    run(fixed_batch, [&](float* distance) { ask_all(fixed_program, distance); });
  }
  printf("64 capsules, 16 boxes, 16 balls: ns a query, and times the loop by hand\n");
  for (const Way* way : kWays)
    printf("%-40s %8.1f %6.2f\n", way->name, way->least, way->least / loop.least);
  bool all_near = true;
  for (const Way* way : kWays) all_near = near(*way, 1e-3f) && all_near;
  return all_near ? 0 : 1;
}
