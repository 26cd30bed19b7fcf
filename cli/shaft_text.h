#pragma once

#include "bearing/operating_point.h"
#include "model/model.h"
#include "shaft/shaft_prediction.h"

namespace raceway::cli {

/// Prints the bearing sets of a shaft at one operating point: bearings, position, stiffness and
/// friction.
void print_shaft_state(const model::Model& model, const bearing::OperatingPoint& point,
                       const shaft::ShaftPrediction& prediction);

}  // namespace raceway::cli
