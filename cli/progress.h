#pragma once

#include <chrono>
#include <cstddef>
#include <string>
#include <string_view>

namespace raceway::cli {

/// `[####......]  42 %  12 s left  step` in at most `width` characters; `elapsed` [s] says how fast
/// it goes.
[[nodiscard]] std::string progress_line(double share, double elapsed, std::string_view step,
                                        std::size_t width);

/// A bar on stderr while long work is going on, and nothing left of it afterwards. To be made only
/// where shows_progress().
class Progress {
 public:
  Progress();
  ~Progress();
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;

  /// The share that is done, 1 where nothing is left to do, files among it.
  void show(double share, std::string_view step = {});

 private:
  using Clock = std::chrono::steady_clock;
  Clock::time_point start_, shown_;
};

}  // namespace raceway::cli
