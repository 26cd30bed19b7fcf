#pragma once

#include "session/spindle_steps.h"

namespace raceway::cli {

/// Prints a table of step responses with one row for each response. Also prints the fitted formulas
/// for the gain K(P) and the time constant T(P) as functions of the power P.
void print_steps(const session::SpindleSteps& steps);

}  // namespace raceway::cli
