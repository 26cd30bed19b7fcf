#include "cli/process.h"

namespace raceway::cli {

// A page has no signals and no second thread. Its worker is ended instead, and all that a question
// wrote goes with it.

void start_process() {}

struct InterruptFlag::Clock {};

InterruptFlag::InterruptFlag(double) {}

InterruptFlag::~InterruptFlag() = default;

const std::atomic<bool>& InterruptFlag::raised() {
  static const std::atomic<bool> never{false};
  return never;
}

}  // namespace raceway::cli
