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
/// Throws InputError if the table is not valid; the message names the file and line, the part of
/// the correction, and the name, value and allowed range of the number.
[[nodiscard]] ControlPlan read_control_table(std::string text, const std::string& source);

}  // namespace raceway::control
