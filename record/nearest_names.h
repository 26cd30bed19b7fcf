#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <string_view>

namespace raceway::record {

/// Changes (insert, delete, replace, swap neighbours) that turn one name into the other [1];
/// upper and lower case are alike. A text of more than 200 characters is no name: all of it counts.
[[nodiscard]] std::size_t edit_distance(std::string_view a, std::string_view b);

/// The known names with the fewest changes from `name`, nearest first: "z, f0, y".
[[nodiscard]] std::string nearest_names(std::string_view name, std::span<const std::string> known,
                                        std::size_t most);

}  // namespace raceway::record
