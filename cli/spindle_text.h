#pragma once

#include "session/spindle_run.h"
#include "session/spindle_steady.h"

/// Text output, used only by `raceway spindle`.
namespace raceway::cli {

/// Prints one steady state in full, or several steady states as a table over speed.
void print_steady(const session::SteadySpindle& found);

/// Prints the state at the end of a run and the extremes of the run.
void print_run(const session::SpindleRun& found);

}  // namespace raceway::cli
