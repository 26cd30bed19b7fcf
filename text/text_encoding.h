#pragma once

#include <string>
#include <string_view>

namespace raceway::text {

[[nodiscard]] bool is_utf8(std::string_view text);
[[nodiscard]] std::string utf8_from_latin1(std::string_view text);

/// Returns true if the text begins with a UTF-16 byte order mark.
[[nodiscard]] bool is_utf16(std::string_view text);
/// Converts a UTF-16 text to UTF-8, without byte order mark. Throws InputError if the text is not
/// UTF-16. `source` is the file name in messages.
[[nodiscard]] std::string utf8_from_utf16(std::string_view text, const std::string& source);

/// Returns the kind of a binary file, such as an Excel workbook or an archive, with advice to the
/// user; empty for an unknown kind.
[[nodiscard]] std::string_view binary_kind(std::string_view text);

}  // namespace raceway::text
