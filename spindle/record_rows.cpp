#include "spindle/record_rows.h"

#include <fmt/format.h>

#include <cmath>
#include <stdexcept>

#include "record/series_channel.h"
#include "record/spindle_channel.h"

namespace raceway::spindle {
namespace {

/// By row; nothing where there is no such column. Every row has a number.
std::span<const double> input_of(const record::Record& record, const record::Channel& channel) {
  const std::span<const double> values = record.values(channel);
  for (std::size_t row = 0; row < values.size(); ++row)
    if (std::isnan(values[row]))
      throw std::invalid_argument(
          fmt::format("{}: {} has no value: an input column needs a value in every row",
                      record.place(row), channel.name));
  return values;
}

std::span<const double> required_input(const record::Record& record,
                                       const record::Channel& channel) {
  if (!record.has(channel))
    throw std::invalid_argument(
        fmt::format("{}: column {} is missing", record.source, channel.name));
  return input_of(record, channel);
}

}  // namespace

std::vector<ProfileRow> profile_of(const record::Record& record) {
  const auto series = [&](std::string_view name) {
    return input_of(record, *record::spindle_channel(name));
  };
  const auto time = required_input(record, record::time);
  const auto speed = required_input(record, record::speed);
  const auto ambient = series("ambient_temperature_C"), machine = series("machine_temperature_C"),
             inlet = series("coolant_inlet_temperature_C"), coolant = series("coolant_on"),
             motor = series("motor_heat_W"), power = series("motor_power_W"),
             axial = series("axial_load_N"), radial = series("radial_load_N"),
             moment = series("moment_Nm"), belt = series("belt_force_N");
  const auto at = [](std::span<const double> values, std::size_t row, double otherwise) {
    return values.empty() ? otherwise : values[row];
  };
  constexpr double longest = 3.2e8;  // [s], 10 years, of minutes of computing
  std::vector<ProfileRow> rows;
  rows.reserve(record.rows());
  for (std::size_t row = 0; row < record.rows(); ++row) {
    if (row > 0 && !(time[row] > time[row - 1]))
      throw std::invalid_argument(fmt::format(
          "{}: time_s = {:.10g} s: time must increase, but the row before has {:.10g} s",
          record.place(row), time[row], time[row - 1]));
    if (time[row] - time[0] > longest)
      throw std::invalid_argument(fmt::format(
          "{}: time_s = {:.10g} s: a record can last at most {:g} s (10 years) from its first row",
          record.place(row), time[row], longest));
    // Temperatures are read in their own row.
    const bool from_row = record.settings_hold != record::SettingsHold::until_row;
    const std::size_t set = from_row && row > 0 ? row - 1 : row;
    rows.push_back({.time = time[row],
                    .inputs = {.speed = std::abs(speed[set]),  // heat does not know the direction
                               .ambient_temperature = at(ambient, row, unset),
                               .machine_temperature = at(machine, row, unset),
                               .coolant_inlet = at(inlet, row, unset),
                               .motor_heat = at(motor, set, unset),
                               .motor_power = at(power, set, unset),
                               .axial_load = at(axial, set, 0.0),
                               .radial_load = at(radial, set, 0.0),
                               .moment = at(moment, set, 0.0),
                               .belt_force = at(belt, set, unset),
                               .coolant_on = at(coolant, set, 1.0) >= 0.5}});
  }
  return rows;
}

std::vector<const record::Channel*> measured_channels(const model::Spindle& spindle) {
  std::vector<const record::Channel*> list;
  for (const model::ThermometerPlace& sensor : spindle.sensors)
    list.push_back(&record::sensor_channel(sensor.name));
  if (!spindle.network) list.push_back(&record::axial_displacement);
  return list;
}

std::vector<double> readings_of(const Moment& moment, const model::Spindle& spindle) {
  std::vector<double> readings = moment.sensors;
  if (!spindle.network) readings.push_back(moment.displacement);
  return readings;
}

}  // namespace raceway::spindle
