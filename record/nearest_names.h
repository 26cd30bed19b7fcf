#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <string_view>

namespace raceway::record {

/// Returns the number of changes (insert, delete, replace, swap neighbours) from one name to
/// another [1], ignoring case. If one of the names has more than 200 characters, the result is the
/// length of the longer name.
[[nodiscard]] std::size_t edit_distance(std::string_view a, std::string_view b);

/// Returns the known names that are most similar to `name`, nearest first: "z, f0, y".
[[nodiscard]] std::string nearest_names(std::string_view name, std::span<const std::string> known,
                                        std::size_t most);

}  // namespace raceway::record
