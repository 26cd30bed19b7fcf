#pragma once

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "bearing/operating_point.h"
#include "fit/noise.h"
#include "fit/subject.h"
#include "model/model.h"
#include "record/record.h"

/// Records by row, as tests like to write them.
namespace raceway::fit {

using namespace model;  // tests are written in the namespace of the loop

enum class Quantity { friction_torque, axial_displacement };

/// One measured row.
struct Row {
  bearing::OperatingPoint point;
  double inner_ring_temperature = unset;  ///< [K]
  double outer_ring_temperature = unset;  ///< [K]
  double preload = unset;                 ///< [N]
  double time = unset;                    ///< [s]
  double measured = unset;                ///< [N m] or [m]
  double std = unset;                     ///< of `measured`
  int run = -1;                           ///< index into DataSet::runs
  int line = 0;
};

struct DataSet {
  std::string source;
  Quantity quantity = Quantity::friction_torque;
  NoiseSource noise = NoiseSource::none;
  std::vector<Row> rows;
  std::vector<std::string> runs;
  std::vector<record::Note> notes;

  [[nodiscard]] const record::Channel& measured() const {
    return quantity == Quantity::friction_torque ? record::friction_torque
                                                 : record::axial_displacement;
  }
  [[nodiscard]] const record::Channel& deviation() const {
    return quantity == Quantity::friction_torque ? record::torque_deviation
                                                 : record::displacement_deviation;
  }

  /// Point and reading always have a column, all else where any row has a number.
  operator record::Record() const {  // NOLINT: what is asked for is a record
    record::Record record{
        .source = source, .columns = {}, .runs = runs, .lines = {}, .notes = notes};
    const auto add = [&](const record::Channel& channel, bool always, const auto& value) {
      std::vector<double> values;
      for (const Row& row : rows) values.push_back(value(row));
      const auto has = [](double v) { return std::isfinite(v); };
      if (always || std::any_of(values.begin(), values.end(), has))
        record.set(channel, std::move(values)).known =
            channel.role == record::Role::deviation && noise == NoiseSource::regression;
    };
    add(record::speed, true, [](const Row& r) { return r.point.speed; });
    add(record::axial_load, true, [](const Row& r) { return r.point.axial_load; });
    add(record::radial_load, true,
        [](const Row& r) { return std::hypot(r.point.radial_load, r.point.radial_load_z); });
    add(record::temperature, true, [](const Row& r) { return r.point.temperature; });
    add(record::preload, false, [](const Row& r) { return r.preload; });
    add(record::inner_ring_temperature, false,
        [](const Row& r) { return r.inner_ring_temperature; });
    add(record::outer_ring_temperature, false,
        [](const Row& r) { return r.outer_ring_temperature; });
    add(record::time, false, [](const Row& r) { return r.time; });
    add(record::run, false, [](const Row& r) { return r.run < 0 ? unset : 1.0 * r.run; });
    add(measured(), true, [](const Row& r) { return r.measured; });
    add(deviation(), false, [](const Row& r) { return r.std; });
    if (std::any_of(rows.begin(), rows.end(), [](const Row& r) { return r.line > 0; }))
      for (const Row& row : rows) record.lines.push_back(row.line);
    return record;
  }
};

/// What was recorded with a row, for a prediction of this row alone, the clock at its start when
/// the day began and the speed reached from below.
inline effects::Record record_of(const Row& row) {
  return {.time = row.time,
          .inner_ring_temperature = row.inner_ring_temperature,
          .outer_ring_temperature = row.outer_ring_temperature,
          .run = row.run,
          .since_start = row.time,
          .direction = std::isnan(row.time) ? unset : 1.0};
}

/// The rows of a record of one measured channel.
inline DataSet data_of(const record::Record& record) {
  DataSet data{.source = record.source, .rows = {}, .runs = record.runs, .notes = record.notes};
  if (!record.has(record::friction_torque)) data.quantity = Quantity::axial_displacement;
  const record::Column* const deviation = record.deviation_of(data.measured());
  if (deviation) data.noise = deviation->known ? NoiseSource::regression : NoiseSource::declared;
  for (std::size_t i = 0; i < record.rows(); ++i) {
    const auto value = [&](const record::Channel& channel) { return record.value(channel, i); };
    data.rows.push_back({.point = {.speed = value(record::speed),
                                   .axial_load = value(record::axial_load),
                                   .radial_load = value(record::radial_load),
                                   .temperature = value(record::temperature)},
                         .inner_ring_temperature = value(record::inner_ring_temperature),
                         .outer_ring_temperature = value(record::outer_ring_temperature),
                         .preload = value(record::preload),
                         .time = value(record::time),
                         .measured = value(data.measured()),
                         .std = deviation ? deviation->values[i] : unset,
                         .run = record.run_of(i),
                         .line = record.lines.empty() ? 0 : record.lines[i]});
  }
  return data;
}

}  // namespace raceway::fit
