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

/// Columns of a table, and the line of each row.
struct Points {
  std::vector<double> speed, load, radial, temperature, torque;
  std::vector<int> line;

  /// Those at one radial load.
  [[nodiscard]] Points at_radial(double of) const {
    Points some;
    for (std::size_t row = 0; row < speed.size(); ++row) {
      if (radial[row] != of) continue;
      some.speed.push_back(speed[row]);
      some.load.push_back(load[row]);
      some.temperature.push_back(temperature[row]);
      some.torque.push_back(torque[row]);
      some.line.push_back(line[row]);
    }
    return some;
  }
};

correction::FrictionTable grid_of(const Points& points_of, const text::CsvTable& csv) {
  const auto& [speed, load, radial, temperature, torque, line] = points_of;
  correction::FrictionTable table{.file = csv.source,
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
          fmt::format("{}:{}: the point {} rpm, {} N, {} C stands twice", csv.source, line[row],
                      speed[row] / rpm, load[row], celsius(temperature[row])),
          {csv.source, line[row]});
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

/// Between the grids of two radial loads; the edge holds beyond them.
correction::FrictionTable at_radial_load(const Points& points, double radial,
                                         const text::CsvTable& csv) {
  const std::vector<double> loads = axis_of(points.radial);
  if (loads.size() == 1 && !(radial != loads.front() && !std::isnan(radial)))
    return grid_of(points, csv);
  if (!(radial >= loads.front() && radial <= loads.back())) {
    std::vector<std::string> known;
    for (const double load : loads) known.push_back(fmt::format("{:g}", load));
    throw text::InputError(
        fmt::format("{}: has the radial load{} {} N: radial_load_N {}", csv.source,
                    known.size() == 1 ? "" : "s", text::listed(known),
                    std::isnan(radial) ? "says at which it is read"
                                       : fmt::format("= {:g} N lies beyond", radial)),
        {csv.source});
  }
  const std::size_t above = std::max<std::size_t>(1, place_on(loads, radial));
  const double share = (radial - loads[above - 1]) / (loads[above] - loads[above - 1]);
  correction::FrictionTable table = grid_of(points.at_radial(loads[above - 1]), csv);
  const correction::FrictionTable next = grid_of(points.at_radial(loads[above]), csv);
  if (table.speed != next.speed || table.axial_load != next.axial_load ||
      table.temperature != next.temperature)
    throw text::InputError(fmt::format("{}: the grids at {:g} and {:g} N of radial load differ",
                                       csv.source, loads[above - 1], loads[above]),
                           {csv.source});
  for (std::size_t k = 0; k < table.torque.size(); ++k)
    table.torque[k] += share * (next.torque[k] - table.torque[k]);
  return table;
}

}  // namespace

correction::FrictionTable parse_friction_table(std::string text, const std::string& source,
                                               double radial_load) {
  const text::CsvTable csv = text::parse_csv(std::move(text), source);
  text::BadCells bad(csv.source, csv.rows());
  Points points{.speed = values_of(csv, record::speed, true, bad),
                .load = values_of(csv, record::axial_load, false, bad),
                .radial = values_of(csv, record::radial_load, false, bad),
                .temperature = values_of(csv, record::temperature, false, bad),
                .torque = values_of(csv, record::friction_torque, true, bad),
                .line = {}};
  bad.throw_if_any();
  const std::size_t rows = points.speed.size();
  for (std::vector<double>* column : {&points.load, &points.radial, &points.temperature})
    if (column->empty()) column->assign(rows, 0.0);
  for (std::size_t row = 0; row < rows; ++row) points.line.push_back(csv.line(row));
  if (rows == 0) return grid_of(points, csv);
  return at_radial_load(points, radial_load, csv);
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
