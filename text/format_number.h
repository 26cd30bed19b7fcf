#pragma once

#include <string_view>

namespace raceway::text {

/// Format number of model files, JSON documents and saved states. A file without a format number
/// has format 1. The number increases if the meaning of valid files changes or if valid files can
/// no longer be read (docs/design.md, "What is stable").
inline constexpr int format_number = 1;

/// The first line of a model file.
inline constexpr std::string_view format_line = "format = 1\n";

/// End of the error message about a file whose format number is not 1.
inline constexpr std::string_view other_format =
    "must be 1, because this version of raceway reads format 1 only; use the version that wrote "
    "the file";

}  // namespace raceway::text
