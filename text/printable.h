#pragma once

#include <optional>
#include <string>
#include <string_view>

/// Handling of control characters. A terminal executes control characters, and a line break in a
/// name damages the file that contains the name.
namespace raceway::text {

/// Returns the first control character in UTF-8 text, as "U+001B". A tab is not reported. The
/// result is empty if the text has no control character.
[[nodiscard]] std::optional<std::string> control_character(std::string_view text);

/// Returns the text with each control character written as "\x1b", except those in `kept`.
[[nodiscard]] std::string printable(std::string_view text, std::string_view kept = {});

}  // namespace raceway::text
