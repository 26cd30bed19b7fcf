#pragma once

#include <string>

#include "verdict/diagnosis.h"

namespace raceway::verdict {

/// Whether the inputs of a model tell rows apart that read differently; what changes from run to
/// run in none of them is no effect.
enum class Inputs { tell_all, may_miss_something, miss_what_changes };

/// A verdict as one says it to a colleague, without its proof, which is in `sentence`:
/// "Lubricant drag is missing: 65 N mm at 10 000 rpm; error 44.9 -> 10.7 N mm".
[[nodiscard]] std::string headline(const Diagnosis& diagnosis, Inputs inputs = Inputs::tell_all);

}  // namespace raceway::verdict
