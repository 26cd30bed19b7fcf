#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "record/nearest_names.h"

namespace raceway::text {

using record::edit_distance;

/// Returns the text without the blanks at both ends.
[[nodiscard]] std::string_view trimmed(std::string_view text);

/// Returns the parts between separators, including empty parts.
[[nodiscard]] std::vector<std::string_view> split(std::string_view text, char separator);

/// Returns the text with its ASCII letters in lower case.
[[nodiscard]] std::string lower_case(std::string_view text);

/// Returns the known name that the user probably meant; empty if no known name is near. The known
/// name differs from `name` by at most two changes (one change for names of up to four letters), or
/// `name` is the known name without the unit ("speed") or without the first word ("load_N").
[[nodiscard]] std::optional<std::string> nearest_name(std::string_view name,
                                                      std::span<const std::string> known);

/// Returns the text in quotes for TOML, with quotes and backslashes written as \" and \\.
[[nodiscard]] std::string in_quotes(std::string_view text);

/// Returns a text such as "a, b and c"; `last_word` is the word before the last name.
[[nodiscard]] std::string listed(std::span<const std::string> names,
                                 std::string_view last_word = "and");

/// Returns "; did you mean X?" for nearest_name(); empty if no known name is near.
[[nodiscard]] std::string suggestion(std::string_view name, std::span<const std::string> known);

}  // namespace raceway::text
