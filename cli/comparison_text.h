#pragma once

#include <string>
#include <vector>

#include "record/record.h"
#include "verdict/compare.h"

namespace raceway::cli {

/// Prints the errors of one model against each measured channel.
void print_comparison(const std::string& model, const std::vector<verdict::Comparison>& comparisons,
                      const record::Record& data);
/// Prints the errors of several models, one ladder for each channel of the first.
void print_ladders(const std::vector<std::string>& models,
                   const std::vector<std::vector<verdict::Comparison>>& comparisons);

}  // namespace raceway::cli
