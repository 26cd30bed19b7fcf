#pragma once

#include <string_view>

#include "bearing/frequencies.h"
#include "bearing/operating_point.h"
#include "model/band.h"
#include "model/bearing_life.h"
#include "model/model.h"
#include "session/solve_point.h"

namespace raceway::cli {

/// Prints a bearing at one operating point: balls, stiffness, pressures, friction, life.
void print_state(const model::Model& model, const bearing::OperatingPoint& point,
                 const session::PointAnswer& answer);
/// Prints the friction torque, the contributions to the torque, the power loss, and the heat into
/// inner and outer ring.
void print_torque(const model::Model& model, const model::FrictionPrediction& friction,
                  const friction::HeatSplit& heat);

/// Prints life, static safety, cage speed and the ball-pass frequency of the outer race. `speed` is
/// the shaft speed [rad/s], and `element` is "ball" or "roller".
void print_life(const model::BearingLife& life, const bearing::BearingFrequencies& turns,
                double speed, std::string_view element);

void print_band(const model::Band& band, const session::PointAnswer& answer);

}  // namespace raceway::cli
