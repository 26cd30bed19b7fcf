#pragma once

#include <vector>

#include "record/record.h"
#include "spindle/spindle.h"

namespace raceway::spindle {

/// Returns the rows of a record or of a speed programme in SI units. Speeds become absolute values.
///
/// If the record has no column for a temperature, the motor heat or the belt force, this input is
/// NaN, and the simulation uses the value of the model. If the record has no column for the motor
/// power, the motor power is NaN (unknown). Loads at the nose without a column are 0. Without a
/// column for the coolant, the coolant is on.
///
/// The inputs of a ProfileRow apply from the time of the previous row to the time of this row. If
/// the record has SettingsHold::until_row, all inputs of a ProfileRow come from the record row with
/// the same time. Otherwise, the settings in a record row apply until the next row. A ProfileRow
/// then takes only its temperatures from the record row with the same time, and all other inputs
/// from the record row before. The first ProfileRow has all inputs of the first record row.
///
/// Throws std::invalid_argument if the column of time or speed is missing, if an input column has
/// no number in a row, if the times do not increase, or if the record is longer than 10 years.
[[nodiscard]] std::vector<ProfileRow> profile_of(const record::Record& record);

/// Returns the channels that a simulation predicts: the sensors in the order of the model, then the
/// axial displacement. A model with [network] has no displacement.
[[nodiscard]] std::vector<const record::Channel*> measured_channels(const model::Spindle& spindle);

/// Returns the simulated readings at one time in SI units, in the order of measured_channels().
[[nodiscard]] std::vector<double> readings_of(const Moment& moment, const model::Spindle& spindle);

}  // namespace raceway::spindle
