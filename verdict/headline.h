#pragma once

#include <string>

#include "verdict/diagnosis.h"

namespace raceway::verdict {

/// Result of find_hidden_input(): nearly equal inputs give equal readings (tell_all), give
/// different readings (may_miss_something), or give different readings in different runs
/// (miss_what_changes). In the last case, unless the verdict is nothing_missing, the headline says
/// that the cause is not an input of the model.
enum class Inputs { tell_all, may_miss_something, miss_what_changes };

/// Returns the verdict in one short line: "Lubricant drag is missing: 65 N mm at 10 000 rpm; error
/// 44.9 -> 10.7 N mm".
[[nodiscard]] std::string headline(const Diagnosis& diagnosis, Inputs inputs = Inputs::tell_all);

}  // namespace raceway::verdict
