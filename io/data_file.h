#pragma once

#include <string>
#include <variant>

#include "fit/data_set.h"
#include "fit/model.h"

namespace raceway::io {

/// What a measurement file holds: rows with a measured quantity, or a shaft that coasts down.
using Measurement = std::variant<fit::DataSet, fit::CoastDownRecord>;

/// Reads a measurement CSV (columns with their units: DESIGN.md, Files) into SI.
///
/// Loads and temperature without a column come from `rig`; so does the inertia without which a
/// coast-down is no measurement. Coast-down rows below rig.minimum_speed are left out. Whatever was
/// filled in, ignored or left out is told in `notes`.
///
/// For a shaft the axial load is its external load, positive towards the tool, without a column
/// that of the arrangement.
///
/// Throws InputError: no speed or no measured column, an axial load neither in a column nor in
/// `rig`, a column that looks misspelt, and every cell that is empty, no number or impossible (all
/// of them in one message, the first ten in full).
[[nodiscard]] Measurement read_measurement(const std::string& path, const fit::Rig& rig,
                                           const fit::Shaft* shaft = nullptr);

/// The same from text; `source` stands in messages.
[[nodiscard]] Measurement parse_measurement(std::string text, const std::string& source,
                                            const fit::Rig& rig, const fit::Shaft* shaft = nullptr);

}  // namespace raceway::io
