#pragma once

#include "results/sensitivity_results.h"

namespace raceway::cli {

/// Prints the numbers of the model in the order of their influence. Numbers that contribute less
/// than 0.1 % of the squared change of the result are omitted, unless `all` is true.
void print_sensitivity(const results::Sensitivity& sensitivity, bool all);

}  // namespace raceway::cli
