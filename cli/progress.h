#pragma once

#include <chrono>
#include <cstddef>
#include <string>
#include <string_view>

namespace raceway::cli {

/// Returns a line such as `[####......] 42 % 12 s left step` in at most `width` characters. `share`
/// is the finished share of the work, from 0 to 1. `step` names the current step. The remaining
/// time follows from `share` and `elapsed` [s]. At the beginning, the remaining time is omitted.
[[nodiscard]] std::string progress_line(double share, double elapsed, std::string_view step,
                                        std::size_t width);

/// Progress bar on stderr during a long calculation. The bar disappears at the end. Create a
/// Progress only if shows_progress() returns true.
class Progress {
 public:
  Progress();
  ~Progress();
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;

  /// Shows the finished share of the work; 1 means that the results are calculated and written.
  void show(double share, std::string_view step = {});

 private:
  using Clock = std::chrono::steady_clock;
  Clock::time_point start_, shown_;
};

}  // namespace raceway::cli
