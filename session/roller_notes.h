#pragma once

#include <string>
#include <vector>

#include "model/prediction.h"

namespace raceway::session {

/// Notes on a cylindrical roller bearing at a point where it is in balance: a
/// tilt that overloads the ends of the rollers, too little load against skidding, no contact at the
/// inner ring, pressures that leave dents.
[[nodiscard]] std::vector<std::string> notes_on_rollers(
    const bearing::RollerBearing& bearing, const bearing::RollerEquilibrium& equilibrium,
    double dynamic_load_rating, double speed, double radial_load);
[[nodiscard]] std::vector<std::string> notes_on_rollers(
    const model::Model& model, const bearing::OperatingPoint& point,
    const model::FrictionPrediction& prediction);

}  // namespace raceway::session
