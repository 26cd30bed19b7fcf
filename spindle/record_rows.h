#pragma once

#include <vector>

#include "record/record.h"
#include "spindle/spindle.h"

namespace raceway::spindle {

/// Returns the rows of a record or of a speed programme in SI. If an input has no column, its value
/// comes from the model. If the coolant state has no column, the coolant is on. Throws
/// std::invalid_argument with the place if time or speed is missing or not a number, if time does
/// not rise, and if the time exceeds 10 years.
[[nodiscard]] std::vector<ProfileRow> profile_of(const record::Record& record);

/// Returns the channels that can be compared with a simulation: the sensors in the order of the
/// model, then the displacement (not for a network).
[[nodiscard]] std::vector<const record::Channel*> measured_channels(const model::Spindle& spindle);

/// Returns the simulated readings of measured_channels() at one moment, in the same order [SI].
[[nodiscard]] std::vector<double> readings_of(const Moment& moment, const model::Spindle& spindle);

}  // namespace raceway::spindle
