#pragma once

#include <string>

#include "verdict/diagnosis.h"

namespace raceway::verdict {

/// Conclusion from find_hidden_input():
///   tell_all             no hidden input was found
///   may_miss_something   readings differ at nearly equal inputs
///   miss_what_changes    readings differ at nearly equal inputs, mainly from run to run
///
/// For `miss_what_changes`, unless the verdict is `nothing_missing`, the headline says that an
/// unknown quantity, not an input of the model, causes the differences.
enum class Inputs { tell_all, may_miss_something, miss_what_changes };

/// Returns the verdict in one short line: "Lubricant drag is missing: 65 N mm at 10 000 rpm; error
/// 44.9 -> 10.7 N mm".
[[nodiscard]] std::string headline(const Diagnosis& diagnosis, Inputs inputs = Inputs::tell_all);

}  // namespace raceway::verdict
