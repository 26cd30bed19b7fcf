#pragma once

#include <span>
#include <vector>

#include "shaft/balanced_rows.h"
#include "shaft/set_friction.h"

namespace raceway::shaft {

/// Friction torque of the sets on a model's shaft at the rows of a record, predicted again and
/// again with other numbers of one model. The balance is BalancedRows', the friction SetFriction's.
class TorqueRows {
 public:
  /// The record must outlive it. Throws std::invalid_argument as BalancedRows.
  TorqueRows(const Model& model, const record::Record& record);

  [[nodiscard]] std::size_t size() const { return rows_.size(); }
  /// Steps of the model, with those of the reading of the torque.
  [[nodiscard]] const Steps& steps() const { return steps_; }
  /// Readings of all rows [N m], as predict_torque(). `model` has the effects of the one before and
  /// its temperatures, with any other numbers; those that act before `from` are unchanged.
  void predict(const Model& model, std::span<double> readings,
               model::Stage from = model::Stage::entry);

 private:
  struct Made {
    int solved = 0;  ///< which balance of the row its bearings stand in; 0: none
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

/// Friction torque of the sets of the model's shaft at the rows of a record [N m]: the sum over all
/// bearings, each in the balance of the sets, with the readings that effects add; NaN where the
/// sets do not balance or an effect has no number. Loads, preload and temperatures as BalancedRows
/// takes them. Throws std::invalid_argument as BalancedRows.
[[nodiscard]] std::vector<double> predict_torque(const Model& model, const record::Record& record);

}  // namespace raceway::shaft
