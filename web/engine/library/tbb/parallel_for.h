#pragma once

#include <tbb/partitioner.h>

// Loops of TBB where there is one thread: the engine of the workbench. Partitioners, arenas and
// limits are those of tests/threads/tbb.
namespace tbb {

/// Which loops end with which; here each for itself.
struct task_group_context {
  enum kind { isolated };
  explicit task_group_context(kind) {}
};

/// Every index in its order.
template <typename Index, typename Body>
void parallel_for(Index first, Index last, const Body& body, simple_partitioner = {}) {
  for (; first < last; ++first) body(first);
}

template <typename Index, typename Body>
void parallel_for(Index first, Index last, const Body& body, task_group_context&) {
  parallel_for(first, last, body);
}

}  // namespace tbb
