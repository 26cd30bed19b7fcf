#pragma once

#include <fmt/format.h>

#include <string_view>

/// Shared by the writers of CSV files; not for other code.
namespace raceway::io {

inline constexpr std::string_view model_mark = "#|";

/// `# model:` and the text of a model as comments, each line behind `#| `.
void append_model(fmt::memory_buffer& out, std::string_view model_text);

/// 12 digits; nothing for what is not finite.
void append_value(fmt::memory_buffer& out, double value);

}  // namespace raceway::io
