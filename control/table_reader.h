#pragma once

#include <string>
#include <string_view>

#include "control/plan.h"

namespace raceway::control {

/// Returns true for a table of coefficients that control_csv() wrote.
[[nodiscard]] bool is_control_table(std::string_view text);

/// The plan of such a table, of which numbers may have been changed; `source` stands in messages.
/// What is written of it again is what it was read from, number by number.
///
/// Throws InputError naming file, line, part, name, value and allowed range.
[[nodiscard]] ControlPlan read_control_table(std::string text, const std::string& source);

}  // namespace raceway::control
