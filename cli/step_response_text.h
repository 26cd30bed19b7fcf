#pragma once

#include "session/spindle_steps.h"

namespace raceway::cli {

/// Prints step responses, one row each, and the laws K(P) and T(P).
void print_steps(const session::SpindleSteps& steps);

}  // namespace raceway::cli
