#pragma once

#include <string>

#include "verdict/diagnosis.h"

namespace raceway::cli {

/// Returns a text with the errors of the model without and with the effects of the verdict. The
/// text shows bars for each measured channel, or one table if there are many channels. If `brief`
/// is true, the text has fewer lines and columns.
[[nodiscard]] std::string errors_text(const verdict::Diagnosis& d, bool brief);

}  // namespace raceway::cli
