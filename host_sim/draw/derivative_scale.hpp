#pragma once

#include <string>

namespace nearfield::host::draw {

/// The greatest factor 1, 0.5, 0.2, 0.1, 0.05 ... that brings a magnitude (finite, >= 0) to 1.2 or below.
double derivative_scale(double greatest_magnitude);

/// Such a factor as it stands before what it multiplies: nothing for 1, `0.05 `, `2·10⁻⁶ `.
std::string scale_text(double scale);

/// A whole number in superscript digits: `⁻²⁰`.
std::string superscript(int number);

}  // namespace nearfield::host::draw
