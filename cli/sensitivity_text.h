#pragma once

#include "results/sensitivity_results.h"

namespace raceway::cli {

/// Prints a table for each predicted quantity: the data of the model, largest influence first. The
/// influence of a datum is the change of the prediction if the datum changes by its spread. Unless
/// `all` is true, the table omits data that cause less than 0.1 % of the sum of the squared changes
/// (and, if Sobol' indices were computed, less than 0.1 % of the variance).
void print_sensitivity(const results::Sensitivity& sensitivity, bool all);

}  // namespace raceway::cli
