#pragma once

#include "session/spindle_steps.h"

namespace raceway::cli {

/// Step responses, one row each, and their laws, for a terminal.
void print_steps(const session::SpindleSteps& steps);

}  // namespace raceway::cli
