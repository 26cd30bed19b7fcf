#pragma once

#include <string>
#include <string_view>

#include "control/plan.h"

namespace raceway::control {

/// Returns true for a table of coefficients that control_csv() wrote.
[[nodiscard]] bool is_control_table(std::string_view text);

/// Reads the plan from such a table, also with edited numbers; `source` is the name in messages.
/// Writing it again reproduces every number.
///
/// Throws InputError naming file, line, part, name, value and allowed range.
[[nodiscard]] ControlPlan read_control_table(std::string text, const std::string& source);

}  // namespace raceway::control
