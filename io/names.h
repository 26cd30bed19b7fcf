#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <string_view>

namespace raceway::io {

/// Changes (insert, delete, replace, swap neighbours) that turn one name into the other [1];
/// upper and lower case are alike.
[[nodiscard]] std::size_t edit_distance(std::string_view a, std::string_view b);

/// The known name that was probably meant: within two changes (one in names of up to four letters),
/// or `name` is a known name without its unit ("speed") or its first word ("load_N").
[[nodiscard]] std::optional<std::string> nearest_name(std::string_view name,
                                                      std::span<const std::string> known);

/// "; did you mean X?" for the nearest name, empty where there is none.
[[nodiscard]] std::string suggestion(std::string_view name, std::span<const std::string> known);

}  // namespace raceway::io
