#pragma once

#include <string>

#include "verdict/diagnosis.h"

namespace raceway::cli {

/// Returns the errors of the model without and with the effects of the verdict: bars for each
/// channel, or one table if there are many channels. `brief` gives fewer lines and columns.
[[nodiscard]] std::string errors_text(const verdict::Diagnosis& d, bool brief);

}  // namespace raceway::cli
