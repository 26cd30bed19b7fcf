#include "io/data_file.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <unordered_map>

#include "bearing/units.h"
#include "io/bad_cells.h"
#include "io/csv.h"
#include "io/error.h"
#include "io/names.h"

namespace raceway::io {
namespace {

/// A column of numbers that is understood: `value * factor + offset` is SI.
struct Column {
  std::string_view name;
  std::string_view unit;
  double factor, offset;
  double lower, upper;  ///< closed, in `unit`
};

constexpr double endless = std::numeric_limits<double>::max();

enum Known : std::size_t {
  speed,
  axial_load,
  radial_load,
  temperature,
  inner_temperature,
  outer_temperature,
  time,
  preload,
  torque,
  displacement,
  torque_std,
  displacement_std,
  known_count
};

constexpr std::array<Column, known_count> columns{{
    {"speed_rpm", "rpm", rpm, 0, 0, 1e6},
    {"axial_load_N", "N", 1, 0, 0, 1e8},
    {"radial_load_N", "N", 1, 0, 0, 1e8},
    {"temperature_C", "C", 1, celsius_zero, -273, 500},
    {"inner_ring_temperature_C", "C", 1, celsius_zero, -273, 500},
    {"outer_ring_temperature_C", "C", 1, celsius_zero, -273, 500},
    {"time_s", "s", 1, 0, -endless, endless},
    {"preload_N", "N", 1, 0, 0, 1e8},
    {"friction_torque_Nmm", "N mm", N_mm, 0, -1e9, 1e9},
    {"axial_displacement_um", "um", um, 0, -1e6, 1e6},
    // A reading without any scatter would outweigh all others.
    {"std_Nmm", "N mm", N_mm, 0, 1e-9, 1e9},
    {"std_um", "um", um, 0, 1e-9, 1e6},
}};

constexpr std::string_view run_id = "run_id";

std::string joined(const std::vector<std::string>& words) {
  std::string text;
  for (std::size_t i = 0; i < words.size(); ++i)
    text += (i == 0 ? "" : i + 1 == words.size() ? " and " : ", ") + words[i];
  return text;
}

class Reader {
 public:
  Reader(CsvTable table, const fit::Rig& rig, const fit::Shaft* shaft)
      : table_(std::move(table)), rig_(rig), shaft_(shaft), bad_(table_.source, table_.rows()) {
    for (std::size_t k = 0; k < known_count; ++k) {
      column_[k] = table_.column(columns[k].name);
      values_[k].clear();
    }
    run_column_ = table_.column(run_id);
  }

  Measurement read() {
    check_columns();
    for (std::size_t k = 0; k < known_count; ++k)
      if (column_[k]) read_column(k);
    check_decimal_marks();
    read_runs();
    note_form();
    fill_in_from_rig();
    if (!has(torque) && !has(displacement)) return coast_down();
    bad_.throw_if_any();
    return data_set();
  }

 private:
  [[nodiscard]] bool has(std::size_t k) const { return column_[k].has_value(); }
  [[nodiscard]] std::string header_place() const {
    return fmt::format("{}:{}", table_.source, table_.header_line);
  }

  void check_columns() {
    std::vector<std::string> known{std::string(run_id)};
    for (const Column& c : columns) known.emplace_back(c.name);
    for (const std::string& name : table_.header) {
      if (std::find(known.begin(), known.end(), name) != known.end()) continue;
      if (const auto near = nearest_name(name, known))
        throw InputError(
            fmt::format("{}: column {} is unknown; did you mean {}?", header_place(), name, *near));
      notes_.push_back(fmt::format("column {} is unknown and ignored", name));
    }
    if (!has(speed))
      throw InputError(fmt::format("{}: column speed_rpm is missing; the header has {}",
                                   header_place(), joined(table_.header)));
    if (!has(torque) && !has(displacement)) {
      if (!has(time))
        throw InputError(fmt::format(
            "{}: no measured column: friction_torque_Nmm or axial_displacement_um is expected, or "
            "time_s for a coast-down; the header has {}",
            header_place(), joined(table_.header)));
      if (!(rig_.inertia > 0.0))
        throw InputError(fmt::format(
            "{}: no measured column: friction_torque_Nmm or axial_displacement_um is expected; for "
            "a coast-down (time_s and speed_rpm alone) the model needs inertia_kgm2 under [rig]",
            header_place()));
    }
    if (has(torque_std) && !has(torque))
      throw InputError(header_place() + ": column std_Nmm has no friction_torque_Nmm beside it");
    if (has(displacement_std) && !has(displacement))
      throw InputError(header_place() + ": column std_um has no axial_displacement_um beside it");
    if (!has(axial_load) && !shaft_ && std::isnan(rig_.axial_load))
      throw InputError(fmt::format(
          "{}: the axial load is neither in a column axial_load_N nor in the model; write "
          "axial_load_N under [rig], 0 if the load is unknown or none",
          header_place()));
  }

