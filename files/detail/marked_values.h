#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "files/used_default.h"
#include "text/detail/toml_text.h"

/// Values that the author of a file marks as a guess. The mark is the word `assumed` or `estimated`
/// in the comment after the value or after the header of the table. `raceway new` writes such
/// marks.
namespace raceway::files {

/// Returns the marked values of all tables, in the order of the file. `text` is the file without
/// the UTF-8 byte order mark, `root` has its tables.
[[nodiscard]] std::vector<UsedDefault> marked_values(const toml::table& root,
                                                     std::string_view text);

/// Removes the mark after a replaced value that ends at byte `value_end`. Other comments stay.
[[nodiscard]] std::string without_mark(std::string text, std::size_t value_end);

}  // namespace raceway::files
