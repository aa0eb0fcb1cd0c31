// The number types that a field may be compiled for, chosen while the program runs.
#pragma once

#include <cstdint>

#include <nearfield/number/scalar.hpp>

namespace nearfield::host {

enum class FieldScalar : std::uint8_t { q27, q24, q16, single };  // Fixed<27>, Fixed<24>, Fixed<16>, float

template <class S>
inline constexpr FieldScalar field_scalar_of = FieldScalar::single;
template <>
inline constexpr FieldScalar field_scalar_of<Fixed<27>> = FieldScalar::q27;
template <>
inline constexpr FieldScalar field_scalar_of<Fixed<24>> = FieldScalar::q24;
template <>
inline constexpr FieldScalar field_scalar_of<Fixed<16>> = FieldScalar::q16;

// What use(zero) returns, zero a number of that type.
template <class Use>
auto with_scalar(FieldScalar scalar, const Use& use) {
  switch (scalar) {
    case FieldScalar::q27:
      return use(Fixed<27>{});
    case FieldScalar::q24:
      return use(Fixed<24>{});
    case FieldScalar::q16:
      return use(Fixed<16>{});
    case FieldScalar::single:
      break;
  }
  return use(0.0F);
}

}  // namespace nearfield::host
