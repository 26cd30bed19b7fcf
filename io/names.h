#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "fit/nearest_names.h"

namespace raceway::io {

using fit::edit_distance;

/// The known name that was probably meant: within two changes (one in names of up to four letters),
/// or `name` is a known name without its unit ("speed") or its first word ("load_N").
[[nodiscard]] std::optional<std::string> nearest_name(std::string_view name,
                                                      std::span<const std::string> known);

/// "; did you mean X?" for the nearest name, empty where there is none.
[[nodiscard]] std::string suggestion(std::string_view name, std::span<const std::string> known);

}  // namespace raceway::io
