#pragma once

#include <string>
#include <vector>

#include "record/record.h"
#include "verdict/compare.h"

namespace raceway::cli {

/// Errors of models in a terminal.
/// One model against each measured channel.
void print_comparison(const std::string& model, const std::vector<verdict::Comparison>& comparisons,
                      const record::Record& data);
/// Several, a ladder for each channel of the first.
void print_ladders(const std::vector<std::string>& models,
                   const std::vector<std::vector<verdict::Comparison>>& comparisons);

}  // namespace raceway::cli
