#pragma once

#include <string>

#include "bearing/operating_point.h"
#include "friction/heat.h"
#include "model/judgement.h"
#include "model/prediction.h"
#include "results/band_of_result.h"

namespace raceway::results {

/// Returns the document of `raceway solve --json` for a cylindrical roller bearing. If the
/// operating point has no equilibrium, its results are null.
[[nodiscard]] std::string roller_solve_json(const model::Model& model,
                                            const bearing::OperatingPoint& point,
                                            const model::FrictionPrediction& friction,
                                            const friction::HeatSplit& heat,
                                            const BandOfResult* band = nullptr,
                                            const model::Findings& findings = {});

}  // namespace raceway::results
