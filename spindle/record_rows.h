#pragma once

#include <vector>

#include "record/record.h"
#include "spindle/spindle.h"

namespace raceway::spindle {

/// The rows of a record, or of a speed programme, in SI: inputs without a column are left to the
/// model; without a column of its state, the coolant is on. Throws std::invalid_argument, with the
/// place, where time or speed is missing or no number, where time does not rise, and for more than
/// 10 years.
[[nodiscard]] std::vector<ProfileRow> profile_of(const record::Record& record);

/// Channels that can be compared with a simulation of the spindle: the sensors in the order of the
/// model, then the displacement, except for a network.
[[nodiscard]] std::vector<const record::Channel*> measured_channels(const model::Spindle& spindle);

/// Simulated readings of measured_channels() at one moment, in their order [SI].
[[nodiscard]] std::vector<double> readings_of(const Moment& moment, const model::Spindle& spindle);

}  // namespace raceway::spindle
