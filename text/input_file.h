#pragma once

#include <string>

namespace raceway::text {

/// Name of an input in messages: its path, or `standard input` for `-`.
[[nodiscard]] std::string input_name(const std::string& path);

/// Reads the whole text of a file, or of standard input for `-`, which can be read once. Removes a
/// UTF-8 byte order mark (`byte_order_mark` reports it). Throws InputError for a second read of
/// standard input, a missing or unreadable file, a directory, NUL bytes, or more than 4 GB.
[[nodiscard]] std::string read_text(const std::string& path, bool* byte_order_mark = nullptr);

/// Reads an input before read_text(), which can then still read standard input.
[[nodiscard]] std::string peek_text(const std::string& path);

}  // namespace raceway::text
