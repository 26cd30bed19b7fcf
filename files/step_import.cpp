#include "files/step_import.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <optional>
#include <stdexcept>
#include <tuple>
#include <utility>

#include "files/detail/impossible_cells.h"
#include "text/bad_cells.h"
#include "text/csv.h"
#include "text/input_file.h"
#include "text/missing_cell.h"
#include "text/names.h"
#include "text/units.h"

namespace raceway::files {
namespace {

/// A column of a file of load cases.
struct LoadColumn {
  std::string_view name;            ///< with our unit
  std::string_view quantity, also;  ///< without
  text::Dimension dimension;
  double factor;        ///< of our unit
  double lower, upper;  ///< SI
};
constexpr double longest_time = 1e12;
constexpr LoadColumn of_time{"time_s", "time", "t", text::Dimension::time, 1.0, 0.0, longest_time};
constexpr LoadColumn of_displacement{"axial_displacement_um",
                                     "axial_displacement",
                                     "displacement",
                                     text::Dimension::length,
                                     um,
                                     -1.0,
                                     1.0};
constexpr LoadColumn of_power{"power_W", "power", "power_loss", text::Dimension::power,
                              1.0,       0.0,     1e7};
constexpr LoadColumn of_speed{"speed_rpm", "speed", "n",      text::Dimension::speed,
                              rpm,         0.0,     1e6 * rpm};
constexpr std::string_view name_column = "load_case";
constexpr std::string_view is_no_reading =
    "is not a reading, but a number that marks a missing reading";

struct FoundLoadColumn {
  std::size_t at;
  double factor;  ///< SI of one unit of the file
};

std::optional<FoundLoadColumn> find_load_column(const text::CsvTable& table,
                                                const LoadColumn& wanted) {
  for (std::size_t c = 0; c < table.header.size(); ++c) {
    const text::HeaderParts parts = text::header_parts(table.header[c]);
    const std::string name = text::lower_case(parts.name);
    if (name != wanted.quantity && name != wanted.also) continue;
    if (parts.unit.empty()) continue;
    const text::Unit* const unit = text::find_unit(parts.unit, wanted.dimension);
    if (unit) return FoundLoadColumn{c, unit->factor};
  }
  return std::nullopt;
}

FoundLoadColumn require_load_column(const text::CsvTable& table, const LoadColumn& wanted) {
  if (const auto found = find_load_column(table, wanted)) return *found;
  throw text::InputError(
      fmt::format("{}:{}: column {} is missing{}; a file of load cases needs load_case, time_s, "
                  "axial_displacement_um and power_W or speed_rpm; the header has {}",
                  table.source, table.header_line, wanted.name,
                  text::suggestion(wanted.name, table.header), text::listed(table.header)),
      table.header_place(wanted.name));
}

std::vector<double> load_values(const text::CsvTable& table,
                                const std::optional<FoundLoadColumn>& column,
                                const LoadColumn& what, text::BadCells& bad) {
  std::vector<double> result;
  if (!column) return result;
  const std::string& name = table.header[column->at];
  const text::CellRange range{name, what.lower / column->factor, what.upper / column->factor,
                              text::header_parts(name).unit};
  for (std::size_t row = 0; row < table.rows(); ++row)
    result.push_back(text::read_cell(table, row, column->at, range, bad).value);
  if (what.dimension == text::Dimension::length)
    for (const std::size_t row : places_of_marks(result))
      bad.add(table.line(row), name, table.shown(row, column->at), is_no_reading);
  for (double& value : result) value *= column->factor;
  return result;
}

/// What every load case is held to, however it was written: rising times, and a displacement that
/// begins at zero.
void finish_load(LoadCase& load) {
  std::vector<std::size_t> order(load.time.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t a, std::size_t b) { return load.time[a] < load.time[b]; });
  std::vector<double> time, displacement;
  for (const std::size_t k : order) {
    if (!time.empty() && time.back() == load.time[k])
      throw text::InputError(fmt::format("{}: load case {}: the time {:.6g} s occurs twice; give "
                                         "each load case a different name in the column load_case",
                                         load.place.text(), load.name, load.time[k]),
                             load.place);
    time.push_back(load.time[k]);
    displacement.push_back(load.displacement[k]);
  }
  if (!time.empty() && time.front() == 0.0) load.at_once = displacement.front();
  for (double& u : displacement) u -= load.at_once;
  load.time = std::move(time);
  load.displacement = std::move(displacement);
}

/// The first and the last value of a column over the rows of a case, by time.
std::pair<double, double> ends_of_load(const std::vector<double>& column,
                                       const std::vector<double>& time,
                                       const std::vector<std::size_t>& rows) {
  if (column.empty()) return {unset, unset};
  const auto earlier = [&](std::size_t a, std::size_t b) { return time[a] < time[b]; };
  return {column[*std::min_element(rows.begin(), rows.end(), earlier)],
          column[*std::max_element(rows.begin(), rows.end(), earlier)]};
}

std::vector<LoadCase> load_cases(const text::CsvTable& table) {
  const FoundLoadColumn time_at = require_load_column(table, of_time),
                        moved_at = require_load_column(table, of_displacement);
  const auto power_at = find_load_column(table, of_power),
             speed_at = find_load_column(table, of_speed);
  if (!power_at && !speed_at) (void)require_load_column(table, of_power);
  const auto name_at = table.column(name_column);
  text::BadCells bad(table.source, table.rows());
  const std::vector<double> time = load_values(table, time_at, of_time, bad);
  const std::vector<double> moved = load_values(table, moved_at, of_displacement, bad);
  const std::vector<double> power = load_values(table, power_at, of_power, bad);
  const std::vector<double> speed = load_values(table, speed_at, of_speed, bad);
  bad.throw_if_any();

  // Rows of each case, in the order in which the cases come.
  const std::size_t key = name_at ? *name_at : power_at ? power_at->at : speed_at->at;
  std::vector<std::pair<std::string, std::vector<std::size_t>>> groups;
  for (std::size_t row = 0; row < table.rows(); ++row) {
    const std::string_view cell = table.cell(row, key);
    auto group =
        std::find_if(groups.begin(), groups.end(), [&](const auto& g) { return g.first == cell; });
    if (group == groups.end()) group = groups.insert(groups.end(), {std::string(cell), {}});
    group->second.push_back(row);
  }
  std::vector<LoadCase> cases;
  for (const auto& [name, rows] : groups) {
    const int line = table.line(rows.front());
    LoadCase load{.name = name_at ? name : fmt::format("{} = {}", table.header[key], name),
                  .place = {.file = table.source, .line = line, .key = {}}};
    std::tie(load.power_start, load.power_end) = ends_of_load(power, time, rows);
    for (const std::size_t row : rows) {
      load.time.push_back(time[row]);
      load.displacement.push_back(moved[row]);
      if (speed.empty()) continue;
      if (!std::isnan(load.speed) && speed[row] != load.speed)
        throw text::InputError(
            fmt::format("{}:{}: load case {}: the speed changes from {:.6g} to {:.6g} rpm; a step "
                        "response must have one speed",
                        table.source, table.line(row), load.name, load.speed / rpm,
                        speed[row] / rpm),
            {.file = table.source, .line = table.line(row), .key = table.header[speed_at->at]});
      load.speed = speed[row];
    }
    finish_load(load);
    cases.push_back(std::move(load));
  }
  return cases;
}

/// The load of "50W=a.csv" into a case; the file.
std::string read_named_load(const std::string& given, LoadCase& load) {
  const auto fail = [&](std::string_view why) -> text::InputError {
    return text::InputError(
        fmt::format("--load-case {}: {}; write LOAD=FILE, such as 50W=a.csv or 6000rpm=b.csv",
                    given, why),
        {.key = "--load-case"});
  };
  const std::size_t equals = given.find('=');
  if (equals == given.npos || equals + 1 == given.size()) throw fail("must be LOAD=FILE");
  load.name = std::string(text::trimmed(std::string_view(given).substr(0, equals)));
  const std::size_t digits = load.name.find_first_not_of("0123456789.eE+-");
  if (digits == load.name.npos) throw fail("the load has no unit");
  const text::ParsedNumber number = text::parse_number(load.name.substr(0, digits), false);
  const std::string_view spelling = text::trimmed(std::string_view(load.name).substr(digits));
  if (!number.problem.empty() || !(number.value >= 0.0)) throw fail("the load is not a number");
  if (const text::Unit* const power = text::find_unit(spelling, text::Dimension::power))
    load.power_start = load.power_end = power->to_SI(number.value);
  else if (const text::Unit* const speed = text::find_unit(spelling, text::Dimension::speed))
    load.speed = speed->to_SI(number.value);
  else
    throw fail(fmt::format("{} is not a unit of power or speed", text::quoted(spelling)));
  return given.substr(equals + 1);
}

/// Whether commas are decimal marks: something else separates the numbers of a line.
bool has_decimal_commas(std::string_view line) {
  if (line.find_first_of(";\t") != line.npos) return true;
  const auto is_digit = [](char c) { return c >= '0' && c <= '9'; };
  for (std::size_t k = 1; k + 1 < line.size(); ++k) {
    if (line[k] != ' ' || !is_digit(line[k - 1])) continue;
    const std::size_t next = line.find_first_not_of(' ', k);
    if (next != line.npos && (is_digit(line[next]) || line[next] == '-')) return true;
  }
  return false;
}

/// A text that stands for a time and is no number, as "nan", "1.#IND" or "1e999"; no word or date
/// of a heading.
bool is_failed_time(std::string_view text) {
  if (text::is_missing(text)) return true;
  const bool digits_first = text.find_first_not_of("+-.") == text.find_first_of("0123456789") &&
                            text.find_first_of("0123456789") != text.npos;
  return digits_first &&
         (text.find('#') != text.npos || (text.find_first_of("eE") != text.npos &&
                                          text.find_first_not_of("0123456789.,eE+-") == text.npos));
}

/// The numbers of a line, NaN for a cell that is none; empty where it does not begin with a time.
std::vector<double> history_numbers(std::string_view line) {
  const bool commas_separate = !has_decimal_commas(line);
  const std::string_view separators = commas_separate ? ", \t\r" : "; \t\r";
  std::vector<double> result;
  for (std::size_t at = 0; at < line.size();) {
    const std::size_t begin = line.find_first_not_of(separators, at);
    if (begin == line.npos) break;
    const std::size_t end = std::min(line.find_first_of(separators, begin), line.size());
    const text::ParsedNumber number =
        text::parse_number(line.substr(begin, end - begin), !commas_separate);
    if (!number.problem.empty()) {
      if (result.empty() && !is_failed_time(line.substr(begin, end - begin))) return {};
      result.push_back(unset);
    } else {
      result.push_back(number.value);
    }
    at = end;
  }
  return result;
}

}  // namespace

