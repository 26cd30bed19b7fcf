#pragma once

#include "results/sensitivity_results.h"

namespace raceway::cli {

/// Which datum matters most, in a terminal; `all`: with those that hardly do.
void print_sensitivity(const results::Sensitivity& sensitivity, bool all);

}  // namespace raceway::cli
