#pragma once

#include "results/sensitivity_results.h"

namespace raceway::cli {

/// Prints the numbers of the model in the order of their influence. If `all` is true, the table
/// includes numbers with a share below 0.1 %.
void print_sensitivity(const results::Sensitivity& sensitivity, bool all);

}  // namespace raceway::cli
