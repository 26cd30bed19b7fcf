#pragma once

#include <fmt/format.h>

#include <string_view>

/// Text functions shared by the writers of CSV files.
namespace raceway::text {

inline constexpr std::string_view model_mark = "#|";

/// Appends `# model:` and the text of a model as comments, each line after `#| `.
void append_model(fmt::memory_buffer& out, std::string_view model_text);

/// Appends text as a cell of RFC 4180. The function writes an apostrophe before text that a
/// spreadsheet would read as a formula ("=1"), and before such text with leading apostrophes
/// ("'=1"). It writes control characters as escapes.
void append_text(fmt::memory_buffer& out, std::string_view text);

/// Removes the apostrophe that append_text() wrote, for readers of CSV.
[[nodiscard]] std::string_view without_guard(std::string_view cell);

/// Appends a value with 12 digits. Appends nothing if the value is not finite.
void append_value(fmt::memory_buffer& out, double value);

}  // namespace raceway::text
