#pragma once

#include <string>

namespace raceway::io {

/// The whole text of a file, without a UTF-8 byte order mark (`byte_order_mark` tells of it).
/// Throws InputError for a file that is missing, a directory, unreadable, not text (NUL bytes), or
/// longer than 4 GB.
[[nodiscard]] std::string read_text(const std::string& path, bool* byte_order_mark = nullptr);

}  // namespace raceway::io
