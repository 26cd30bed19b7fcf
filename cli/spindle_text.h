#pragma once

#include "session/spindle_run.h"
#include "session/spindle_steady.h"

/// Text output of `raceway spindle`; not for other code.
namespace raceway::cli {

/// Prints one steady state in full, or several as a table of speeds.
void print_steady(const session::SteadySpindle& found);

/// Prints the end of a run, and its extremes.
void print_run(const session::SpindleRun& found);

}  // namespace raceway::cli
