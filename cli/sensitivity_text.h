#pragma once

#include "results/sensitivity_results.h"

namespace raceway::cli {

/// Prints a table for each predicted quantity: the data of the model, largest influence first. The
/// influence of a datum is the change of the prediction if the datum changes by its spread. Unless
/// `all` is true, the table omits each datum whose squared change is less than 0.1 % of the sum of
/// the squared changes of all data. If Sobol' indices were computed, an omitted datum also causes
/// less than 0.1 % of the variance of the prediction.
void print_sensitivity(const results::Sensitivity& sensitivity, bool all);

}  // namespace raceway::cli
