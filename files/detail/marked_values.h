#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "files/used_default.h"
#include "text/detail/toml_text.h"

/// Finds values that the author of a model file marks as assumed or estimated. The mark is the word
/// `assumed` or `estimated` in the comment after the value or after the header of the table.
/// `raceway new` writes such marks.
namespace raceway::files {

/// Returns the marked values of all tables, in the order of the file. `text` is the text of the
/// file without a UTF-8 byte order mark, and `root` is the parsed text.
[[nodiscard]] std::vector<UsedDefault> marked_values(const toml::table& root,
                                                     std::string_view text);

/// Returns the text without the mark after a replaced value, which ends at byte `value_end`. Other
/// comments stay.
[[nodiscard]] std::string without_mark(std::string text, std::size_t value_end);

}  // namespace raceway::files
