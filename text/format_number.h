#pragma once

#include <string_view>

namespace raceway::text {

/// Number of the formats of model files, JSON documents and saved states. A file without a number
/// has format 1. The number grows when a file that was valid changes its meaning or can no
/// longer be read (docs/design.md, "What is stable").
inline constexpr int format_number = 1;

/// The first line of a model file.
inline constexpr std::string_view format_line = "format = 1\n";

/// End of the message about a file of another format.
inline constexpr std::string_view other_format =
    "must be 1, because this version of raceway reads format 1 only; use the version that wrote "
    "the file";

}  // namespace raceway::text
