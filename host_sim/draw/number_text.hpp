#pragma once

#include <string>

namespace nearfield::host::draw {

/// `value` with exactly `decimals` (0..9) digits after the point, correctly rounded, without regard to locale
/// and never "-0". Throws std::invalid_argument unless value is finite and its magnitude below 1e15.
std::string fixed_text(double value, int decimals);

/// As fixed_text, without trailing zeros.
std::string short_text(double value, int decimals);

/// A length in metres in the unit that reads best: "86 mm" below 1 m, "1.25 m" from there on.
std::string length_text(double metres);

}  // namespace nearfield::host::draw
