#pragma once

#include <vector>

#include "bearing/operating_point.h"
#include "model/band.h"
#include "model/model.h"
#include "session/solve_point.h"

namespace raceway::cli {

/// A bearing at one operating point in a terminal: balls, stiffness, pressures, friction, life.
void print_state(const model::Model& model, const bearing::OperatingPoint& point,
                 const session::PointAnswer& answer);
void print_band(const model::Band& band, const std::vector<double>& half_widths);

}  // namespace raceway::cli
