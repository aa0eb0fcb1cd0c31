#include "draw/axis.hpp"

#include <cmath>

#include "draw/number_text.hpp"

namespace nearfield::host::draw {
namespace {

/// 10 to the power |exponent|, exact up to 22.
double power_of_ten(int exponent) {
  double power = 1.0;
  for (int i = 0; i < (exponent < 0 ? -exponent : exponent); ++i) power *= 10.0;
  return power;
}

/// mantissa * 10^exponent, correctly rounded for small exponents.
double scaled(double mantissa, int exponent) {
  return exponent < 0 ? mantissa / power_of_ten(exponent) : mantissa * power_of_ten(exponent);
}

}  // namespace

std::vector<Tick> round_ticks(double low, double high, std::size_t greatest_count) {
  std::vector<Tick> ticks;
  if (!std::isfinite(low) || !std::isfinite(high) || !(low < high)) return ticks;
  for (int exponent = -9; exponent <= 12; ++exponent) {
    for (const int mantissa : {1, 2, 5}) {
      const double step = scaled(mantissa, exponent);
      const double slack = step * 1e-6;
      const double first = std::ceil((low - slack) / step);
      const double last = std::floor((high + slack) / step);
      if (last - first + 1.0 > static_cast<double>(greatest_count)) continue;
      for (double k = first; k <= last; k += 1.0) {
        const double value = scaled(k * mantissa, exponent);
        ticks.push_back({value, fixed_text(value, exponent < 0 ? -exponent : 0)});
      }
      return ticks;
    }
  }
  return ticks;
}

double round_up(double value) {
  if (!std::isfinite(value) || !(value > 0.0)) return 1.0;
  for (int exponent = -9; exponent <= 15; ++exponent) {
    for (const double mantissa : {1.0, 1.5, 2.0, 3.0, 4.0, 5.0, 6.0, 8.0}) {
      const double candidate = scaled(mantissa, exponent);
      if (candidate >= value) return candidate;
    }
  }
  return value;
}

std::vector<double> spread_apart(const std::vector<double>& wanted, double gap, double low, double high) {
  const std::size_t count = wanted.size();
  std::vector<double> placed = wanted;
  if (count == 0) return placed;
  if (gap * static_cast<double>(count - 1) > high - low) {
    for (std::size_t i = 0; i < count; ++i) {
      placed[i] = low + (high - low) * static_cast<double>(i) / static_cast<double>(count - 1);
    }
    return placed;
  }
  for (std::size_t i = 0; i < count; ++i) {
    const double least = i == 0 ? low : placed[i - 1] + gap;
    if (placed[i] < least) placed[i] = least;
  }
  for (std::size_t i = count; i-- > 0;) {
    const double most = i + 1 == count ? high : placed[i + 1] - gap;
    if (placed[i] > most) placed[i] = most;
  }
  return placed;
}

}  // namespace nearfield::host::draw
