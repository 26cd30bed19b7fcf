#pragma once

#include <mutex>
#include <span>
#include <vector>

#include "fit/subject.h"
#include "model/fitted_model.h"
#include "model/row.h"
#include "model/row_predictor.h"

namespace raceway::rig {

/// Equilibria of the bearing at the operating points of a record, for the parameter values of the
/// model file. The first call of a member function computes the equilibria.
class EnteredBalances {
 public:
  EnteredBalances(const model::Model& model, const record::Record& record);
  /// Returns the equilibrium of a ball bearing at each row. The list is empty for a bearing with
  /// cylindrical rollers, and if `rows` do not have the operating points of the record. Several
  /// threads may call this function at the same time.
  [[nodiscard]] std::span<const model::Balance> of(std::span<const model::Row> rows) const;
  /// Returns the equilibrium of a bearing with cylindrical rollers at each row. The list is empty
  /// for a ball bearing, and if `rows` do not have the operating points of the record. Several
  /// threads may call this function at the same time.
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

/// Predicts the friction torque that a rig measures at every row of a record [N m]. If only some
/// parameters change, the predictor repeats only the stages of the calculation that depend on them
/// (model::Stage).
class RigPredictor : public fit::Predictor {
 public:
  /// `entered` provides the equilibria for the parameter values of the model file. If `entered` is
  /// null, the predictor computes these equilibria. `entered` is used only in the constructor.
  RigPredictor(const model::Model& model, const record::Record& record,
               std::vector<model::ParameterPlace> places, const EnteredBalances* entered);
  /// Writes the torque of every row to `out` [N m]. `values` are in the order of `places`. If a
  /// value is not valid in the model, all torques are NaN. If even the values of the model file are
  /// not valid, the function throws std::invalid_argument.
  void readings(std::span<const double> values, std::span<double> out) override;

 private:
  model::Steps steps_;
  model::FittedModel fitted_;
  std::vector<model::RowPredictor> rows_;
};

}  // namespace raceway::rig
