#include "text/detail/csv_cells.h"

#include <fmt/format.h>

#include <algorithm>

#include "text/detail/csv_text.h"
#include "text/error.h"
#include "text/names.h"
#include "text/units.h"

namespace raceway::text {
std::string_view separator_name(char separator) {
  switch (separator) {
    case ';':
      return "semicolons";
    case '\t':
      return "tabs";
    case blanks:
      return "blanks";
    default:
      return "commas";
  }
}

std::size_t count_separators(std::string_view line, char separator) {
  bool inside = false, behind_blank = true;
  std::size_t count = 0, words = 0;
  for (const char c : line) {
    if (c == '"') inside = !inside;
    if (c == separator && !inside) ++count;
    if (behind_blank && !is_blank(c)) ++words;
    behind_blank = !inside && is_blank(c);
  }
  if (separator == blanks) return words > 0 ? words - 1 : 0;
  return count;
}

void split_cells(std::string& text, std::size_t begin, std::size_t end, char separator,
                 const std::string& source, int line, std::vector<CellSpan>& cells) {
  const auto fail = [&](std::string_view problem) {
    return InputError(fmt::format("{}:{}: {}", source, line, problem),
                      {.file = source, .line = line});
  };
  const auto skippable = [&](char c) { return is_blank(c) && (c != separator || c == blanks); };
  const auto ends_cell = [&](char c) {
    return c == separator || (separator == blanks && is_blank(c));
  };
  for (std::size_t at = begin;;) {
    while (at < end && skippable(text[at])) ++at;
    if (separator == blanks && at >= end) return;
    std::size_t first = at, last;
    if (at < end && text[at] == '"') {
      first = ++at;
      last = first;
      for (;; ++at) {
        if (at >= end) throw fail("the closing quote of a cell is missing on this line");
        if (text[at] == '"') {
          if (at + 1 < end && text[at + 1] == '"')
            ++at;
          else
            break;
        }
        text[last++] = text[at];
      }
      ++at;
      if (separator != blanks)
        while (at < end && skippable(text[at])) ++at;
      if (at < end && !ends_cell(text[at])) throw fail("text follows the closing quote of a cell");
    } else {
      while (at < end && !ends_cell(text[at])) ++at;
      last = at;
      while (last > first && is_blank(text[last - 1])) --last;
    }
    const std::size_t size =
        without_guard(std::string_view(text).substr(first, last - first)).size();
    cells.push_back({last - size, size});
    if (at >= end) return;
    ++at;
  }
}

std::optional<MeasuredCell> measured_cell(std::string_view cell) {
  const auto is_digit = [](char c) { return c >= '0' && c <= '9'; };
  constexpr std::string_view minus = "\u2212";
  std::size_t at = cell.starts_with(minus) ? minus.size() : 0;
  at = std::min(cell.find_first_not_of("+-., ", at), cell.size());
  // Most cells end in a digit. "1/min" is a unit.
  if (at == cell.size() || !is_digit(cell[at]) || is_digit(cell.back()) || find_unit(cell))
    return std::nullopt;
  at = std::min(cell.find_first_not_of("0123456789.,'", at), cell.size());
  if (at < cell.size() && (cell[at] == 'e' || cell[at] == 'E')) {
    const std::size_t power = std::min(cell.find_first_not_of("+-", at + 1), cell.size());
    if (power < cell.size() && is_digit(cell[power]))
      at = std::min(cell.find_first_not_of("0123456789", power), cell.size());
  }
  const MeasuredCell parts{trimmed(cell.substr(0, at)), trimmed(cell.substr(at))};
  if (parts.unit == "%") return parts;
  const bool is_word = !parts.unit.empty() && parts.unit.find_first_of("/-^(<[") != 0;
  return is_word && find_unit(parts.unit) ? std::optional(parts) : std::nullopt;
}

}  // namespace raceway::text
