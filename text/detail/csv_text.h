#pragma once

#include <fmt/format.h>

#include <string_view>

/// Shared by the writers of CSV files.
namespace raceway::text {

inline constexpr std::string_view model_mark = "#|";

/// `# model:` and the text of a model as comments, each line behind `#| `.
void append_model(fmt::memory_buffer& out, std::string_view model_text);

/// Text as a cell of RFC 4180. No spreadsheet takes it for a formula: behind an apostrophe where it
/// begins as one, or as one behind apostrophes. Control characters are written out.
void append_text(fmt::memory_buffer& out, std::string_view text);

/// The text that append_text() put behind an apostrophe, as readers of CSV take it.
[[nodiscard]] std::string_view without_guard(std::string_view cell);

/// Appends a value with 12 digits; nothing for a value that is not finite.
void append_value(fmt::memory_buffer& out, double value);

}  // namespace raceway::text
