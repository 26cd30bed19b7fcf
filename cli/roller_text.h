#pragma once

#include "bearing/operating_point.h"
#include "model/model.h"
#include "session/solve_point.h"

namespace raceway::cli {

/// Prints a cylindrical roller bearing at one operating point: rollers, stiffness, pressures,
/// friction, life.
void print_roller_state(const model::Model& model, const bearing::OperatingPoint& point,
                        const session::PointAnswer& answer);

}  // namespace raceway::cli
