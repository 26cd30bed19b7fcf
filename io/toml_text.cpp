#include "io/toml_text.h"

#include <fmt/format.h>

#include "io/error.h"

namespace raceway::io {
namespace {

/// Line at which toml++ trips over its own assertion: the first lines up to it do so as well.
std::size_t broken_line(std::string_view text) {
  std::size_t line = 1;
  for (std::size_t end = 0; (end = text.find('\n', end)) != text.npos; ++end, ++line) {
    try {
      (void)toml::parse(text.substr(0, end));
    } catch (const toml::parse_error&) {
      // A value over several lines is not complete yet.
    } catch (const std::logic_error&) {
      break;
    }
  }
  return line;
}

}  // namespace

toml::table parse_toml(std::string_view text, std::string_view source) {
  try {
    return toml::parse(text, source);
  } catch (const toml::parse_error& error) {
    const toml::source_position at = error.source().begin;
    throw InputError(fmt::format("{}:{}:{}: {}", source, at.line, at.column, error.description()));
  } catch (const std::logic_error&) {
    throw InputError(
        fmt::format("{}:{}: no TOML: a key, a value or a bracket is missing or misplaced", source,
                    broken_line(text)));
  }
}

std::string shown(const toml::node& node) {
  if (const auto* s = node.as_string()) return fmt::format("\"{}\"", s->get());
  if (const auto* i = node.as_integer()) return fmt::format("{}", i->get());
  if (const auto* f = node.as_floating_point()) return fmt::format("{}", f->get());
  if (const auto* b = node.as_boolean()) return b->get() ? "true" : "false";
  if (node.is_table()) return "{...}";
  if (node.is_array()) return "[...]";
  return "a date or time";
}

}  // namespace raceway::io
