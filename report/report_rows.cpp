#include "report/detail/report_rows.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "text/number_text.h"
#include "verdict/misfit_map.h"

namespace raceway::report {
namespace {

using record::Channel;

constexpr std::size_t nowhere = std::numeric_limits<std::size_t>::max();

text::json axis_json(const std::vector<verdict::ErrorRange>& ranges) {
  text::json list = text::json::array();
  for (const verdict::ErrorRange& r : ranges) {
    if (r.is_run())
      list.push_back({{"run", r.run}});
    else
      list.push_back({{"from", text::value_in_unit(*r.channel, r.from)},
                      {"to", text::value_in_unit(*r.channel, r.to)}});
  }
  return list;
}

text::json map_json(const verdict::MisfitMap& map, double unit) {
  text::json cells = text::json::array();
  for (const verdict::MisfitCell& c : map.cells)
    cells.push_back({{"across", c.across},
                     {"up", c.up},
                     {"rows", c.rows},
                     {"bias", c.bias / unit},
                     {"sigmas", c.sigmas},
                     {"significant", c.significant}});
  const auto column = [](const Channel* c) { return c ? c->name : std::string_view(); };
  return {{"across_column", column(map.across_channel)},
          {"up_column", column(map.up_channel)},
          {"across", axis_json(map.across)},
          {"up", axis_json(map.up)},
          {"needed_sigmas", map.needed_sigmas},
          {"cells", cells}};
}

/// Exactly, where a record's own varies() asks for a step.
bool differ(const std::vector<double>& values) {
  return std::any_of(values.begin(), values.end(), [&](double v) { return v != values.front(); });
}

}  // namespace

ReportRows::ReportRows(const record::Record& record, const Channel& channel,
                       std::vector<std::size_t> rows)
    : record_(record),
      channel_(channel),
      rows_(std::move(rows)),
      place_(record.rows(), nowhere),
      columns_(rows_.size()) {
  for (std::size_t k = 0; k < rows_.size(); ++k) place_[rows_[k]] = k;
  std::vector<double> lines, runs;
  for (const std::size_t row : rows_) {
    lines.push_back(record.line(row));
    runs.push_back(by_record() ? static_cast<double>(record.part_of(row)) : record.run_of(row));
  }
  columns_.add("line", std::move(lines));
  if (record.runs.size() > 1 || by_record()) columns_.add("run", std::move(runs));
  add_inputs();
  add_readings("measured", picked(record.values(channel)));
}

std::vector<double> ReportRows::picked(std::span<const double> values) const {
  std::vector<double> result;
  result.reserve(rows_.size());
  for (const std::size_t row : rows_) result.push_back(values[row]);
  return result;
}

/// What was known of it. A shaft has thrust alone, and a lubricant only where it was measured.
bool ReportRows::shows(const record::Column& input) const {
  const std::vector<double> values = picked(input.values);
  if (std::all_of(values.begin(), values.end(), [](double v) { return std::isnan(v); }))
    return false;
  if (!(channel_ == record::axial_displacement)) return true;
  if (*input.channel == record::radial_load) return false;
  return !(*input.channel == record::temperature) || differ(values);
}

void ReportRows::add_inputs() {
  const auto add = [&](const record::Column& column) {
    std::vector<double> values = picked(column.values);
    for (double& v : values) v = text::value_in_unit(*column.channel, v);
    columns_.add(std::string(column.channel->name), std::move(values));
  };
  for (const record::Column& c : record_.columns)
    if (c.channel->role == record::Role::time && shows(c)) add(c);
  for (const record::Column& c : record_.columns) {
    if (!c.channel->is_input() || !shows(c)) continue;
    add(c);
    inputs_.emplace_back(c.channel->name);
  }
}

std::vector<double> ReportRows::by_row(const verdict::Comparison& comparison,
                                       std::span<const double> values) const {
  std::vector<double> result(rows_.size(), unset);
  for (std::size_t i = 0; i < comparison.errors.size(); ++i)
    if (const std::size_t k = place_[comparison.errors[i].row]; k != nowhere) result[k] = values[i];
  return result;
}

std::string ReportRows::add_readings(const std::string& name, std::vector<double> values) {
  for (double& v : values) v = channel_.in_unit(v);
  std::string column = name + "_" + std::string(channel_.key_unit());
  columns_.add(column, std::move(values));
  return column;
}

void ReportRows::add_std(std::vector<double> std) {
  std_ = std;
  for (double& v : std) v /= channel_.factor;
  columns_.add("std_" + std::string(channel_.key_unit()), std::move(std));
}

void ReportRows::add_model(const std::string& name, const verdict::Comparison& comparison) {
  std::vector<double> predicted, std;
  for (const verdict::RowError& e : comparison.errors) {
    predicted.push_back(e.predicted);
    std.push_back(place_[e.row] == nowhere ? unset : std_.at(place_[e.row]));
  }
  for (const verdict::RowError& e : comparison.worst)
    if (place_[e.row] != nowhere) columns_.keep(place_[e.row]);
  const std::string column =
      add_readings("predicted_" + std::to_string(models_.size()), by_row(comparison, predicted));
  models_.push_back(
      {{"name", name},
       {"column", column},
       {"rmse", comparison.rmse / channel_.factor},
       {"map", map_json(verdict::misfit_map(comparison, record_, std), channel_.factor)}});
}

void ReportRows::finish(Document& document) const {
  if (!models_.empty()) document.add("models", models_);
  document.add(
      "quantity",
      {{"name", channel_.variable}, {"in_words", channel_.words}, {"unit", channel_.key_unit()}});
  document.add("inputs", inputs_);
  std::vector<std::string> runs = record_.runs;
  if (by_record()) {
    runs.clear();
    for (const record::Part& part : record_.parts) runs.push_back(part.name);
  }
  document.add("runs", runs);
  document.add_text("rows", columns_.json());
}

std::vector<std::size_t> rows_read(const record::Record& record, const Channel& channel) {
  std::vector<std::size_t> rows;
  const std::span<const double> readings = record.values(channel);
  for (std::size_t row = 0; row < readings.size(); ++row)
    if (!std::isnan(readings[row])) rows.push_back(row);
  return rows;
}

std::vector<std::size_t> rows_compared(const verdict::Comparison& comparison) {
  std::vector<std::size_t> rows;
  for (const verdict::RowError& e : comparison.errors) rows.push_back(e.row);
  std::sort(rows.begin(), rows.end());
  return rows;
}

}  // namespace raceway::report
