#pragma once

#include <string>
#include <string_view>

#include "control/plan.h"

namespace raceway::control {

/// Returns true if the text is a table of coefficients from control_csv().
[[nodiscard]] bool is_control_table(std::string_view text);

/// Reads the plan from a table of coefficients. Users may edit the numbers in the table. `source`
/// is the file name for messages. If the plan is written again, the numbers do not change.
///
/// Throws InputError if the table is not valid; the message names file, line, part, name, value and
/// allowed range.
[[nodiscard]] ControlPlan read_control_table(std::string text, const std::string& source);

}  // namespace raceway::control
