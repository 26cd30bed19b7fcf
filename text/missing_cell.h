#pragma once

#include <string_view>

namespace raceway::text {

/// True for texts that instruments and spreadsheets write for a missing number: nothing, "nan",
/// "#N/A", "-", "OVER", "1.#QNAN", "Bad Input", ...
[[nodiscard]] bool is_missing(std::string_view cell);

}  // namespace raceway::text
