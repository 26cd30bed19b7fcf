#include "files/detail/data_columns.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "text/error.h"
#include "text/names.h"

namespace raceway::files {
namespace {

using record::Channel;
using record::Role;

/// Places of times between two speeds. The file has both speeds and the time, and neither a speed
/// at a time nor a torque.
void find_falls(const text::CsvTable& table, const Recognised& found, DataColumns& columns) {
  if (!found.find(speed_from) && !found.find(speed_to)) return;
  for (const Channel* c : {&speed_from, &speed_to, &fall_time, &fall_time_deviation}) {
    if (const ColumnSource* const source = found.find(*c)) {
      columns.falls.push_back(*source);
      columns.falls.back().channel = c;
    } else if (!(*c == fall_time_deviation)) {
      throw text::InputError(fmt::format("{}: column {} is missing: a file of fall times needs {}, "
                                         "{} and {}; the header has {}",
                                         table.header_place().text(), c->name, speed_from.name,
                                         speed_to.name, fall_time.name, text::listed(table.header)),
                             table.header_place(c->name));
    }
  }
  std::vector<const Channel*> readings{&torque_signal};
  for (const Channel& c : record::channels)
    if (c == record::speed || c.role == Role::measured || c.role == Role::deviation)
      readings.push_back(&c);
  for (const Channel* c : readings)
    if (const ColumnSource* const source = found.find(*c))
      throw text::InputError(
          fmt::format(
              "{}: columns {} and {} cannot be in the same file: a file has only one of these: "
              "times between two speeds, speeds over time, or readings at constant speeds",
              table.header_place().text(), source->name, speed_from.name),
          table.header_place(source->name));
}

/// The signal of a torque sensor. With its calibration it takes the place of the torque.
void find_signal(const text::CsvTable& table, const Recognised& found, const ReadOptions& options,
                 const model::Expected& expected, DataColumns& columns) {
  const ColumnSource* const signal = found.find(torque_signal);
  const ColumnSource* const deviation = found.find(torque_signal_deviation);
  if (!signal && deviation)
    throw text::InputError(
        fmt::format("{}: column {} needs a column {}, which is missing",
                    table.header_place().text(), deviation->name, torque_signal.name),
        table.header_place(deviation->name));
  if (!signal) return;
  if (!options.sensor) {
    const bool alone =
        std::none_of(columns.places.begin(), columns.places.end(),
                     [](const ColumnSource& p) { return p.channel->role == Role::measured; });
    if (alone && !expected.coast_down)
      throw text::InputError(
          fmt::format("{}: column {} needs the calibration of the sensor, but the model has no "
                      "[torque_sensor]; raceway calibrate-sensor CSV -o FILE writes this table",
                      table.header_place().text(), signal->name),
          table.header_place(signal->name));
    columns.notes.push_back(record::note::unused(
        fmt::format("column {} is not used: the model has no [torque_sensor]", signal->name),
        {.key = signal->name}));
    return;
  }
  columns.signal = *signal;
  if (deviation) columns.signal_deviation = *deviation;
  std::erase_if(columns.places, [&](const ColumnSource& p) {
    if (!(*p.channel == record::friction_torque) && !(*p.channel == record::torque_deviation))
      return false;
    columns.notes.push_back(record::note::unused(
        fmt::format("column {} is not used: [torque_sensor] converts {} to the torque", p.name,
                    signal->name),
        {.key = p.name}));
    return true;
  });
  columns.places.push_back(*signal);
  columns.places.back().channel = &record::friction_torque;
  // Both stand in the table of channels.
  std::sort(columns.places.begin(), columns.places.end(),
            [](const ColumnSource& a, const ColumnSource& b) { return a.channel < b.channel; });
}

/// Names that a column of a record may have been meant to have.
std::vector<std::string> meant_names(const DataColumns& columns) {
  std::vector<std::string> names;
  for (const Channel* c : file_channels())
    if (!(*c == record::run) && !(*c == reference_torque) && !(*c == calibration_signal) &&
        (!(*c == fall_time_deviation) || !columns.falls.empty()))
      names.emplace_back(c->name);
  return names;
}

/// Places of what is known; what is not is an error where it looks misspelt.
void find_places(const text::CsvTable& table, const ReadOptions& options,
                 const model::Expected& expected, DataColumns& columns) {
  const ColumnMap& map = options.columns;
  Recognised found = recognise(table, options);
  // Columns of the calibration of a sensor are none of a record.
  for (const Channel* c : {&reference_torque, &calibration_signal})
    if (const ColumnSource* const source = found.find(*c)) found.others.push_back(source->name);
  find_falls(table, found, columns);
  for (const ColumnSource& source : found.columns) {
    const bool of_fall = !columns.falls.empty() && *source.channel == record::time;
    if (!of_fall && record::find_channel(source.channel->name)) columns.places.push_back(source);
  }
  for (const Recognised::Constant& c : found.constants)
    if (!record::find_channel(c.channel->name))
      throw text::InputError(
          fmt::format("{}: {} = {:.6g}: the model does not use this column, so one number for all "
                      "rows is not possible; name a column of the file, or remove the line",
                      c.from, c.channel->name, c.channel->in_unit(c.value)),
          {.key = std::string(c.channel->name)});
  columns.constants = std::move(found.constants);
  columns.notes = std::move(found.notes);
  find_signal(table, found, options, expected, columns);
  const std::vector<std::string> known = meant_names(columns);
  for (const std::string& name : found.others) {
    // Whoever has named the columns knows what the others are.
    if (const auto near = map.rules.empty() ? text::nearest_name(name, known) : std::nullopt)
      throw text::InputError(fmt::format("{}: column {} is unknown; did you mean {}?",
                                         table.header_place().text(), name, *near),
                             table.header_place(name));
  }
  columns.others = std::move(found.others);
}

/// Of the measured columns keeps those that are predicted, or the first that the model may refuse.
void choose_measured(const model::ModelSubject& subject, const model::Expected& expected,
                     DataColumns& columns) {
  const auto take = [&](const Channel& channel) {
    if (columns.find(channel) && !columns.keeps(channel)) columns.measured.push_back(&channel);
  };
  for (const fit::Measured& m : subject.measured()) take(*m.channel);
  for (const Channel* channel : expected.measured)
    if (columns.measured.empty()) take(*channel);
  if (columns.measured.empty()) return;
  for (const DataColumns::Place& p : columns.places)
    if (p.channel->role == Role::measured && !columns.keeps(*p.channel))
      columns.unused.push_back(p.channel);
}

void require_measured(const text::CsvTable& table, const model::Expected& expected,
                      const DataColumns& columns) {
  if (!columns.measured.empty()) return;
  std::vector<std::string> names;
  for (const Channel& channel : record::channels)
    if (std::any_of(expected.measured.begin(), expected.measured.end(),
                    [&](const Channel* c) { return *c == channel; }))
      names.emplace_back(channel.name);
  const std::string wanted = fmt::format("{}: a measured column is missing: {}",
                                         table.header_place().text(), text::listed(names, "or"));
  if (!columns.find(record::time) && columns.falls.empty())
    throw text::InputError(
        fmt::format("{}, or {} for a coast-down; the header has {}\n{}", wanted, record::time.name,
                    text::listed(table.header), if_named_otherwise(table)),
        table.header_place());
  if (!expected.coast_down)
    throw text::InputError(
        fmt::format("{}; to use the file as a coast-down ({}), the model needs inertia_kgm2 under "
                    "[rig], a number or \"unknown\"",
                    wanted,
                    columns.falls.empty()
                        ? fmt::format("only {} and {}", record::time.name, record::speed.name)
                        : "times between two speeds"),
        table.header_place());
}

void require_what_deviates(const text::CsvTable& table, const DataColumns& columns) {
  for (const DataColumns::Place& p : columns.places) {
    const Channel& c = *p.channel;
    if (c.role == Role::deviation && !columns.find(*record::find_channel(c.of)))
      throw text::InputError(fmt::format("{}: column {} needs a column {}, which is missing",
                                         table.header_place().text(), c.name, c.of),
                             table.header_place(c.name));
  }
}

/// A number that has no default must stand in a column, unless a model may give it.
void require_inputs(const text::CsvTable& table, const model::Expected& expected,
                    const DataColumns& columns, bool may_stand_in_model) {
  for (const model::Expected::Default& d : expected.defaults) {
    const Channel& c = *d.channel;
    if (c == record::speed && !columns.falls.empty()) continue;
    if (!std::isnan(d.value) || columns.find(c) || columns.constant(c) ||
        d.from.empty() == may_stand_in_model)
      continue;
    if (!may_stand_in_model)
      throw text::InputError(fmt::format("{}: column {} is missing; the header has {}\n{}",
                                         table.header_place().text(), c.name,
                                         text::listed(table.header), if_named_otherwise(table)),
                             table.header_place(c.name));
    const std::string none =
        c.kind.empty() ? "" : fmt::format("; if the {} is zero or unknown, give 0", c.kind);
    throw text::InputError(
        fmt::format("{0}: the {1} is missing: give a column {2}, or {2} in the model under {3}{4}",
                    table.header_place().text(), c.words, c.name, d.from, none),
        table.header_place(c.name));
  }
}

}  // namespace

const DataColumns::Place* DataColumns::find(const Channel& channel) const {
  for (const Place& p : places)
    if (*p.channel == channel) return &p;
  return nullptr;
}

const Recognised::Constant* DataColumns::constant(const Channel& channel) const {
  for (const Recognised::Constant& c : constants)
    if (*c.channel == channel) return &c;
  return nullptr;
}

bool DataColumns::keeps(const Channel& channel) const {
  const std::string_view name = channel.role == Role::deviation ? channel.of : channel.name;
  if (channel.role != Role::measured && channel.role != Role::deviation) return true;
  return std::any_of(measured.begin(), measured.end(),
                     [&](const Channel* m) { return m->name == name; });
}

DataColumns find_columns(const text::CsvTable& table, const model::ModelSubject& subject,
                         const model::Expected& expected, const ReadOptions& options) {
  DataColumns columns;
  find_places(table, options, expected, columns);
  choose_measured(subject, expected, columns);
  require_inputs(table, expected, columns, false);
  require_measured(table, expected, columns);
  require_what_deviates(table, columns);
  require_inputs(table, expected, columns, true);
  return columns;
}

}  // namespace raceway::files
