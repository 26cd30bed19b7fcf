#include "files/friction_table.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "files/column_map.h"
#include "files/detail/table_grid.h"
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
        fmt::format(
            "{}:{}: column {} is missing; a friction table needs speed_rpm and friction_torque_Nmm "
            "and can have axial_load_N, radial_load_N and temperature_C; the header has {}",
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

/// Another grid of the same axes, with the values of these rows.
friction::StribeckTable on_grid(const friction::TableAxes& axes, const std::vector<double>& values,
                                const std::vector<std::size_t>& point_of_row) {
  friction::StribeckTable table;
  table.axes = axes;
  table.friction_moment.resize(values.size());
  for (std::size_t row = 0; row < values.size(); ++row)
    table.friction_moment[point_of_row[row]] = values[row];
  return table;
}

/// Half width of the band of a torque, as `raceway table --band` writes it.
constexpr Channel torque_band{.name = "friction_torque_band_Nmm",
                              .variable = "friction_torque_band",
                              .words = "band of the friction torque",
                              .unit = "N mm",
                              .factor = N_mm,
                              .lower = 0,
                              .upper = 1e9};
/// Part of a torque that a law for the bearing as a whole has by its load.
constexpr Channel load_part{.name = "load_Nmm",
                            .variable = "load",
                            .words = "load moment",
                            .unit = "N mm",
                            .factor = N_mm,
                            .lower = -1e9,
                            .upper = 1e9};
constexpr double band_of_deviation = 1.96;  // 95 % of a normal distribution

}  // namespace

friction::TorqueTable parse_friction_table(std::string text, const std::string& source) {
  const text::CsvTable csv = text::parse_csv(std::move(text), source);
  refuse_slab(csv);
  text::BadCells bad(csv.source, csv.rows());
  const auto optional = [&](const Channel& channel) { return values_of(csv, channel, false, bad); };
  TableInputs inputs{values_of(csv, record::speed, true, bad), optional(record::axial_load),
                     optional(record::radial_load), optional(record::temperature)};
  const std::vector<double> torque = values_of(csv, record::friction_torque, true, bad);
  const std::vector<double> load = optional(load_part);
  std::vector<double> band = optional(torque_band), deviation = optional(record::torque_deviation);
  bad.throw_if_any();
  if (!band.empty() && !deviation.empty())
    throw text::InputError(
        fmt::format("{}:{}: {} and {} both give the uncertainty of the torque; remove one", source,
                    csv.header_line, torque_band.name, record::torque_deviation.name),
        {source, csv.header_line, std::string(torque_band.name)});
  for (const double std : deviation) band.push_back(band_of_deviation * std);
  friction::TorqueTable table{.file = source,
                              .has_axial_load = !inputs[1].empty(),
                              .has_radial_load = !inputs[2].empty(),
                              .has_temperature = !inputs[3].empty(),
                              .of_shaft = csv.column("front_force_N").has_value()};
  for (std::vector<double>& column : inputs)
    if (column.empty()) column.assign(csv.rows(), 0.0);
  const std::vector<std::size_t> point_of_row = points_of_rows(csv, inputs, table.grid);
  table.grid = on_grid(table.grid.axes, torque, point_of_row);
  if (!load.empty()) table.load = on_grid(table.grid.axes, load, point_of_row);
  if (!band.empty()) table.band = on_grid(table.grid.axes, band, point_of_row);
  return table;
}

correction::FrictionTable of_correction(friction::TorqueTable table) {
  friction::TableAxes& axes = table.grid.axes;
  return {.file = std::move(table.file),
          .speed = std::move(axes.speed),
          .axial_load = std::move(axes.axial_load),
          .radial_load = std::move(axes.radial_load),
          .temperature = std::move(axes.temperature),
          .torque = std::move(table.grid.friction_moment)};
}

correction::Characteristic::Table parse_characteristic(std::string text, const std::string& source,
                                                       const std::string& value,
                                                       const CurveInput& input) {
  const text::CsvTable csv = text::parse_csv(std::move(text), source);
  correction::Characteristic::Table table;
  const auto column = [&](const std::string& variable, const std::string& name) {
    for (std::size_t c = 0; c < csv.header.size(); ++c)
      if (csv.header[c].starts_with(variable + "_")) return c;
    throw text::InputError(fmt::format("{}:{}: column {} is missing; the header has {}", csv.source,
                                       csv.header_line, name, text::listed(csv.header)),
                           {csv.source, csv.header_line, name});
  };
  const std::size_t driving = column(input.variable, input.column), of = column(value, value + "_");
  const std::string& header = csv.header[driving];
  const double input_unit = header == input.column ? 1.0 : text::column_unit(header) / input.unit,
               unit = text::column_unit(csv.header[of]);
  for (std::size_t row = 0; row < csv.rows(); ++row) {
    table.input.push_back(csv.number(row, driving) * input_unit);
    table.value.push_back(csv.number(row, of) * unit);
  }
  return table;
}

}  // namespace raceway::files
