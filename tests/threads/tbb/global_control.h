#pragma once

#include <cstddef>

// What this project uses of TBB, made of threads that the thread sanitizer sees: Debian's library
// is not built for it, and passes for a race wherever it hands work over. For the preset `threads`
// alone, which has this folder in front of the library's.
namespace tbb {

/// How many threads share the work, while it lives.
class global_control {
 public:
  enum parameter { max_allowed_parallelism };

  global_control(parameter, std::size_t threads) : before_(limit) { limit = threads; }
  ~global_control() { limit = before_; }
  global_control(const global_control&) = delete;
  global_control& operator=(const global_control&) = delete;

  /// More than there are cores: a race needs two threads, not two cores.
  static inline std::size_t limit = 4;

 private:
  std::size_t before_;
};

}  // namespace tbb
