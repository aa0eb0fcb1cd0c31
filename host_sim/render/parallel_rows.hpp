// Work on rows by several threads. What is written does not depend on their number as long as rows are
// independent.
#pragma once

#include <cstddef>
#include <functional>

namespace nearfield::host {

// Called by the calling thread alone, with what is done from 0 to 1.
using ReportProgress = std::function<void(double done)>;

// Calls work(row) once for each row from 0 to count - 1, from `threads` threads at once (0: as many as the
// machine has). The first exception that a row throws is thrown again when all threads have ended.
void for_each_row(std::size_t count, unsigned threads, const std::function<void(std::size_t row)>& work,
                  const ReportProgress& report = {});

}  // namespace nearfield::host
