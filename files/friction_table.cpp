#include "files/friction_table.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <utility>

#include "files/column_map.h"
#include "record/channel.h"
#include "text/bad_cells.h"
#include "text/csv.h"
#include "text/error.h"
#include "text/names.h"

namespace raceway::files {
namespace {

using record::Channel;

/// The column of a channel, also in another unit; null without.
struct Found {
  std::size_t column;
  const text::Unit* unit;
};
std::optional<Found> find(const text::CsvTable& table, const Channel& channel) {
  const std::array one{&channel};
  for (std::size_t c = 0; c < table.header.size(); ++c)
    if (const auto named = named_channel(table.header[c], one)) return Found{c, named->unit};
  return std::nullopt;
}

std::vector<double> values_of(const text::CsvTable& table, const Channel& channel, bool required,
                              text::BadCells& bad) {
  const auto found = find(table, channel);
  if (!found) {
    if (!required) return {};
    throw text::InputError(
        fmt::format("{}:{}: column {} is missing; a friction table has speed_rpm, "
                    "axial_load_N, temperature_C and friction_torque_Nmm; the header has {}",
                    table.source, table.header_line, channel.name, text::listed(table.header)),
        {table.source, table.header_line, std::string(channel.name)});
  }
  std::vector<double> list;
  for (std::size_t row = 0; row < table.rows(); ++row) {
    const text::ParsedNumber number =
        text::read_cell(table, row, found->column, text::range_of(channel), bad);
    list.push_back(found->unit ? found->unit->to_SI(number.value) : channel.to_SI(number.value));
  }
  return list;
}

std::vector<double> axis_of(const std::vector<double>& values) {
  const std::set<double> levels(values.begin(), values.end());
  return {levels.begin(), levels.end()};
}

std::size_t place_on(const std::vector<double>& axis, double value) {
  return static_cast<std::size_t>(std::lower_bound(axis.begin(), axis.end(), value) - axis.begin());
}

}  // namespace

correction::FrictionTable parse_friction_table(std::string text, const std::string& source) {
  const text::CsvTable csv = text::parse_csv(std::move(text), source);
  text::BadCells bad(csv.source, csv.rows());
  const std::vector<double> speed = values_of(csv, record::speed, true, bad);
  std::vector<double> load = values_of(csv, record::axial_load, false, bad);
  std::vector<double> temperature = values_of(csv, record::temperature, false, bad);
  const std::vector<double> torque = values_of(csv, record::friction_torque, true, bad);
  bad.throw_if_any();
  if (load.empty()) load.assign(speed.size(), 0.0);
  if (temperature.empty()) temperature.assign(speed.size(), 0.0);
  correction::FrictionTable table{.file = source,
                                  .speed = axis_of(speed),
                                  .axial_load = axis_of(load),
                                  .temperature = axis_of(temperature)};
  constexpr std::size_t most_points = 100'000'000;
  const std::size_t points =
      table.speed.size() * table.axial_load.size() * table.temperature.size();
  if (points > most_points || points > 1000 * speed.size() + 1000)
    throw text::InputError(
        fmt::format("{}: {} speeds, {} loads and {} temperatures are no grid of {} rows",
                    csv.source, table.speed.size(), table.axial_load.size(),
                    table.temperature.size(), csv.rows()),
        {csv.source});
  table.torque.assign(points, unset);
  for (std::size_t row = 0; row < speed.size(); ++row) {
    double& at =
        table.torque[(place_on(table.temperature, temperature[row]) * table.axial_load.size() +
                      place_on(table.axial_load, load[row])) *
                         table.speed.size() +
                     place_on(table.speed, speed[row])];
    if (!std::isnan(at))
      throw text::InputError(
          fmt::format("{}:{}: the point {} rpm, {} N, {} C stands twice; of a table with "
                      "radial loads keep one of them",
                      csv.source, csv.line(row), speed[row] / rpm, load[row],
                      celsius(temperature[row])),
          {csv.source, csv.line(row)});
    at = torque[row];
  }
  const auto hole = std::find_if(table.torque.begin(), table.torque.end(),
                                 [](double v) { return std::isnan(v); });
  if (hole != table.torque.end()) {
    const auto at = static_cast<std::size_t>(hole - table.torque.begin());
    const std::size_t s = at % table.speed.size(), rest = at / table.speed.size();
    throw text::InputError(
        fmt::format("{}: the grid has no point at {} rpm, {} N, {} C", csv.source,
                    table.speed[s] / rpm, table.axial_load[rest % table.axial_load.size()],
                    celsius(table.temperature[rest / table.axial_load.size()])),
        {csv.source});
  }
  return table;
}

correction::Characteristic::Table parse_characteristic(std::string text, const std::string& source,
                                                       const std::string& value) {
  const text::CsvTable csv = text::parse_csv(std::move(text), source);
  correction::Characteristic::Table table;
  const auto column = [&](std::string_view begin) {
    for (std::size_t c = 0; c < csv.header.size(); ++c)
      if (csv.header[c].starts_with(begin)) return c;
    throw text::InputError(fmt::format("{}:{}: column {} is missing; the header has {}", csv.source,
                                       csv.header_line, begin, text::listed(csv.header)),
                           {csv.source, csv.header_line, std::string(begin)});
  };
  const std::size_t power = column("power_"), of = column(value + "_");
  const double power_unit = text::column_unit(csv.header[power]),
               unit = text::column_unit(csv.header[of]);
  for (std::size_t row = 0; row < csv.rows(); ++row) {
    table.power.push_back(csv.number(row, power) * power_unit);
    table.value.push_back(csv.number(row, of) * unit);
  }
  return table;
}

}  // namespace raceway::files
