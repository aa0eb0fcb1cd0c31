#include "draw/decimate.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace nearfield::host::draw {

std::size_t bucket_of(double time, double first, double last, std::size_t buckets) {
  if (!(last > first) || !(time > first)) return 0;
  const double position = (time - first) / (last - first) * static_cast<double>(buckets);
  const double greatest = static_cast<double>(buckets - 1);
  return static_cast<std::size_t>(position < greatest ? position : greatest);
}

std::vector<std::size_t> decimated(const std::vector<double>& times, const std::vector<double>& values,
                                   std::size_t buckets) {
  std::vector<std::size_t> kept;
  std::size_t i = 0;
  while (i < times.size()) {
    const std::size_t bucket = bucket_of(times[i], times.front(), times.back(), buckets);
    bool any = false;
    std::array<std::size_t, 4> chosen{};  // first, least, greatest, last
    for (; i < times.size() && bucket_of(times[i], times.front(), times.back(), buckets) == bucket; ++i) {
      if (!std::isfinite(values[i])) continue;
      if (!any) chosen = {i, i, i, i};
      any = true;
      if (values[i] < values[chosen[1]]) chosen[1] = i;
      if (values[i] > values[chosen[2]]) chosen[2] = i;
      chosen[3] = i;
    }
    if (!any) continue;
    std::sort(chosen.begin(), chosen.end());
    kept.insert(kept.end(), chosen.begin(), std::unique(chosen.begin(), chosen.end()));
  }
  return kept;
}

}  // namespace nearfield::host::draw
