#include "compile/field_compiler.hpp"

#include <algorithm>

#include "compile/field_emitter.hpp"

namespace nearfield::host {
namespace {

void add_solid(FieldEmitter& emitter, const CollisionShape& solid, const Vector3d& at) {
  const Vector3d half{0.0, 0.0, 0.5 * solid.length};
  switch (solid.kind) {
    case CollisionKind::sphere:
      return emitter.operation([&](auto zero) {
        using S = decltype(zero);
        return Sphere<S>{quantise<S>(at), quantise<S>(solid.radius)};
      });
    case CollisionKind::box:
      return emitter.operation([&](auto zero) {
        using S = decltype(zero);
        return Box<S>{quantise<S>(at), quantise<S>(0.5 * solid.size)};
      });
    case CollisionKind::cylinder:
      return emitter.operation([&](auto zero) {
        using S = decltype(zero);
        return Cylinder<S>{quantise<S>(at), quantise<S>(solid.radius), quantise<S>(0.5 * solid.length)};
      });
    case CollisionKind::capsule:
      return emitter.operation(
          [&](auto zero) { return quantise_capsule<decltype(zero)>(at - half, at + half, solid.radius); });
  }
}

}  // namespace

template <class S>
CompiledField<S> compile_field(const FieldNode& root, const std::string& file,
                               const SlotOfLink& slot_of_link) {
  FieldEmitter emitter(field_scalar_of<S>, file, slot_of_link);
  emitter.operand(root);
  return emitter.finish<S>([&](std::size_t step, LoadStatus status) { emitter.fail(root, step, status); });
}

template <class S>
CompiledField<S> compile_obstacles(const std::vector<CollisionShape>& solids, const std::string& file,
                                   const std::string& path) {
  const SlotOfLink none;
  FieldEmitter emitter(field_scalar_of<S>, file, none);
  std::vector<std::size_t> first_steps;
  for (std::size_t i = 0; i < solids.size(); ++i) {
    first_steps.push_back(emitter.step_count());
    emitter.placed(solids[i].origin, [&](const Vector3d& at) { add_solid(emitter, solids[i], at); });
    if (i != 0) emitter.operation([](auto zero) { return SharpUnion<decltype(zero)>{}; });
  }
  return emitter.finish<S>([&](std::size_t step, LoadStatus status) {
    const auto after = std::upper_bound(first_steps.begin() + 1, first_steps.end(), step);
    const auto culprit = static_cast<std::size_t>(after - first_steps.begin()) - 1;
    emitter.fail(solids[culprit].position, path + "[" + std::to_string(culprit) + "]", status);
  });
}

#define NEARFIELD_INSTANTIATE(S)                                                                      \
  template CompiledField<S> compile_field(const FieldNode&, const std::string&, const SlotOfLink&);   \
  template CompiledField<S> compile_obstacles(const std::vector<CollisionShape>&, const std::string&, \
                                              const std::string&);
NEARFIELD_INSTANTIATE(Fixed<27>)
NEARFIELD_INSTANTIATE(Fixed<24>)
NEARFIELD_INSTANTIATE(Fixed<16>)
NEARFIELD_INSTANTIATE(float)
#undef NEARFIELD_INSTANTIATE

}  // namespace nearfield::host
