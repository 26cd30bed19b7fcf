#pragma once

#include <string>

namespace raceway::text {

/// Name of an input in messages: its path, or `standard input` for `-`.
[[nodiscard]] std::string input_name(const std::string& path);

/// The whole text of a file, or of standard input for `-`, which can be read once, without a UTF-8
/// byte order mark (`byte_order_mark` reports it). Throws InputError for standard input asked for
/// again, a file that is missing, a directory, unreadable, not text (NUL bytes), or longer than 4
/// GB.
[[nodiscard]] std::string read_text(const std::string& path, bool* byte_order_mark = nullptr);

/// Reads an input ahead of read_text(), which then still finds standard input unread.
[[nodiscard]] std::string peek_text(const std::string& path);

}  // namespace raceway::text
