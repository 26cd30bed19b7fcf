#pragma once

#include <string>

#include "model/band.h"
#include "shaft/shaft_prediction.h"

namespace raceway::cli {

/// Runs `raceway solve` for a model with an arrangement. Returns the exit status. `band` may be
/// null.
[[nodiscard]] int solve_shaft(const std::string& file, const model::Model& model,
                              const shaft::ShaftPoint& point, bool json, const model::Band* band);

}  // namespace raceway::cli
