#pragma once

#include <string>
#include <string_view>

namespace raceway::text {

[[nodiscard]] bool is_utf8(std::string_view text);
[[nodiscard]] std::string utf8_from_latin1(std::string_view text);

/// True where the text begins with a byte order mark of UTF-16.
[[nodiscard]] bool is_utf16(std::string_view text);
/// Converts a text to UTF-8, without byte order mark. Throws InputError for a text that is no
/// UTF-16; `source` stands in messages.
[[nodiscard]] std::string utf8_from_utf16(std::string_view text, const std::string& source);

/// Names the kind of a binary file and the remedy: an Excel workbook, an archive, ...; empty for an
/// unknown kind.
[[nodiscard]] std::string_view binary_kind(std::string_view text);

}  // namespace raceway::text
