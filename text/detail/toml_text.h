#pragma once

#include <stdexcept>
#include <string>
#include <string_view>

namespace {
[[noreturn]] void fail_in_parser() { throw std::logic_error("toml++ stopped"); }
}  // namespace

// toml++ 3.3 asserts where some malformed texts, such as `[ = 1`, should be errors: make them
// errors in every build. The other headers are included before, so none of them sees these macros.
#undef NDEBUG
#define TOML_ASSERT(condition) ((condition) ? void() : fail_in_parser())
#include <toml++/toml.h>

/// Shared by the readers and writers of model files.
namespace raceway::text {

inline constexpr std::string_view utf8_mark = "\xef\xbb\xbf";

/// Tables of a file without the number of its format. Throws InputError with `source`, line and,
/// where known, column.
[[nodiscard]] toml::table parse_toml(std::string_view text, std::string_view source);

/// Byte at which a line begins; lines count from 1.
[[nodiscard]] std::size_t line_start(std::string_view text, std::size_t line);
/// Byte of a place that toml++ gives as line and column, which counts code points. A mark of UTF-8
/// at the beginning is no column.
[[nodiscard]] std::size_t byte_of(std::string_view text, const toml::source_position& place);

/// A value as the user wrote it, near enough.
[[nodiscard]] std::string shown(const toml::node& node);

}  // namespace raceway::text
