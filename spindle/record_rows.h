#pragma once

#include <vector>

#include "record/record.h"
#include "spindle/spindle.h"

namespace raceway::spindle {

/// The rows of a record, or of a speed programme, in its units of SI: what no column tells is left
/// to the model, a coolant that no column tells of is on. Throws std::invalid_argument, with the
/// place, where time or speed is missing or no number, and where time does not rise.
[[nodiscard]] std::vector<ProfileRow> profile_of(const record::Record& record);

/// What a simulation of the spindle can be held against: the sensors in the order of the model, the
/// displacement behind them; that not of a network.
[[nodiscard]] std::vector<const record::Channel*> measured_channels(const model::Spindle& spindle);

/// Of those channels at one moment, in that order [SI].
[[nodiscard]] std::vector<double> readings_of(const Moment& moment, const model::Spindle& spindle);

}  // namespace raceway::spindle
