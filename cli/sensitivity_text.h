#pragma once

#include "io/sensitivity_results.h"

namespace raceway::cli {

/// Which datum matters most, in a terminal; `all`: with those that hardly do.
void print_sensitivity(const io::Sensitivity& sensitivity, bool all);

}  // namespace raceway::cli
