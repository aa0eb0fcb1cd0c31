// Programs of Fixed<24>, compiled once for the host's library and the tests.
#undef NEARFIELD_PROGRAMS_COMPILED_ONCE
#include <nearfield/field/program.hpp>

namespace nearfield {

NEARFIELD_PROGRAMS(, Fixed<24>)

}  // namespace nearfield
