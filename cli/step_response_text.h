#pragma once

#include "session/spindle_steps.h"

namespace raceway::cli {

/// Prints step responses, one row each, and the laws of gain K(P) and time constant T(P) over the
/// power P.
void print_steps(const session::SpindleSteps& steps);

}  // namespace raceway::cli
