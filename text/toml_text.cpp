#include <fmt/format.h>

#include <algorithm>
#include <vector>

#include "text/csv.h"
#include "text/error.h"
#include "text/format_number.h"
#include "text/printable.h"

// Last: see text/detail/toml_text.h.
#include "text/detail/toml_text.h"

namespace raceway::text {
namespace {

bool trips_over(std::string_view text) {
  try {
    (void)toml::parse(text);
  } catch (const toml::parse_error&) {
    // A value over several lines is not complete yet.
  } catch (const std::logic_error&) {
    return true;
  }
  return false;
}

/// Line at which toml++ trips over its own assertion: the first lines up to it do so as well.
std::size_t broken_line(std::string_view text) {
  std::vector<std::size_t> ends;
  for (std::size_t end = 0; (end = text.find('\n', end)) != text.npos; ++end) ends.push_back(end);
  const auto broken = std::partition_point(
      ends.begin(), ends.end(), [&](std::size_t end) { return !trips_over(text.substr(0, end)); });
  return static_cast<std::size_t>(broken - ends.begin()) + 1;
}

/// Where a text in quotes that begins at `at` ends: behind its closing quotes, or where the text
/// does.
std::size_t behind_quotes(std::string_view text, std::size_t at) {
  const char quote = text[at];
  const bool lines = text.substr(at, 3) == std::string(3, quote);
  for (at += lines ? 3 : 1; at < text.size(); ++at) {
    if (text[at] == '\\' && quote == '"') {
      ++at;
    } else if (text[at] == '\n' && !lines) {
      return at;
    } else if (text[at] == quote && !lines) {
      return at + 1;
    } else if (text[at] == quote && text.substr(at, 3) == std::string(3, quote)) {
      // Up to two more belong to the text.
      return std::min(text.find_first_not_of(quote, at), std::min(at + 5, text.size()));
    }
  }
  return text.size();
}

/// toml++ calls itself once for each part of a dotted key, and ends the program where these are
/// very many; brackets it counts itself. Numbers of a list have a comma between their points.
void require_short_keys(std::string_view text, std::string_view source) {
  constexpr int most = 16;
  std::size_t line = 1;
  int dots = 0;
  for (std::size_t at = 0; at < text.size();) {
    const char c = text[at];
    if (c == '"' || c == '\'') {
      const std::size_t end = behind_quotes(text, at);
      line += static_cast<std::size_t>(std::count(text.begin() + static_cast<std::ptrdiff_t>(at),
                                                  text.begin() + static_cast<std::ptrdiff_t>(end),
                                                  '\n'));
      at = end;
      continue;
    }
    if (c == '#') {
      at = std::min(text.find('\n', at), text.size());
      continue;
    }
    if (c == '.' && ++dots > most)
      throw InputError(fmt::format("{}:{}: a key has more than {} dots, so the file is not a model",
                                   source, line, most),
                       {.file = std::string(source), .line = static_cast<int>(line)});
    if (c == '\n' || c == ',' || c == '=' || c == '[' || c == '{') dots = 0;
    if (c == '\n') ++line;
    ++at;
  }
}

/// Rejects control characters in keys and values, which go into other files and onto terminals, and
/// whole numbers that a double does not hold exactly.
void require_usable(const toml::node& node, std::string_view source) {
  const auto require = [&](std::string_view text, const toml::source_region& place) {
    if (const auto code = control_character(text))
      throw InputError(fmt::format("{}:{}: {} contains the control character {}", source,
                                   place.begin.line, text::quoted(text), *code),
                       {.file = std::string(source), .line = static_cast<int>(place.begin.line)});
  };
  if (const auto* text = node.as_string()) require(text->get(), node.source());
  if (const auto* number = node.as_integer(); number && !node.value<double>())
    throw InputError(
        fmt::format("{}:{}: {}: whole numbers above 9007199254740992 (2^53) may be inexact; write "
                    "the number with a decimal point",
                    source, node.source().begin.line, number->get()),
        {.file = std::string(source), .line = static_cast<int>(node.source().begin.line)});
  if (const auto* list = node.as_array())
    for (const toml::node& item : *list) require_usable(item, source);
  if (const auto* table = node.as_table())
    for (const auto& [key, item] : *table) {
      require(key.str(), key.source());
      require_usable(item, source);
    }
}

/// Takes the number of the format out of a file.
void take_format(toml::table& table, std::string_view source) {
  const toml::node* const format = table.get("format");
  if (!format) return;
  if (format->value<double>() != format_number)
    throw InputError(fmt::format("{}:{}: format = {}: {}", source, format->source().begin.line,
                                 shown(*format), other_format),
                     {.file = std::string(source),
                      .line = static_cast<int>(format->source().begin.line),
                      .key = "format"});
  table.erase("format");
}

toml::table parsed(std::string_view text, std::string_view source) {
  try {
    return toml::parse(text, source);
  } catch (const toml::parse_error& error) {
    const toml::source_position at = error.source().begin;
    throw InputError(fmt::format("{}:{}:{}: {} (in TOML, text stands in quotes, a number has a "
                                 "decimal point, and a comment begins with #)",
                                 source, at.line, at.column, error.description()),
                     {.file = std::string(source), .line = static_cast<int>(at.line)});
  } catch (const std::logic_error&) {
    throw InputError(fmt::format("{}:{}: the file is not valid TOML: a key, a value or a bracket "
                                 "is missing or misplaced",
                                 source, broken_line(text)),
                     {.file = std::string(source), .line = static_cast<int>(broken_line(text))});
  }
}

}  // namespace

toml::table parse_toml(std::string_view text, std::string_view source) {
  constexpr std::size_t most = 10'000'000;
  if (text.size() > most)
    throw InputError(fmt::format("{}: the file has {:.3g} MB; a model has at most {:.3g} MB",
                                 source, 1e-6 * static_cast<double>(text.size()), 1e-6 * most),
                     {.file = std::string(source)});
  require_short_keys(text, source);
  toml::table table = parsed(text, source);
  require_usable(table, source);
  take_format(table, source);
  return table;
}

std::size_t line_start(std::string_view text, std::size_t line) {
  std::size_t at = 0;
  for (; line > 1; --line) at = text.find('\n', at) + 1;
  return at;
}

std::size_t byte_of(std::string_view text, const toml::source_position& place) {
  std::size_t at = line_start(text, place.line);
  if (at == 0 && text.starts_with(utf8_mark)) at = utf8_mark.size();
  for (auto column = place.column; column > 1 && at < text.size(); --column) {
    ++at;
    while (at < text.size() && (static_cast<unsigned char>(text[at]) & 0xc0) == 0x80) ++at;
  }
  return at;
}

std::string shown(const toml::node& node) {
  if (const auto* s = node.as_string()) return text::quoted(s->get());
  if (const auto* i = node.as_integer()) return fmt::format("{}", i->get());
  if (const auto* f = node.as_floating_point()) return fmt::format("{}", f->get());
  if (const auto* b = node.as_boolean()) return b->get() ? "true" : "false";
  if (node.is_table()) return "{...}";
  if (node.is_array()) return "[...]";
  return "a date or time";
}

}  // namespace raceway::text
