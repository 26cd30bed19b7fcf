#include "shaft/torque_rows.h"

#include <algorithm>

namespace raceway::shaft {

TorqueRows::TorqueRows(const Model& model, const record::Record& record)
    : steps_(model),
      rows_(model, record),
      friction_(model),
      made_(rows_.size()),
      torques_(rows_.size()) {
  for (std::size_t b = 0; b < friction_.bearings(); ++b)
    bearings_.emplace_back(rows_.size(), friction_.nothing(b));
}

/// Puts the bearings of a row into its present balance.
void TorqueRows::place(std::size_t i) {
  const BalancedRows::Row& row = rows_[i];
  if (made_[i].solved == row.solved && made_[i].conditions == row.bearings) return;
  made_[i] = {row.solved, row.bearings};
  const SetState sets{.mounted = rows_.sets(i).arrangement(),
                      .equilibrium = row.equilibrium,
                      .bearings = row.bearings,
                      .temperatures = row.temperatures,
                      .speed = row.row.point.speed,
                      .temperature = row.row.point.temperature,
                      .record = row.row.record};
  for (std::size_t b = 0; b < bearings_.size(); ++b)
    bearings_[b][i] = friction_.row(b, sets, friction_.steps());
}

void TorqueRows::predict(const Model& model, std::span<double> readings, model::Stage from) {
  friction_.take(model);
  rows_.mount(model, steps_);
  for (std::size_t i = 0; i < rows_.size(); ++i) {
    if (rows_.find(model, steps_, i)) {
      place(i);
    } else if (made_[i].solved != 0) {
      made_[i] = {};
      for (std::size_t b = 0; b < bearings_.size(); ++b) bearings_[b][i] = friction_.nothing(b);
    }
  }
  std::fill(readings.begin(), readings.end(), 0.0);
  for (std::size_t b = 0; b < bearings_.size(); ++b) {
    // Each as the torque of a rig with as many bearings.
    predict_all(friction_.model(b), friction_.steps(), bearings_[b], torques_, from);
    for (std::size_t i = 0; i < rows_.size(); ++i)
      readings[i] += torques_[i] / static_cast<double>(bearings_.size());
  }
  for (std::size_t i = 0; i < rows_.size(); ++i) {
    const effects::ReadingInputs inputs{
        .value = readings[i], .point = rows_[i].row.point, .record = rows_[i].row.record};
    for (const std::size_t k : steps_.reading)
      readings[i] += model.effects[k].description->reading(inputs, model.effects[k].values);
  }
}

std::vector<double> predict_torque(const Model& model, const record::Record& record) {
  std::vector<double> readings(record.rows());
  TorqueRows(model, record).predict(model, readings);
  return readings;
}

}  // namespace raceway::shaft
