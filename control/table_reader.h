#pragma once

#include <string>
#include <string_view>

#include "control/plan.h"

namespace raceway::control {

/// Returns true if the text is a table of coefficients from control_csv().
[[nodiscard]] bool is_control_table(std::string_view text);

/// Reads the exported corrections from a table of coefficients. Users may edit the numbers in the
/// table. `source` is the file name for messages. If control_csv() writes the returned plan to a
/// table, the numbers are equal to the numbers in `text`.
///
/// Throws InputError if the table is not valid. The message gives the file, the line and the part
/// of the correction. For a number outside its range, the message also gives name, value and
/// allowed range.
[[nodiscard]] ControlPlan read_control_table(std::string text, const std::string& source);

}  // namespace raceway::control
