#pragma once

#include <stdexcept>
#include <string>
#include <string_view>

namespace {
[[noreturn]] void fail_in_parser() { throw std::logic_error("toml++ stopped"); }
}  // namespace

// toml++ 3.3 asserts on some malformed texts, such as `[ = 1`. These macros make them errors in
// every build. All other headers are included before this header, so the macros do not affect them.
#undef NDEBUG
#define TOML_ASSERT(condition) ((condition) ? void() : fail_in_parser())
#include <toml++/toml.h>

/// TOML texts; shared by the readers and writers of model files.
namespace raceway::text {

inline constexpr std::string_view utf8_mark = "\xef\xbb\xbf";

/// Returns the tables of a file. The key `format` is checked and left out. Throws InputError with
/// `source`, line and, if known, column.
[[nodiscard]] toml::table parse_toml(std::string_view text, std::string_view source);

/// Returns the byte offset of the start of a line. The first line has the number 1.
[[nodiscard]] std::size_t line_start(std::string_view text, std::size_t line);
/// Returns the byte offset of a place that toml++ gives as line and column. toml++ counts the
/// column in code points, without a UTF-8 byte order mark.
[[nodiscard]] std::size_t byte_of(std::string_view text, const toml::source_position& place);

/// Returns approximately the text that the user wrote for a value.
[[nodiscard]] std::string shown(const toml::node& node);

}  // namespace raceway::text
