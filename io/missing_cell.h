#pragma once

#include <string_view>

namespace raceway::io {

/// What instruments and spreadsheets write where there is no number: nothing, "nan", "#N/A", "-",
/// ...
[[nodiscard]] bool is_missing(std::string_view cell);

}  // namespace raceway::io
