#pragma once

#include <string>
#include <vector>

#include "record/record.h"
#include "verdict/compare.h"

namespace raceway::cli {

/// Prints the errors of one model for each measured channel.
void print_comparison(const std::string& model, const std::vector<verdict::Comparison>& comparisons,
                      const record::Record& data);
/// Prints one table of errors for each measured channel of the first model. The table has one row
/// for each model.
void print_ladders(const std::vector<std::string>& models,
                   const std::vector<std::vector<verdict::Comparison>>& comparisons);

}  // namespace raceway::cli