  void read_column(std::size_t k) {
    Column c = columns[k];
    if (shaft_ && k == axial_load) c.lower = -c.upper;
    std::vector<double>& values = values_[k];
    values.reserve(table_.rows());
    for (std::size_t row = 0; row < table_.rows(); ++row) {
      const std::string_view cell = table_.cell(row, *column_[k]);
      const ParsedNumber number = parse_number(cell, table_.separator != ',');
      if (!number.problem.empty()) {
        bad_.add(table_.line(row), c.name, cell, number.problem);
      } else if (!(number.value >= c.lower && number.value <= c.upper)) {
        bad_.add(table_.line(row), c.name, cell,
                 fmt::format("must be from {} to {} {}", c.lower, c.upper, c.unit));
      }
      if (number.decimal_mark != '\0') {
        Mark& mark = number.decimal_mark == ',' ? comma_ : point_;
        if (mark.line == 0) mark = {table_.line(row), std::string(cell)};
      }
      values.push_back(number.value * c.factor + c.offset);
    }
  }

  void check_decimal_marks() const {
    if (comma_.line == 0 || point_.line == 0) return;
    throw InputError(fmt::format(
        "{}:{}: {} has a decimal comma, but {} in line {} a decimal point; use one of them",
        table_.source, comma_.line, comma_.cell, point_.cell, point_.line));
  }

  void read_runs() {
    if (!run_column_) return;
    std::unordered_map<std::string, int> index;
    run_of_row_.reserve(table_.rows());
    for (std::size_t row = 0; row < table_.rows(); ++row) {
      const std::string_view cell = table_.cell(row, *run_column_);
      if (cell.empty()) bad_.add(table_.line(row), run_id, cell, "is empty");
      const auto [entry, is_new] = index.emplace(cell, static_cast<int>(runs_.size()));
      if (is_new) runs_.emplace_back(cell);
      run_of_row_.push_back(entry->second);
    }
  }

  void note_form() {
    std::vector<std::string> form;
    if (table_.separator == ';') form.emplace_back("semicolons");
    if (table_.separator == '\t') form.emplace_back("tabs");
    if (comma_.line != 0) form.emplace_back("decimal commas");
    if (table_.byte_order_mark) form.emplace_back("a byte order mark");
    if (table_.carriage_returns) form.emplace_back("CRLF line ends");
    if (!form.empty()) notes_.insert(notes_.begin(), "read with " + joined(form));
    notes_.insert(notes_.begin(), table_.notes.begin(), table_.notes.end());
  }

  void fill_in_from_rig() {
    const auto fill = [&](std::size_t k, double value, double shown,
                          std::string_view from = "[rig]") {
      if (has(k)) return;
      values_[k].assign(table_.rows(), value);
      notes_.push_back(fmt::format("no column {}: {:.6g} {} for all rows, from {}", columns[k].name,
                                   shown, columns[k].unit, from));
    };
    if (shaft_ && has(inner_temperature) != has(outer_temperature))
      notes_.push_back(fmt::format(
          "no column {}: that of [arrangement] for all rows, else as mounted",
          columns[has(inner_temperature) ? outer_temperature : inner_temperature].name));
    if (shaft_)
      fill(axial_load, shaft_->external_load, shaft_->external_load,
           "external_load_N of [arrangement]");
    else
      fill(axial_load, rig_.axial_load, rig_.axial_load);
    fill(radial_load, rig_.radial_load, rig_.radial_load);
    fill(temperature, rig_.temperature, celsius(rig_.temperature));
  }

  [[nodiscard]] bearing::OperatingPoint point(std::size_t row) const {
    return {.speed = values_[speed][row],
            .axial_load = values_[axial_load][row],
            .radial_load = values_[radial_load][row],
            .temperature = values_[temperature][row]};
  }
  [[nodiscard]] double value(std::size_t k, std::size_t row) const {
    return has(k) ? values_[k][row] : unset;
  }
  [[nodiscard]] int run(std::size_t row) const { return run_column_ ? run_of_row_[row] : -1; }

