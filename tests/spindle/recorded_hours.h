#pragma once

#include <vector>

#include "record/spindle_channel.h"
#include "spindle/spindle.h"

namespace raceway::spindle {

/// Four hours at speeds that change, a row every two minutes, as the spindle would read them.
inline record::Record recorded(const model::Model& model) {
  constexpr double room = kelvin(20);
  std::vector<ProfileRow> rows;
  for (int k = 1; k <= 120; ++k)
    rows.push_back({.time = 120.0 * k,
                    .inputs = {.speed = (k < 40   ? 8000.0
                                         : k < 70 ? 3000.0
                                                  : 6000.0) *
                                        rpm,
                               .ambient_temperature = room}});
  const Run run = Simulator(model).simulate(rows);
  std::vector<double> time, speeds, ambient, moved;
  std::vector<std::vector<double>> read(model.spindle->sensors.size());
  for (std::size_t k = 0; k < rows.size(); ++k) {
    time.push_back(rows[k].time);
    speeds.push_back(rows[k].inputs.speed);
    ambient.push_back(room);
    moved.push_back(run.moments[k].displacement);
    for (std::size_t s = 0; s < read.size(); ++s) read[s].push_back(run.moments[k].sensors[s]);
  }
  record::Record record;
  record.settings_hold = record::SettingsHold::until_row;
  record.set(record::time, time);
  record.set(record::speed, speeds);
  record.set(*record::spindle_channel("ambient_temperature_C"), ambient);
  record.set(record::axial_displacement, moved);
  for (std::size_t s = 0; s < read.size(); ++s)
    record.set(record::sensor_channel(model.spindle->sensors[s].name), read[s]);
  return record;
}

}  // namespace raceway::spindle
