#pragma once

#include <string>

#include "verdict/diagnosis.h"

namespace raceway::verdict {

/// States whether the inputs distinguish all rows with different readings. With miss_what_changes,
/// the headline says that the cause is not an input of the model, and names no effect (unless the
/// verdict is nothing_missing).
enum class Inputs { tell_all, may_miss_something, miss_what_changes };

/// Returns the short verdict without its evidence, which is in `sentence`: "Lubricant drag is
/// missing: 65 N mm at 10 000 rpm; error 44.9 -> 10.7 N mm".
[[nodiscard]] std::string headline(const Diagnosis& diagnosis, Inputs inputs = Inputs::tell_all);

}  // namespace raceway::verdict
