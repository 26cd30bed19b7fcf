#pragma once

#include <string>

#include "verdict/diagnosis.h"

namespace raceway::cli {

/// Returns the errors before and after the found effects: bars for each channel, or one table if
/// there are many channels. `brief` gives fewer lines and columns.
[[nodiscard]] std::string errors_text(const verdict::Diagnosis& d, bool brief);

}  // namespace raceway::cli
