#pragma once

#include <tbb/partitioner.h>

// Replacement for the parallel loops of TBB: the loops run in a single thread, for the engine of
// the workbench in the browser. Partitioners, arenas and limits come from tests/threads/tbb.
namespace tbb {

/// Replacement of the TBB class that can cancel a group of loops. This replacement does not cancel
/// loops.
struct task_group_context {
  enum kind { isolated };
  explicit task_group_context(kind) {}
};

/// Calls the body for every index in order.
template <typename Index, typename Body>
void parallel_for(Index first, Index last, const Body& body, simple_partitioner = {}) {
  for (; first < last; ++first) body(first);
}

template <typename Index, typename Body>
void parallel_for(Index first, Index last, const Body& body, task_group_context&) {
  parallel_for(first, last, body);
}

}  // namespace tbb
