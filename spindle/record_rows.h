#pragma once

#include <vector>

#include "record/record.h"
#include "spindle/spindle.h"

namespace raceway::spindle {

/// Returns the rows of a record or of a speed programme in SI units. If the record has no column
/// for a temperature, the motor heat or the belt force, the input is NaN, and the model gives the
/// value. A motor power without a column is unknown (NaN). Nose loads without a column are 0, and a
/// coolant without a column is on. Speeds become absolute values. The inputs of a ProfileRow apply
/// from the time of the previous row to its own time. If the record has SettingsHold::until_row,
/// all inputs of a ProfileRow come from the same row of the record. Otherwise, the settings of the
/// record apply from their row to the next row: a ProfileRow has the temperatures of its own row
/// and all other inputs of the previous row. The first ProfileRow has all inputs of the first row.
/// Throws std::invalid_argument if the column of time or speed is missing, if an input column has
/// no number in a row, if the times do not increase, or if the record is longer than 10 years.
[[nodiscard]] std::vector<ProfileRow> profile_of(const record::Record& record);

/// Returns the channels that a simulation predicts: the sensors in the order of the model, then the
/// axial displacement. A network has no displacement.
[[nodiscard]] std::vector<const record::Channel*> measured_channels(const model::Spindle& spindle);

/// Returns the simulated readings at one time, in the order of measured_channels() [SI].
[[nodiscard]] std::vector<double> readings_of(const Moment& moment, const model::Spindle& spindle);

}  // namespace raceway::spindle
