#pragma once

#include "session/spindle_run.h"
#include "session/spindle_steady.h"

/// Part of `raceway spindle`; not for other code.
namespace raceway::cli {

/// One steady state in full, several as a table of speeds.
void print_steady(const session::SteadySpindle& found);

/// The end of a run, and its extremes.
void print_run(const session::SpindleRun& found);

}  // namespace raceway::cli
