// Programs of Fixed<16>, compiled once for the host's library and the tests.
#undef NEARFIELD_PROGRAMS_COMPILED_ONCE
#include <nearfield/field/program.hpp>

namespace nearfield {

NEARFIELD_PROGRAMS(, Fixed<16>)

}  // namespace nearfield
