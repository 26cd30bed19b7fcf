#pragma once

#include "session/spindle_run.h"
#include "session/spindle_steady.h"

/// Prints the results of `raceway spindle` as text.
namespace raceway::cli {

/// Prints one steady state in full, or several steady states as a table over speed.
void print_steady(const session::SteadySpindle& found);

/// Prints the state at the end of a run, the smallest and largest displacement of the nose, and the
/// largest axial force of the front set.
void print_run(const session::SpindleRun& found);

}  // namespace raceway::cli
