#pragma once

#include <algorithm>
#include <cstddef>
#include <string>

// This include must be the last one: see text/detail/toml_text.h.
#include "text/detail/toml_text.h"

/// Finds the lines of a table in the text of a model file.
namespace raceway::files {

/// Returns the line number at which a value ends. For a table, this is the last line of its
/// contents.
inline toml::source_index last_line(const toml::node& node) {
  toml::source_index last = node.source().end.line;
  if (const toml::table* const table = node.as_table())
    for (const auto& [_, inner] : *table) last = std::max(last, last_line(inner));
  if (const toml::array* const list = node.as_array())
    for (const toml::node& inner : *list) last = std::max(last, last_line(inner));
  return last;
}

/// Returns the byte position at which the comment lines directly above the line at position `at`
/// begin; `at` if there are no such lines.
inline std::size_t with_comment_above(const std::string& text, std::size_t at) {
  while (at > 1) {
    const std::size_t before = text.rfind('\n', at - 2) + 1;
    if (text[text.find_first_not_of(" \t", before)] != '#') break;
    at = before;
  }
  return at;
}

}  // namespace raceway::files
