#pragma once

#include <string>
#include <string_view>

#include "control/plan.h"

namespace raceway::control {

/// Returns true for a table of coefficients that control_csv() wrote.
[[nodiscard]] bool is_control_table(std::string_view text);

/// Reads the plan from a table of coefficients. Users may edit the numbers in the table. `source`
/// is the file name in messages. If the plan is written again, all numbers are unchanged.
///
/// Throws InputError with file, line, part, name, value and allowed range.
[[nodiscard]] ControlPlan read_control_table(std::string text, const std::string& source);

}  // namespace raceway::control
