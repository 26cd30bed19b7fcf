#include "files/detail/impossible_cells.h"

#include <algorithm>
#include <cmath>
#include <iterator>

#include "record/series_channel.h"

namespace raceway::files {
namespace {

constexpr double usual_marks[] = {999.0,   999.9,   9999.0,   9999.9,  9999.99,
                                  99999.0, 99999.9, 999999.0, 999999.9};

constexpr double beyond_instruments = 9e36;

bool is_mark(double value) {
  const double size = std::abs(value);
  return size >= beyond_instruments ||
         std::find(std::begin(usual_marks), std::end(usual_marks), size) != std::end(usual_marks);
}

/// A speed or a load may be 9999 as it is set.
bool is_mark(double value, const record::Channel& channel) {
  const bool as_set = channel.role == record::Role::setting &&
                      std::abs(value) < beyond_instruments && value == std::floor(std::abs(value));
  return is_mark(value) && !as_set;
}

/// True far from all other numbers of a column, of which these are the least and the greatest.
bool is_apart(double value, double lower, double upper) {
  constexpr double far = 3.0;  // ranges of the column
  const double margin = far * std::max(upper - lower, 1e-3 * std::abs(value));
  return value < lower - margin || value > upper + margin;
}

}  // namespace

ImpossibleCells::ImpossibleCells(const text::CsvTable& table, const ColumnSource& source,
                                 bool with_sign)
    : table_(table),
      source_(source),
      range_(range_of(source, with_sign)),
      judges_range_(source.channel->role == record::Role::measured ||
                    record::is_temperature(*source.channel)) {}

bool ImpossibleCells::has(std::size_t row) {
  if (!may_be(row)) return false;
  const text::ParsedNumber number = table_.parsed(row, source_.column);
  if (!number.problem.empty() ||
      !(is_mark(number.value, *source_.channel) || is_beyond(number.value)))
    return false;
  if (!looked_) look();
  if (is_beyond(number.value) && few_beyond_) return true;
  return is_mark(number.value, *source_.channel) && is_apart(number.value, lower_, upper_);
}

/// Cheaper than the number: such a cell begins with three digits, or has an exponent or thousands.
bool ImpossibleCells::may_be(std::size_t row) const {
  if (table_.is_numeric(source_.column)) return true;
  const std::string_view cell = table_.cell(row, source_.column);
  const std::size_t first = std::min(cell.find_first_of("0123456789"), cell.size());
  const std::size_t end = std::min(cell.find_first_not_of("0123456789", first), cell.size());
  if (end - first >= 3 || cell.find_first_of("eE'", end) != cell.npos) return true;
  const std::size_t mark = cell.find_first_of(".,", end);
  return mark != cell.npos && cell.find_first_of(".,", mark + 1) != cell.npos;
}

bool ImpossibleCells::is_beyond(double value) const {
  return judges_range_ && !(value >= range_.lower && value <= range_.upper);
}

void ImpossibleCells::look() {
  looked_ = true;
  constexpr double most_beyond = 0.1;
  std::size_t beyond = 0, others = 0;
  for (std::size_t row = 0; row < table_.rows(); ++row) {
    const text::ParsedNumber number = table_.parsed(row, source_.column);
    if (!number.problem.empty() || is_mark(number.value, *source_.channel)) continue;
    if (is_beyond(number.value)) {
      ++beyond;
      continue;
    }
    ++others;
    lower_ = std::min(lower_, number.value);
    upper_ = std::max(upper_, number.value);
  }
  few_beyond_ = static_cast<double>(beyond) <= most_beyond * static_cast<double>(others);
}

std::vector<std::size_t> places_of_marks(std::span<const double> numbers) {
  double lower = std::numeric_limits<double>::infinity(), upper = -lower;
  for (const double number : numbers)
    if (!is_mark(number)) lower = std::min(lower, number), upper = std::max(upper, number);
  std::vector<std::size_t> places;
  for (std::size_t k = 0; k < numbers.size() && lower <= upper; ++k)
    if (is_mark(numbers[k]) && is_apart(numbers[k], lower, upper)) places.push_back(k);
  return places;
}

std::string drop_impossible_rows(text::CsvTable& table, const std::vector<ColumnSource>& columns) {
  std::vector<ImpossibleCells> cells;
  std::vector<std::size_t> in;
  for (const ColumnSource& source : columns)
    if (source.channel->is_input() || source.channel->role == record::Role::measured)
      cells.emplace_back(table, source, false), in.push_back(source.column);
  return drop_rows(
      table,
      [&](std::size_t row) {
        return std::any_of(cells.begin(), cells.end(),
                           [&](ImpossibleCells& of) { return of.has(row); });
      },
      "have a number that cannot be a reading (such as -9999, or a physically impossible value)");
}

}  // namespace raceway::files
