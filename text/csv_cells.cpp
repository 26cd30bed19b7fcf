#include "text/detail/csv_cells.h"

#include <fmt/format.h>

#include <algorithm>

#include "text/detail/csv_text.h"
#include "text/error.h"

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
        if (at >= end) throw fail("a quoted cell is not closed on its line");
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

}  // namespace raceway::text
