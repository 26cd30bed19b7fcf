#include "files/spindle_record.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "files/series_file.h"
#include "record/series_channel.h"
#include "record/spindle_channel.h"
#include "spindle/record_rows.h"
#include "text/error.h"

namespace raceway::files {
namespace {

/// True where a speed, a load, a heat or the coolant changes.
bool settings_change(const record::Record& record) {
  return std::any_of(record.columns.begin(), record.columns.end(), [&](const record::Column& c) {
    return c.channel->is_input() && record::course_of(*c.channel) == record::Course::held &&
           record.varies(*c.channel);
  });
}

/// Loads that the spindle has nothing to carry with.
void refuse_loads(const record::Record& record, const model::Spindle& spindle) {
  const auto refuse = [&](const record::Channel& load, const char* why) {
    if (!record.has(load)) return;
    const auto values = record.values(load);
    if (std::all_of(values.begin(), values.end(), [](double v) { return v == 0.0; })) return;
    throw text::InputError(fmt::format("{}: {}: {}", record.source, load.name, why),
                           {.file = record.source, .key = std::string(load.name)});
  };
  if (!spindle.belt)
    refuse(record::belt_force,
           "the model has no belt: give [drive] position_mm and belt_force_N (0 is allowed)");
  if (spindle.network)
    for (const record::Channel* load :
         {&record::axial_load, &record::radial_load, &record::nose_moment})
      refuse(*load, "a model with [network] has no shaft, so it cannot carry a load");
}

/// Refuses a record without a column that a formula of heat goes by. Loads are 0 without one.
void require_power(const record::Record& record, const model::Spindle& spindle) {
  if (record.has(record::motor_power)) return;
  const auto look = [&](const model::HeatSource& source, std::string_view table) {
    if (!source.formula) return;
    for (const std::size_t k : source.formula->used())
      if (model::heat_variables[k] == record::motor_power.name &&
          !(table == "motor" && record.has(record::motor_heat)))
        throw text::InputError(
            fmt::format("{}: column {} is missing; the heat formula of {} needs it: \"{}\"",
                        record.source, record::motor_power.name, source.name,
                        source.formula->text()),
            {.file = record.source, .key = std::string(record::motor_power.name)});
  };
  if (spindle.motor) look(*spindle.motor, "motor");
  if (spindle.drive) look(*spindle.drive, "drive");
  for (const model::HeatSource& source : spindle.heat) look(source, "heat");
}

}  // namespace

ReadOptions of_spindle(ReadOptions options) {
  options.of_spindle = true;
  return over_time(std::move(options));
}

record::Record read_spindle_record(const Source& source, const model::Spindle& spindle,
                                   const ReadOptions& options) {
  record::Record record = read_series(source, spindle::measured_channels(spindle), {&record::speed},
                                      of_spindle(options));
  if (!options.columns.settings_hold && settings_change(record))
    record.notes.push_back(record::note::assumed(
        "the program assumes that the settings of a row apply from the previous row to this row; "
        "set settings_hold = \"until row\" in [columns] to confirm this, or \"from row\" if the "
        "settings of a row apply until the next row",
        {.key = "settings_hold"}));
  refuse_loads(record, spindle);
  require_power(record, spindle);
  return record;
}

}  // namespace raceway::files
