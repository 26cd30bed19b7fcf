#pragma once

#include <span>
#include <vector>

#include "shaft/balanced_rows.h"
#include "shaft/set_friction.h"

namespace raceway::shaft {

/// Predicts the friction torque of the sets on a shaft at the rows of a record. In a fit, call
/// predict() repeatedly with different parameter values of one model.
class TorqueRows {
 public:
  /// The record must live longer than this object. Throws std::invalid_argument in the same cases
  /// as BalancedRows.
  TorqueRows(const Model& model, const record::Record& record);

  [[nodiscard]] std::size_t size() const { return rows_.size(); }
  /// Returns the calculation steps of the model, including effects on the torque reading.
  [[nodiscard]] const Steps& steps() const { return steps_; }
  /// Writes the torque at every row to `readings` [N m]: the values that predict_torque() returns
  /// for `model`. `model` must have the same effects and temperatures as the model that was passed
  /// to the constructor. `from` is the first calculation stage whose parameters have changed since
  /// the previous call.
  void predict(const Model& model, std::span<double> readings,
               model::Stage from = model::Stage::entry);

 private:
  struct Made {
    int solved = 0;
    std::vector<effects::Condition> conditions{};
  };
  void place(std::size_t row);

  Steps steps_;
  BalancedRows rows_;
  SetFriction friction_;
  std::vector<std::vector<model::RowPredictor>> bearings_;  // front set first, each at all rows
  std::vector<Made> made_;                                  // by row
  std::vector<double> torques_;
};

/// Returns the friction torque of the sets on a shaft at the rows of a record [N m]: the sum over
/// all bearings, plus the torque that effects of the model add to the sensor reading. The value of
/// a row is NaN if the sets have no equilibrium or an effect gives no finite value. See
/// BalancedRows for the load, preload and temperatures of a row. Throws std::invalid_argument in
/// the same cases as BalancedRows.
[[nodiscard]] std::vector<double> predict_torque(const Model& model, const record::Record& record);

}  // namespace raceway::shaft
