#include "text/detail/decimal_marks.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <vector>

namespace raceway::text {
namespace {

bool is_digit(char c) { return c >= '0' && c <= '9'; }

std::string_view without_sign(std::string_view cell) {
  if (cell.starts_with('+') || cell.starts_with('-')) cell.remove_prefix(1);
  return cell;
}

/// Digits, marks, a sign and an exponent, beginning with a digit or a mark.
bool looks_like_number(std::string_view cell) {
  const std::string_view rest = without_sign(cell);
  return !rest.empty() && (is_digit(rest[0]) || rest[0] == '.' || rest[0] == ',') &&
         cell.find_first_not_of("0123456789.,+-eE") == cell.npos;
}

bool is_below_1000(std::string_view cell) {
  const std::string_view digits = without_sign(cell);
  return !digits.empty() && digits.size() <= 3 &&
         std::all_of(digits.begin(), digits.end(), is_digit);
}

/// Uses of one mark in the cells.
struct Uses {
  bool any = false, decimal = false;
  std::vector<std::uint8_t> grouped{}, as_decimal{};  ///< by column: a cell has it so
};

}  // namespace

bool is_grouped(std::string_view cell, char thousands, char decimal) {
  std::string_view digits = without_sign(cell);
  if (decimal != '\0')
    if (const std::size_t at = digits.find(decimal); at != digits.npos) {
      const std::string_view behind = digits.substr(at + 1);
      if (behind.empty() || !std::all_of(behind.begin(), behind.end(), is_digit)) return false;
      digits = digits.substr(0, at);
    }
  const std::size_t first = digits.find(thousands);
  if (first == digits.npos || first == 0 || first > 3 || digits[0] == '0') return false;
  for (std::size_t at = 0; at < digits.size(); ++at) {
    const bool mark_here = at >= first && (at - first) % 4 == 0;
    if (mark_here ? digits[at] != thousands : !is_digit(digits[at])) return false;
  }
  return (digits.size() - first) % 4 == 0;
}

bool may_have_thousands(std::span<const std::string_view> numbers) {
  const auto grouped = [](std::string_view n) { return is_grouped(n, '.'); };
  return std::any_of(numbers.begin(), numbers.end(), grouped) &&
         std::all_of(numbers.begin(), numbers.end(),
                     [&](std::string_view n) { return grouped(n) || is_below_1000(n); });
}

DecimalMarks find_decimal_marks(
    char separator, bool points, bool commas, std::size_t rows, std::size_t columns,
    const std::function<std::string_view(std::size_t row, std::size_t column)>& cell) {
  if (!points && !commas) return {};
  constexpr std::array marks{'.', ','};
  std::array<Uses, 2> uses;
  for (Uses& use : uses) use.grouped.resize(columns), use.as_decimal.resize(columns);
  std::vector<std::uint8_t> small(columns);  // whole numbers below 1000
  for (std::size_t row = 0; row < rows; ++row) {
    for (std::size_t column = 0; column < columns; ++column) {
      const std::string_view text = cell(row, column);
      const std::size_t mark = text.find_first_of(".,");
      if (mark == text.npos) {
        if (!small[column] && is_below_1000(text)) small[column] = 1;
        continue;
      }
      if (!looks_like_number(text)) continue;
      // One cell with both marks is told where its column is read.
      if (text.find(text[mark] == '.' ? ',' : '.') != text.npos) return {};
      Uses& use = uses[text[mark] == '.' ? 0 : 1];
      use.any = true;
      if (is_grouped(text, text[mark]))
        use.grouped[column] = 1;
      else if (text.find(text[mark], mark + 1) == text.npos)
        use.decimal = true, use.as_decimal[column] = 1;
    }
    // Both are decimal marks, which is told where the columns are read; or one, and no other is
    // left.
    if ((uses[0].decimal || !points) && (uses[1].decimal || !commas)) return {};
  }
  for (std::size_t k = 0; k < marks.size(); ++k) {
    const Uses &use = uses[k], &other = uses[1 - k];
    if (!use.any || use.decimal) continue;
    if (other.decimal) {
      // Both in one column are told where it is read.
      for (std::size_t column = 0; column < columns; ++column)
        if (use.grouped[column] && other.as_decimal[column]) return {};
      return {.thousands = marks[k]};
    }
    if (other.any || (marks[k] == ',' && separator == ',')) continue;
    bool beside = false, anywhere = false;
    for (std::size_t column = 0; column < columns; ++column) {
      beside |= use.grouped[column] && small[column];
      anywhere |= small[column] != 0;
    }
    if (beside || (anywhere && marks[k] == '.' && separator == ';')) return {.asked = marks[k]};
  }
  return {};
}

}  // namespace raceway::text
