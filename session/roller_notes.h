#pragma once

#include <string>
#include <vector>

#include "model/prediction.h"

namespace raceway::session {

/// Returns notes on a cylindrical roller bearing in equilibrium: a tilt that overloads the roller
/// ends, a load below the minimum load that prevents skidding, an inner ring without contact, and
/// pressures that cause dents. `dynamic_load_rating` and `radial_load` are in N, and `speed` is the
/// shaft speed [rad/s].
[[nodiscard]] std::vector<std::string> notes_on_rollers(
    const bearing::RollerBearing& bearing, const bearing::RollerEquilibrium& equilibrium,
    double dynamic_load_rating, double speed, double radial_load);
[[nodiscard]] std::vector<std::string> notes_on_rollers(
    const model::Model& model, const bearing::OperatingPoint& point,
    const model::FrictionPrediction& prediction);

}  // namespace raceway::session
