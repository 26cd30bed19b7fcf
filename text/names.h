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

/// Returns the known name that the user probably meant; empty if no known name is similar. A known
/// name is similar if it differs from `name` by at most two letters, or by at most one letter if
/// `name` has up to four letters. A known name is also similar if `name` is its beginning or its
/// end, before or after a "_" ("speed" for "speed_rpm", "load_N" for "axial_load_N").
[[nodiscard]] std::optional<std::string> nearest_name(std::string_view name,
                                                      std::span<const std::string> known);

/// Returns the text as a TOML string in quotes. Quotes and backslashes in the text become \" and
/// \\.
[[nodiscard]] std::string in_quotes(std::string_view text);

/// Returns a text such as "a, b and c"; `last_word` is the word before the last name.
[[nodiscard]] std::string listed(std::span<const std::string> names,
                                 std::string_view last_word = "and");

/// Returns the text "; did you mean X?", in which X is the result of nearest_name(); empty if no
/// known name is similar.
[[nodiscard]] std::string suggestion(std::string_view name, std::span<const std::string> known);

}  // namespace raceway::text
