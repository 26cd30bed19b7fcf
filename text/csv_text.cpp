#include "text/detail/csv_text.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <string>

#include "text/printable.h"
#include "text/twelve_digits.h"

namespace raceway::text {
namespace {

/// With =, +, - or @, also behind apostrophes, so that each of these can be undone.
bool begins_as_formula(std::string_view cell) {
  const std::size_t first = cell.find_first_not_of('\'');
  return first != cell.npos && std::string_view("=+-@").find(cell[first]) != std::string_view::npos;
}

}  // namespace

void append_model(fmt::memory_buffer& out, std::string_view model_text) {
  const auto put = std::back_inserter(out);
  fmt::format_to(put, "# model:\n");
  while (!model_text.empty()) {
    const std::size_t end = std::min(model_text.find('\n'), model_text.size());
    std::string_view line = model_text.substr(0, end);
    if (line.ends_with('\r')) line.remove_suffix(1);
    fmt::format_to(put, "{}{}{}\n", model_mark, line.empty() ? "" : " ", line);
    model_text.remove_prefix(std::min(end + 1, model_text.size()));
  }
}

void append_text(fmt::memory_buffer& out, std::string_view text) {
  std::string cell = printable(text);
  if (begins_as_formula(cell)) cell.insert(0, 1, '\'');
  const bool plain = cell.find_first_of(",;\"") == cell.npos && !cell.starts_with('#') &&
                     !cell.starts_with(' ') && !cell.ends_with(' ');
  if (!plain) {
    for (std::size_t at = 0; (at = cell.find('"', at)) != cell.npos; at += 2)
      cell.insert(at, 1, '"');
    cell = '"' + cell + '"';
  }
  out.append(cell.data(), cell.data() + cell.size());
}

std::string_view without_guard(std::string_view cell) {
  if (cell.starts_with('\'') && begins_as_formula(cell.substr(1))) cell.remove_prefix(1);
  return cell;
}

void append_value(fmt::memory_buffer& out, double value) {
  if (!std::isfinite(value)) return;
  char text[twelve_digits_room];
  out.append(text, write_12_digits(text, value));
}

}  // namespace raceway::text
