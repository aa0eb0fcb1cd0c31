// Programs of every operation, compiled once for all images that evaluate them.
#undef NEARFIELD_PROGRAMS_COMPILED_ONCE
#include <nearfield/field/program.hpp>

namespace nearfield {

NEARFIELD_PROGRAMS(, Fixed<27>)

}  // namespace nearfield