  Measurement data_set() {
    fit::DataSet data;
    data.source = table_.source;
    const bool of_torque = has(torque) && !(shaft_ && has(displacement));
    const std::size_t measured = of_torque ? torque : displacement;
    const std::size_t std = of_torque ? torque_std : displacement_std;
    data.quantity = of_torque ? fit::Quantity::friction_torque : fit::Quantity::axial_displacement;
    if (has(torque) && has(displacement))
      notes_.push_back(fmt::format("two measured columns: {} is used, {} is not",
                                   columns[measured].name,
                                   columns[of_torque ? displacement : torque].name));
    if (shaft_ && has(radial_load))
      notes_.emplace_back("radial_load_N is not used: the sets on a shaft take axial load alone");
    if (has(std)) data.noise = fit::NoiseSource::declared;
    std::unordered_map<int, double> last_time;
    int back = 0;
    data.rows.reserve(table_.rows());
    for (std::size_t row = 0; row < table_.rows(); ++row) {
      data.rows.push_back({.point = point(row),
                           .inner_ring_temperature = value(inner_temperature, row),
                           .outer_ring_temperature = value(outer_temperature, row),
                           .preload = value(preload, row),
                           .time = value(time, row),
                           .measured = value(measured, row),
                           .std = value(std, row),
                           .run = run(row),
                           .line = table_.line(row)});
      if (!has(time)) continue;
      const auto [last, is_new] = last_time.emplace(run(row), value(time, row));
      if (!is_new && value(time, row) < last->second && back == 0) back = table_.line(row);
      last->second = value(time, row);
    }
    if (back != 0)
      notes_.push_back(
          fmt::format("time_s goes back at line {}; rows are taken as they stand", back));
    data.runs = std::move(runs_);
    data.notes = std::move(notes_);
    return data;
  }

  Measurement coast_down() {
    fit::CoastDownRecord record;
    record.source = table_.source;
    if (!run_column_) {
      runs_.emplace_back("1");
      notes_.emplace_back("no column run_id: all rows are taken as one run");
    }
    std::vector<double> last_time(runs_.size(), -std::numeric_limits<double>::infinity());
    std::size_t slow = 0;
    for (std::size_t row = 0; row < table_.rows(); ++row) {
      const int run_index = run_column_ ? run_of_row_[row] : 0;
      double& last = last_time[static_cast<std::size_t>(run_index)];
      const double now = values_[time][row];
      if (now <= last)
        bad_.add(table_.line(row), "time_s", table_.cell(row, *column_[time]),
                 "must increase within a run");
      if (!std::isnan(now)) last = now;
      if (values_[speed][row] < rig_.minimum_speed) {
        ++slow;
        continue;
      }
      record.samples.push_back({.time = now,
                                .speed = values_[speed][row],
                                .run = run_index,
                                .line = table_.line(row),
                                .point = point(row)});
    }
    bad_.throw_if_any();
    if (record.samples.empty())
      throw InputError(fmt::format(
          "{}: all {} rows are below minimum_speed_rpm = {:.6g} of [rig]; nothing is left",
          table_.source, slow, rig_.minimum_speed / rpm));
    if (slow > 0)
      notes_.push_back(fmt::format("{} of {} rows below minimum_speed_rpm = {:.6g} left out", slow,
                                   table_.rows(), rig_.minimum_speed / rpm));
    record.runs = std::move(runs_);
    record.notes = std::move(notes_);
    return record;
  }

  struct Mark {
    int line = 0;
    std::string cell;
  };

  CsvTable table_;
  const fit::Rig& rig_;
  const fit::Shaft* shaft_;  // null for a bearing on a rig
  BadCells bad_;
  std::array<std::optional<std::size_t>, known_count> column_;
  std::array<std::vector<double>, known_count> values_;  // SI
  std::optional<std::size_t> run_column_;
  std::vector<int> run_of_row_;
  std::vector<std::string> runs_, notes_;
  Mark comma_, point_;
};

}  // namespace

Measurement read_measurement(const std::string& path, const fit::Rig& rig,
                             const fit::Shaft* shaft) {
  return Reader(read_csv(path), rig, shaft).read();
}

Measurement parse_measurement(std::string text, const std::string& source, const fit::Rig& rig,
                              const fit::Shaft* shaft) {
  return Reader(parse_csv(std::move(text), source), rig, shaft).read();
}

}  // namespace raceway::io
