#pragma once

#include <string_view>

namespace raceway::text {

/// Returns true for texts that instruments and spreadsheets write for a missing number: an empty
/// text, "nan", "#N/A", "-", "OVER", "1.#QNAN", "Bad Input", ...
[[nodiscard]] bool is_missing(std::string_view cell);

}  // namespace raceway::text
