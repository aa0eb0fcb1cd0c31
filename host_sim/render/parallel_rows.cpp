#include "render/parallel_rows.hpp"

#include <algorithm>
#include <atomic>
#include <exception>
#include <mutex>
#include <system_error>
#include <thread>
#include <vector>

namespace nearfield::host {
namespace {

class Rows {
 public:
  Rows(std::size_t count, const std::function<void(std::size_t)>& work) : count_(count), work_(work) {}

  void take(const ReportProgress& report) {
    for (std::size_t row = next_++; row < count_; row = next_++) {
      try {
        work_(row);
      } catch (...) {
        const std::lock_guard<std::mutex> lock(mutex_);
        if (!failure_) failure_ = std::current_exception();
        next_ = count_;
      }
      ++done_;
      if (report) report(static_cast<double>(done_) / static_cast<double>(count_));
    }
  }
  void rethrow() const {
    if (failure_) std::rethrow_exception(failure_);
  }

 private:
  std::size_t count_;
  const std::function<void(std::size_t)>& work_;
  std::atomic<std::size_t> next_{0}, done_{0};
  std::mutex mutex_;
  std::exception_ptr failure_;
};

}  // namespace

void for_each_row(std::size_t count, unsigned threads, const std::function<void(std::size_t)>& work,
                  const ReportProgress& report) {
  const unsigned wanted = threads != 0 ? threads : std::max(1U, std::thread::hardware_concurrency());
  Rows rows(count, work);
  std::vector<std::thread> others;
  try {
    for (std::size_t i = 1; i < std::min<std::size_t>(wanted, count); ++i) {
      others.emplace_back([&rows] { rows.take({}); });
    }
  } catch (const std::system_error&) {
    // The machine has no more threads to give: those that there are do all the work.
  }
  rows.take(report);
  for (std::thread& other : others) other.join();
  rows.rethrow();
}

}  // namespace nearfield::host
