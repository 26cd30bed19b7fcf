#pragma once

#include <string>

namespace raceway::text {

/// Returns the name of an input for messages: the path, or `standard input` for `-`.
[[nodiscard]] std::string input_name(const std::string& path);

/// Reads the whole text of a file, or of standard input for `-`. Standard input can be read only
/// once. Converts UTF-16 to UTF-8, and removes the byte order mark; `byte_order_mark` becomes true
/// if the file had a byte order mark. Throws InputError for a second read of standard input, and
/// for a missing or unreadable file, a directory, a known binary format, NUL bytes, or a file of
/// more than 4 GB.
[[nodiscard]] std::string read_text(const std::string& path, bool* byte_order_mark = nullptr);

/// Returns the same text as read_text(). The input can still be read afterwards, even if it is
/// standard input.
[[nodiscard]] std::string peek_text(const std::string& path);

}  // namespace raceway::text
