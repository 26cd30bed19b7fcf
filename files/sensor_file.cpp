#include "files/sensor_file.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "files/detail/column_source.h"
#include "files/detail/impossible_cells.h"
#include "files/detail/signal_channels.h"
#include "record/digits.h"
#include "text/bad_cells.h"
#include "text/csv.h"
#include "text/detail/json_text.h"
#include "text/error.h"
#include "text/names.h"
#include "text/number_text.h"
#include "text/printable.h"

namespace raceway::files {
namespace {

const ColumnSource& required(const text::CsvTable& table, const Recognised& found,
                             const record::Channel& channel,
                             const record::Channel* other = nullptr) {
  if (const ColumnSource* const source = found.find(channel)) return *source;
  if (const ColumnSource* const source = other ? found.find(*other) : nullptr) return *source;
  throw text::InputError(
      fmt::format("{}:{}: column {} is missing{}; the header has {}. A calibration file needs the "
                  "columns {} and {}; "
                  "for columns with other names, use --columns FILE",
                  table.source, table.header_line, channel.name,
                  text::suggestion(channel.name, table.header), text::listed(table.header),
                  reference_torque.name, calibration_signal.name),
      {table.source, table.header_line, std::string(channel.name)});
}

SensorReadings readings_of(text::CsvTable table, const ReadOptions& options) {
  const Recognised found = recognise(table, options);
  const ColumnSource& reference = required(table, found, reference_torque);
  const ColumnSource& signal = required(table, found, calibration_signal, &torque_signal);
  SensorReadings result{
      .source = table.source,
      .notes = notes_of(record::note::read_as, table.notes, {.file = table.source})};
  result.notes.insert(result.notes.end(), found.notes.begin(), found.notes.end());
  for (const std::string& note :
       {options.drop_nan ? drop_empty_rows(table, {reference, signal}) : std::string(),
        drop_impossible_rows(table, {reference, signal})})
    if (!note.empty()) result.notes.push_back(record::note::left_out(note));
  std::vector<std::string> unused;
  for (std::size_t c = 0; c < table.header.size(); ++c)
    if (c != reference.column && c != signal.column) unused.push_back(table.header[c]);
  if (!unused.empty())
    result.notes.push_back(record::note::unused("not used: " + text::listed(unused)));
  text::BadCells bad(table.source, table.rows());
  for (std::size_t row = 0; row < table.rows(); ++row)
    result.readings.push_back({.torque = si_of_cell(table, row, reference, false, bad).value,
                               .signal = si_of_cell(table, row, signal, false, bad).value,
                               .line = table.line(row)});
  bad.throw_if_any();
  return result;
}

/// Of two coefficients; 0 where one does not scatter.
double correlation(const Eigen::MatrixXd& c, int i, int j) {
  if (i == j) return 1.0;
  const double scale = std::sqrt(c(i, i) * c(j, j));
  return scale > 0.0 ? std::clamp(c(i, j) / scale, -1.0, 1.0) : 0.0;
}

/// Lists of the file, a text for each number.
struct Lists {
  std::vector<std::string> coefficients{}, units{}, std{}, correlation{};
};

Lists lists_of(const rig::SensorCalibration& c) {
  Lists lists;
  for (int k = 0; k <= c.degree(); ++k) {
    lists.coefficients.push_back(fmt::format("{}", text::with_15_digits(c.sensor.coefficients[k])));
    lists.units.push_back(text::in_quotes(coefficient_unit(k)));
    lists.std.push_back(fmt::format("{}", record::with_digits(c.std(k), 6)));
    std::vector<std::string> row;
    for (int j = 0; j <= k; ++j)
      row.push_back(
          fmt::format("{}", record::with_digits(correlation(c.sensor.covariance, k, j), 12)));
    lists.correlation.push_back(fmt::format("  [{}],", fmt::join(row, ", ")));
  }
  return lists;
}

}  // namespace

SensorReadings read_sensor_readings(const Source& source, const ReadOptions& options) {
  return readings_of(read_measurements(source, options), options);
}

std::string coefficient_unit(int coefficient) {
  return coefficient == 0 ? "V" : coefficient == 1 ? "V/Nm" : fmt::format("V/Nm{}", coefficient);
}

std::string torque_sensor_text(const rig::SensorCalibration& c, std::string_view source) {
  const rig::TorqueSensor& s = c.sensor;
  const Lists lists = lists_of(c);
  const auto digits = [](double value) { return fmt::format("{}", text::with_15_digits(value)); };
  return fmt::format(
      "[torque_sensor]  # signal in V = sum of c_k M^k (c_k: coefficients from k = 0, M: "
      "torque in N m)\n"
      "coefficients = [{}]\n"
      "units = [{}]\n"
      "std = [{}]\n"
      "correlation = [\n{}\n]\n"
      "residual_std_V = {}  # standard deviation of one reading; {} degrees of freedom\n"
      "torque_from_Nm = {}  # range of the calibration; outside it, the curve continues along its "
      "tangents\n"
      "torque_to_Nm = {}\n"
      "signal_from_V = {}\n"
      "signal_to_V = {}\n"
      "readings = {}\n"
      "source = {}\n"
      "# zero_V = 0.0  # signal at zero torque on the day of the test, replaces the first "
      "coefficient\n",
      fmt::join(lists.coefficients, ", "), fmt::join(lists.units, ", "), fmt::join(lists.std, ", "),
      fmt::join(lists.correlation, "\n"), digits(record::with_digits(s.scatter, 6)),
      c.degrees_of_freedom, digits(s.lowest_torque), digits(s.highest_torque),
      digits(s.lowest_signal), digits(s.highest_signal), c.readings,
      text::in_quotes(text::printable(source)));
}

std::string sensor_calibration_json(const rig::SensorCalibration& c, const std::string& source) {
  const rig::TorqueSensor& s = c.sensor;
  text::json coefficients = text::json::array(), correlations = text::json::array();
  for (int k = 0; k <= c.degree(); ++k) {
    coefficients.push_back(
        {{"value", s.coefficients[k]}, {"std", c.std(k)}, {"unit", coefficient_unit(k)}});
    text::json row = text::json::array();
    for (int j = 0; j <= k; ++j) row.push_back(correlation(s.covariance, k, j));
    correlations.push_back(row);
  }
  const auto percent = [&](double signal) { return 100.0 * signal / c.signal_range; };
  const rig::LackOfFit& lack = c.lack_of_fit;
  const rig::Hysteresis& h = c.hysteresis;
  text::json document = {
      {"source", source},
      {"degree", c.degree()},
      {"coefficients", coefficients},
      {"correlation", correlations},
      {"residual_std_V", s.scatter},
      {"readings", c.readings},
      {"torques", c.torques},
      {"degrees_of_freedom", c.degrees_of_freedom},
      {"torque_from_Nm", s.lowest_torque},
      {"torque_to_Nm", s.highest_torque},
      {"signal_from_V", s.lowest_signal},
      {"signal_to_V", s.highest_signal},
      {"gain_std_percent", percent(c.range_std)},
      {"linearity",
       {{"off_line_V", c.off_line},
        {"off_line_percent", percent(c.off_line)},
        {"off_curve_V", c.off_curve},
        {"higher_terms_p_value", c.higher_terms_p_value}}},
      {"lack_of_fit",
       {{"statistic", lack.statistic},
        {"p_value", lack.p_value},
        {"degrees", lack.degrees},
        {"error_degrees", lack.error_degrees},
        {"repeatability_V", lack.repeatability}}},
      {"hysteresis",
       {{"torques", h.torques},
        {"mean_V", h.mean},
        {"largest_V", h.largest},
        {"largest_percent", percent(h.largest)},
        {"largest_at_Nm", h.largest_at},
        {"p_value", h.p_value}}},
      {"even_scatter",
       {{"p_value", c.even_scatter_p_value}, {"low_V", c.scatter_low}, {"high_V", c.scatter_high}}},
      {"notes", nullptr}};
  text::put_notes(document, "notes", c.notes);
  text::put_notes(document, "warnings", c.warnings);
  return text::text(document);
}

}  // namespace raceway::files
