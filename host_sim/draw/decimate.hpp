#pragma once

#include <cstddef>
#include <vector>

namespace nearfield::host::draw {

/// Indices (ascending) of the samples that show a series in `buckets` (>= 1) equal spans of its time axis: of
/// each span the first, the last, the least and the greatest sample, so that no minimum and no maximum is
/// lost. Samples that are not finite are left out. `times` ascends; both lists have the same length.
std::vector<std::size_t> decimated(const std::vector<double>& times, const std::vector<double>& values,
                                   std::size_t buckets);

/// The span, 0..buckets-1, that `time` falls into when [first, last] is cut into `buckets` equal spans.
std::size_t bucket_of(double time, double first, double last, std::size_t buckets);

}  // namespace nearfield::host::draw
