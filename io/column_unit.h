#pragma once

#include <string_view>

namespace raceway::io {

/// SI value of one unit of a column, by the end of its name: 1e-3 for "load_Nmm", 1 where the name
/// ends in no unit (or in one that is SI already).
[[nodiscard]] double column_unit(std::string_view column);

}  // namespace raceway::io
