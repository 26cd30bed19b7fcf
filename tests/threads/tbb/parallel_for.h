#pragma once

#include <tbb/global_control.h>
#include <tbb/partitioner.h>

#include <algorithm>
#include <exception>
#include <thread>
#include <vector>

namespace tbb {

/// Which loops end with which; here each for itself.
struct task_group_context {
  enum kind { isolated };
  explicit task_group_context(kind) {}
};

/// Every index by one of several threads, in turns: each thread has its share, however short the
/// work, and nothing but the end of the loop puts them in order.
template <typename Index, typename Body>
void parallel_for(Index first, Index last, const Body& body, simple_partitioner = {}) {
  if (!(first < last)) return;
  const auto count = static_cast<std::size_t>(last - first);
  const std::size_t threads = std::min(count, global_control::limit);
  std::vector<std::exception_ptr> problems(threads);
  const auto share = [&](std::size_t mine) {
    try {
      for (std::size_t i = mine; i < count; i += threads) body(first + static_cast<Index>(i));
    } catch (...) {
      problems[mine] = std::current_exception();
    }
  };
  {
    std::vector<std::jthread> others;
    for (std::size_t k = 1; k < threads; ++k) others.emplace_back(share, k);
    share(0);
  }
  for (const std::exception_ptr& problem : problems)
    if (problem) std::rethrow_exception(problem);
}

template <typename Index, typename Body>
void parallel_for(Index first, Index last, const Body& body, task_group_context&) {
  parallel_for(first, last, body);
}

}  // namespace tbb
