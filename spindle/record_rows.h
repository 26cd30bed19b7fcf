#pragma once

#include <vector>

#include "record/record.h"
#include "spindle/spindle.h"

namespace raceway::spindle {

/// Returns the rows of a record or of a speed programme in SI. Temperatures, motor heat and belt
/// force without a column are NaN, which means the value of the model. A motor power without a
/// column is unknown. Other loads without a column are 0, and a coolant without a column is on.
/// Throws std::invalid_argument if a time or a speed is missing or not a number, if the times do
/// not rise, or if the record is longer than 10 years. The message gives the row.
[[nodiscard]] std::vector<ProfileRow> profile_of(const record::Record& record);

/// Returns the channels that can be compared with a simulation: the sensors in the order of the
/// model, then the displacement (not for a network).
[[nodiscard]] std::vector<const record::Channel*> measured_channels(const model::Spindle& spindle);

/// Returns the simulated readings of measured_channels() at one moment, in the same order [SI].
[[nodiscard]] std::vector<double> readings_of(const Moment& moment, const model::Spindle& spindle);

}  // namespace raceway::spindle
