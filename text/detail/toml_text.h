#pragma once

#include <stdexcept>
#include <string>
#include <string_view>

namespace {
[[noreturn]] void fail_in_parser() { throw std::logic_error("toml++ stopped"); }
}  // namespace

// toml++ 3.3 asserts on some malformed texts, such as `[ = 1`. These macros make them errors in
// every build. The other headers are included before, so the macros do not affect them.
#undef NDEBUG
#define TOML_ASSERT(condition) ((condition) ? void() : fail_in_parser())
#include <toml++/toml.h>

/// Shared by the readers and writers of model files.
namespace raceway::text {

inline constexpr std::string_view utf8_mark = "\xef\xbb\xbf";

/// Returns the tables of a file without its format number. Throws InputError with `source`, line
/// and, where known, column.
[[nodiscard]] toml::table parse_toml(std::string_view text, std::string_view source);

/// Byte offset of the start of a line; lines count from 1.
[[nodiscard]] std::size_t line_start(std::string_view text, std::size_t line);
/// Byte offset of a place that toml++ gives as line and column, which counts code points. A UTF-8
/// byte order mark does not count as a column.
[[nodiscard]] std::size_t byte_of(std::string_view text, const toml::source_position& place);

/// Approximate text of a value as the user wrote it.
[[nodiscard]] std::string shown(const toml::node& node);

}  // namespace raceway::text
