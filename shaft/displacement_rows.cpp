#include "shaft/displacement_rows.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace raceway::shaft {

DisplacementRows::DisplacementRows(const Model& model, const record::Record& record)
    : steps_(model, false, record::axial_displacement),
      rows_(model, record),
      standstills_(rows_.size()) {}

double DisplacementRows::standstill(const Model& model, std::size_t i) {
  const ShaftBalance& sets = rows_.sets(i);
  if (standstills_[i].version != sets.version())
    standstills_[i] = {sets.standstill(rows_[i].row.point.axial_load, model.solver),
                       sets.version()};
  return standstills_[i].position;
}

void DisplacementRows::predict(const Model& model, std::span<double> readings) {
  rows_.mount(model, steps_);
  for (std::size_t i = 0; i < rows_.size(); ++i) {
    readings[i] = unset;
    if (!rows_.find(model, steps_, i)) continue;
    const double u = rows_[i].equilibrium.position - standstill(model, i);
    readings[i] = u;
    const effects::ReadingInputs inputs{
        .value = u, .point = rows_[i].row.point, .record = rows_[i].row.record};
    for (const std::size_t k : steps_.reading)
      readings[i] += model.effects[k].description->reading(inputs, model.effects[k].values);
  }
}

std::vector<double> predict_displacement(const Model& model, const record::Record& record) {
  std::vector<double> readings(record.rows());
  DisplacementRows(model, record).predict(model, readings);
  return readings;
}

std::string note_on_standstill(const record::Record& record) {
  const std::span<const double> speed = record.values(record::speed),
                                load = record.values(record::axial_load),
                                read = record.values(record::axial_displacement);
  if (load.empty() || read.empty()) return {};
  std::size_t rows = 0;
  double least = std::numeric_limits<double>::infinity(), most = -least;
  for (std::size_t i = 0; i < speed.size(); ++i) {
    if (speed[i] != 0.0 || !std::isfinite(read[i])) continue;
    ++rows;
    least = std::min(least, load[i]);
    most = std::max(most, load[i]);
  }
  if (rows == 0 || !(most - least > 1e-3 * std::max(std::abs(most), std::abs(least)))) return {};
  return fmt::format(
      "{} row{} at standstill with axial loads from {:.6g} to {:.6g} N: axial_displacement_um is "
      "measured from standstill under the same load, so the model gives 0 um for such rows. For a "
      "load-deflection curve, use axial_position_um of raceway table --speed 0 --axial-load "
      "FROM:TO:STEP",
      rows, rows == 1 ? "" : "s", least, most);
}

}  // namespace raceway::shaft
