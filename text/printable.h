#pragma once

#include <optional>
#include <string>
#include <string_view>

/// Detects and replaces control characters in texts from files and users. A control character can
/// change the behaviour of a terminal, and a line break in a name damages the file that contains
/// the name.
namespace raceway::text {

/// Returns the code, such as "U+001B", of the first control character in UTF-8 text; empty if there
/// is none. Tabs are ignored.
[[nodiscard]] std::optional<std::string> control_character(std::string_view text);

/// Replaces each control character of the text by its code, such as "\x1b". Control characters in
/// `kept` stay unchanged.
[[nodiscard]] std::string printable(std::string_view text, std::string_view kept = {});

}  // namespace raceway::text
