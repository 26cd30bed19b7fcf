#pragma once

#include <nlohmann/json.hpp>
#include <string>

#include "bearing/solve.h"
#include "io/band_of_result.h"
#include "model/model.h"
#include "model/prediction.h"

/// The one writer of numbers as JSON; shared by the writers of results, not for other code.
namespace raceway::io {

using json = nlohmann::ordered_json;

/// Text of a document: the number of its format, then its members. Two blanks of indent, 15 digits
/// (see with_15_digits()). Numbers that are not finite become null; bytes that are no UTF-8 (file
/// names) are replaced.
[[nodiscard]] std::string text(const json& document);

/// Text of a value on one line, without a line end.
[[nodiscard]] std::string line_text(const json& value);

[[nodiscard]] json report_json(const bearing::SolveReport& report);

/// What a band is of: its level and the fitted parameters.
[[nodiscard]] json band_json(const BandOfResult& band);

/// Puts the half widths of one row of it beside the numbers of that row.
void add_band(json& row, const BandOfResult& band, std::size_t index);

/// Parts of a friction torque by name.
[[nodiscard]] json friction_json(const model::Model& model,
                                 const model::FrictionPrediction& friction);

}  // namespace raceway::io
