#pragma once

namespace tbb::this_task_arena {

/// No thread here takes up work of another loop while it waits.
void isolate(const auto& work) { work(); }

}  // namespace tbb::this_task_arena
