#pragma once

#include <span>
#include <vector>

#include "shaft/balanced_rows.h"
#include "shaft/set_friction.h"

namespace raceway::shaft {

/// Predicts the friction torque of the sets on a shaft at the rows of a record, repeatedly with
/// different parameters of one model. BalancedRows finds the equilibrium, and SetFriction gives the
/// friction.
class TorqueRows {
 public:
  /// The record must live longer than this object. Throws std::invalid_argument like BalancedRows.
  TorqueRows(const Model& model, const record::Record& record);

  [[nodiscard]] std::size_t size() const { return rows_.size(); }
  /// Returns the calculation steps of the model, including effects on the torque reading.
  [[nodiscard]] const Steps& steps() const { return steps_; }
  /// Writes the torque at every row to `readings` [N m], like predict_torque(). `model` must have
  /// the effects and temperatures of the model in the constructor. Parameters that act before the
  /// stage `from` must have the values of the previous call; other parameters may differ.
  void predict(const Model& model, std::span<double> readings,
               model::Stage from = model::Stage::entry);

 private:
  struct Made {
    /// BalancedRows::Row::solved when the predictors of the row were made; 0: not made.
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
/// all bearings in their equilibrium, plus the contributions of effects on the torque reading. The
/// value of a row is NaN if the sets have no equilibrium or an effect gives no finite value.
/// BalancedRows defines the load, preload and temperatures of a row. Throws std::invalid_argument
/// like BalancedRows.
[[nodiscard]] std::vector<double> predict_torque(const Model& model, const record::Record& record);

}  // namespace raceway::shaft
