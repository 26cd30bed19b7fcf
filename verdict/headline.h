#pragma once

#include <string>

#include "verdict/diagnosis.h"

namespace raceway::verdict {

/// Result of the check whether rows with nearly equal inputs have equal readings
/// (find_hidden_input()): yes, no, or no because the readings change from run to run. In the last
/// case, the headline says that the cause is not an input of the model, and names no effect (unless
/// the verdict is nothing_missing).
enum class Inputs { tell_all, may_miss_something, miss_what_changes };

/// Returns the verdict in one short line: "Lubricant drag is missing: 65 N mm at 10 000 rpm; error
/// 44.9 -> 10.7 N mm".
[[nodiscard]] std::string headline(const Diagnosis& diagnosis, Inputs inputs = Inputs::tell_all);

}  // namespace raceway::verdict
