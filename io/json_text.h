#pragma once

#include <nlohmann/json.hpp>
#include <string>

#include "bearing/solve.h"
#include "fit/model.h"
#include "fit/prediction.h"

/// Shared by the writers of results; not for other code.
namespace raceway::io {

using json = nlohmann::ordered_json;

/// Two blanks of indent. Numbers that are not finite become null; bytes that are no UTF-8 (file
/// names) are replaced.
[[nodiscard]] std::string exact_text(const json& document);

/// The same with 15 digits, which takes the rounding of a change of unit off: 6000 rpm are not
/// 6000.000000000001.
[[nodiscard]] std::string text(json document);

[[nodiscard]] json report_json(const bearing::SolveReport& report);

/// Parts of a friction torque by name.
[[nodiscard]] json friction_json(const fit::Model& model, const fit::FrictionPrediction& friction);

}  // namespace raceway::io
