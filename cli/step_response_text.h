#pragma once

#include "session/spindle_steps.h"

namespace raceway::cli {

/// Prints step responses, one row each, and their laws.
void print_steps(const session::SpindleSteps& steps);

}  // namespace raceway::cli
