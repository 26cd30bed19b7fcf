#pragma once

#include <string>

#include "verdict/diagnosis.h"

namespace raceway::verdict {

/// Conclusion from find_hidden_input(): no hidden input was found (tell_all), readings differ at
/// nearly equal inputs (may_miss_something), or these readings differ mainly from run to run
/// (miss_what_changes). In the last case, unless the verdict is nothing_missing, the headline says
/// that the cause is not an input of the model.
enum class Inputs { tell_all, may_miss_something, miss_what_changes };

/// Returns the verdict in one short line: "Lubricant drag is missing: 65 N mm at 10 000 rpm; error
/// 44.9 -> 10.7 N mm".
[[nodiscard]] std::string headline(const Diagnosis& diagnosis, Inputs inputs = Inputs::tell_all);

}  // namespace raceway::verdict
