#pragma once

#include <mutex>
#include <span>
#include <vector>

#include "fit/subject.h"
#include "model/fitted_model.h"
#include "model/row.h"
#include "model/row_predictor.h"

namespace raceway::rig {

/// Equilibria of the bearing at the rows of a record, for the parameter values of the model file.
/// The equilibria are computed at the first request and then shared by all predictors.
class EnteredBalances {
 public:
  EnteredBalances(const model::Model& model, const record::Record& record);
  /// Returns one equilibrium for each row. The list is empty for a bearing with cylindrical
  /// rollers, and if the operating points of `rows` differ from the points of the record. Several
  /// threads may call this function at the same time.
  [[nodiscard]] std::span<const model::Balance> of(std::span<const model::Row> rows) const;
  /// Works like of(), for a bearing with cylindrical rollers. The list is empty for a ball bearing.
  [[nodiscard]] std::span<const model::RowPredictor::Rollers> rollers_of(
      std::span<const model::Row> rows) const;

 private:
  [[nodiscard]] bool solve_for(std::span<const model::Row> rows) const;

  model::Model model_;
  std::vector<bearing::OperatingPoint> points_;
  mutable std::once_flag solved_;
  mutable std::vector<model::Balance> balances_;
  mutable std::vector<model::RowPredictor::Rollers> rollers_;
};

/// Predicts the friction torque that a rig measures at every row of a record [N m]. If a parameter
/// changes, only the first stage that it affects (model::Stage) and the later stages are computed
/// again.
class RigPredictor : public fit::Predictor {
 public:
  /// `entered` may be null. Only the constructor uses it.
  RigPredictor(const model::Model& model, const record::Record& record,
               std::vector<model::ParameterPlace> places, const EnteredBalances* entered);
  /// Writes the torque of every row to `out` [N m]. `values` are in the order of `places`. All
  /// torques are NaN for values that the model rejects. If the model rejects the values of its
  /// file, the function throws std::invalid_argument.
  void readings(std::span<const double> values, std::span<double> out) override;

 private:
  model::Steps steps_;
  model::FittedModel fitted_;
  std::vector<model::RowPredictor> rows_;
};

}  // namespace raceway::rig
