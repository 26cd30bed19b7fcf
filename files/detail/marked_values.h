#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "files/used_default.h"
#include "text/detail/toml_text.h"

/// Values that the author of a file marks as a guess: the word `assumed` or `estimated` in the
/// comment behind the value, or behind the header of its table. `raceway new` writes such marks.
namespace raceway::files {

/// Returns the marked values of all tables, in the order of the file. `text` is the file without
/// the mark of UTF-8, `root` its tables.
[[nodiscard]] std::vector<UsedDefault> marked_values(const toml::table& root,
                                                     std::string_view text);

/// Removes a mark behind a value that was replaced and ends at byte `value_end`; other comments
/// stay.
[[nodiscard]] std::string without_mark(std::string text, std::size_t value_end);

}  // namespace raceway::files
