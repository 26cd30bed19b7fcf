#pragma once

#include "results/sensitivity_results.h"

namespace raceway::cli {

/// Prints a table for each predicted quantity. The table lists the input values of the model,
/// largest influence first. The influence of an input value is the change of the prediction if the
/// value changes by its spread (its possible error). If `all` is false, the table omits each input
/// value whose squared influence is less than 0.1 % of the sum of all squared influences. If Sobol'
/// indices were computed, an omitted value also causes less than 0.1 % of the variance of the
/// prediction.
void print_sensitivity(const results::Sensitivity& sensitivity, bool all);

}  // namespace raceway::cli
