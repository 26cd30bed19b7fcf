#pragma once

#include <string_view>

namespace raceway::text {

/// Texts that instruments and spreadsheets write where there is no number: nothing, "nan", "#N/A",
/// "-", "OVER", "1.#QNAN", "Bad Input", ...
[[nodiscard]] bool is_missing(std::string_view cell);

}  // namespace raceway::text