std::vector<LoadCase> parse_load_cases(std::string text, const std::string& source) {
  return load_cases(text::parse_csv(std::move(text), source));
}

std::vector<LoadCase> read_load_cases(const std::string& path) {
  return load_cases(text::read_csv(path));
}

HistoryUnits history_units(std::string_view text, const std::string& flag) {
  const std::size_t comma = text.find(',');
  const text::Unit* const time =
      text::find_unit(text::trimmed(text.substr(0, comma)), text::Dimension::time);
  const text::Unit* const length =
      comma == text.npos
          ? nullptr
          : text::find_unit(text::trimmed(text.substr(comma + 1)), text::Dimension::length);
  if (!time || !length)
    throw text::InputError(
        fmt::format("{} {}: must be a unit of time and a unit of length, such as s,um or min,mm",
                    flag, text::quoted(text)),
        {.key = flag});
  return {time->factor, length->factor};
}

LoadCase read_history(const std::string& given, const HistoryUnits& units) {
  LoadCase load;
  const std::string path = read_named_load(given, load);
  const std::string text = text::read_text(path);
  load.place = {.file = text::input_name(path), .line = 1, .key = {}};
  int line_number = 0;
  std::vector<double> moved;  // as it stands in the file
  std::vector<int> lines;
  for (std::size_t at = 0; at < text.size();) {
    const std::size_t end = std::min(text.find('\n', at), text.size());
    const std::string_view line = std::string_view(text).substr(at, end - at);
    at = end + 1;
    ++line_number;
    const std::vector<double> row = history_numbers(line);
    if (row.empty()) continue;
    const text::Place place{.file = load.place.file, .line = line_number, .key = {}};
    const auto within = [](const LoadColumn& column, double value) {
      return value >= column.lower && value <= column.upper;
    };
    if (row.size() != 2 || !within(of_time, row[0] * units.time) ||
        !within(of_displacement, row[1] * units.length))
      throw text::InputError(
          fmt::format("{}: {}: must be a time from 0 to {:g} s and a displacement from {:g} to "
                      "{:g} m",
                      place.text(), text::quoted(text::trimmed(line)), of_time.upper,
                      of_displacement.lower, of_displacement.upper),
          place);
    load.time.push_back(row[0] * units.time);
    load.displacement.push_back(row[1] * units.length);
    moved.push_back(row[1]);
    lines.push_back(line_number);
  }
  text::BadCells bad(load.place.file, moved.size());
  for (const std::size_t k : places_of_marks(moved))
    bad.add(lines[k], "displacement", fmt::format("{}", moved[k]), is_no_reading);
  bad.throw_if_any();
  if (load.time.empty())
    throw text::InputError(
        fmt::format("{}: the file has no row with two numbers, time and displacement",
                    load.place.file),
        load.place);
  finish_load(load);
  return load;
}

std::vector<spindle::StepResponse> fit_load_cases(const std::vector<LoadCase>& cases) {
  std::vector<spindle::StepResponse> steps;
  for (const LoadCase& load : cases) {
    spindle::StepResponse step{.load_case = load.name,
                               .speed = load.speed,
                               .power_start = load.power_start,
                               .power_end = load.power_end,
                               .kinematic = load.at_once,
                               .end = load.displacement.back()};
    try {
      step.fit = spindle::fit_step(load.time, load.displacement);
    } catch (const std::invalid_argument& e) {
      throw text::InputError(
          fmt::format("{}: load case {}: {}", load.place.text(), load.name, e.what()), load.place);
    }
    step.status = spindle::Status::converged;
    step.time = load.time;
    step.displacement = load.displacement;
    steps.push_back(std::move(step));
  }
  return steps;
}

}  // namespace raceway::files
