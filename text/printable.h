#pragma once

#include <optional>
#include <string>
#include <string_view>

/// Control characters: a terminal obeys them, and a line break in a name breaks the file that it is
/// written into.
namespace raceway::text {

/// The first one but a tab as "U+001B", of UTF-8 text; none where there is none.
[[nodiscard]] std::optional<std::string> control_character(std::string_view text);

/// The text with each of them written as "\x1b", but those that are `kept`.
[[nodiscard]] std::string printable(std::string_view text, std::string_view kept = {});

}  // namespace raceway::text
