#pragma once

#include "results/sensitivity_results.h"

namespace raceway::cli {

/// Prints the data of the model in order of influence; `all` includes data of little influence.
void print_sensitivity(const results::Sensitivity& sensitivity, bool all);

}  // namespace raceway::cli
