#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <string_view>

namespace raceway::record {

/// Returns the smallest number of changes that turn one name into another [1]. A change inserts,
/// deletes or replaces a letter, or swaps two neighbouring letters. Upper and lower case are
/// treated as equal. If one of the names has more than 200 characters, the result is the length of
/// the longer name.
[[nodiscard]] std::size_t edit_distance(std::string_view a, std::string_view b);

/// Returns up to `most` known names, sorted by edit_distance() from `name`, as text: "z, f0, y".
[[nodiscard]] std::string nearest_names(std::string_view name, std::span<const std::string> known,
                                        std::size_t most);

}  // namespace raceway::record
