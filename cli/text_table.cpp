#include "cli/text_table.h"

#include <fmt/format.h>
#include <sys/ioctl.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <string_view>

namespace raceway::cli {
namespace {

/// Characters of UTF-8 text, as far as they take place: a colour (ESC [ ... m) takes none.
std::size_t length(const std::string& text) {
  std::size_t count = 0;
  bool colour = false;
  for (const char c : text) {
    if (c == '\x1b') colour = true;
    if (!colour && (static_cast<unsigned char>(c) & 0xc0) != 0x80) ++count;
    if (c == 'm') colour = false;
  }
  return count;
}

int magnitude_of(double value) { return static_cast<int>(std::floor(std::log10(std::abs(value)))); }

}  // namespace

std::vector<std::string> filled(std::string_view words, std::size_t width) {
  std::vector<std::string> lines(1);
  for (std::size_t begin = 0; begin < words.size();) {
    const std::size_t end = std::min(words.find(' ', begin), words.size());
    const std::string word(words.substr(begin, end - begin));
    if (lines.back().empty())
      lines.back() = word;
    else if (length(lines.back()) + 1 + length(word) <= width)
      lines.back() += ' ' + word;
    else
      lines.push_back(word);
    begin = end + 1;
  }
  return lines;
}

std::vector<std::size_t> TextTable::widths() const {
  std::vector<std::size_t> result;
  for (std::size_t c = 0; c < columns_.size(); ++c) {
    std::size_t w = std::max(length(columns_[c].name), length(columns_[c].unit));
    for (const auto& row : rows_) w = std::max(w, length(row[c]));
    result.push_back(w);
  }
  return result;
}

TextTable TextTable::wrapped(std::size_t width) const {
  std::vector<Column> columns = columns_;
  columns.back().wraps = false;
  TextTable result(std::move(columns));
  const std::vector<std::size_t> all = widths();
  const std::size_t before = std::accumulate(all.begin(), all.end() - 1, 2 * (all.size() - 1));
  constexpr std::size_t least = 20;  // narrower is no column of words
  const std::size_t room = std::max(width > before ? width - before : 0, least);
  for (const auto& row : rows_) {
    std::vector<std::string> next = row;
    for (const std::string& line : filled(row.back(), room)) {
      next.back() = line;
      result.add(next);
      next.assign(row.size(), "");
    }
  }
  return result;
}

std::string TextTable::text(std::size_t width) const {
  if (columns_.back().wraps) return wrapped(width).text(width);
  const std::vector<std::size_t> widths = this->widths();
  std::string out;
  const auto put = [&](std::size_t c, const std::string& cell, bool first) {
    if (!first) out += "  ";
    const std::string blanks(widths[c] - length(cell), ' ');
    out += columns_[c].left ? cell + blanks : blanks + cell;
  };
  const auto end_line = [&] {
    while (!out.empty() && out.back() == ' ') out.pop_back();
    out += '\n';
  };
  for (std::size_t begin = 1; begin < columns_.size() || begin == 1;) {
    std::size_t end = begin, used = widths[0];
    while (end < columns_.size() && (end == begin || used + 2 + widths[end] <= width))
      used += 2 + widths[end++];
    const auto line = [&](auto cell_of) {
      put(0, cell_of(std::size_t{0}), true);
      for (std::size_t c = begin; c < end; ++c) put(c, cell_of(c), false);
      end_line();
    };
    if (begin > 1) out += '\n';
    line([&](std::size_t c) { return columns_[c].name; });
    const auto has_unit = [](const Column& c) { return !c.unit.empty(); };
    const auto at = [&](std::size_t c) {
      return columns_.begin() + static_cast<std::ptrdiff_t>(c);
    };
    if (has_unit(columns_[0]) || std::any_of(at(begin), at(end), has_unit))
      line([&](std::size_t c) { return columns_[c].unit; });
    for (const auto& row : rows_) line([&](std::size_t c) { return row[c]; });
    if (end == columns_.size()) break;
    begin = end;
  }
  return out;
}

std::string beside(double value, double scale, int digits, bool sign) {
  const int magnitude = scale == 0.0 || !std::isfinite(scale) ? 0 : magnitude_of(scale);
  if (!std::isfinite(value) || magnitude < -4 || magnitude > 7) return number(value, digits);
  const int decimals = std::max(0, digits - 1 - magnitude);
  if (std::abs(value) < 0.5 * std::pow(10.0, -decimals))
    return fmt::format("{:.{}f}", 0.0, decimals);
  return sign ? fmt::format("{:+.{}f}", value, decimals) : fmt::format("{:.{}f}", value, decimals);
}

std::size_t terminal_width(int stream) {
  winsize size{};
  if (isatty(stream) != 0 && ioctl(stream, TIOCGWINSZ, &size) == 0 && size.ws_col > 20)
    return size.ws_col;
  return 80;
}

}  // namespace raceway::cli
