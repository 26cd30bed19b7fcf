#pragma once

#include <mutex>
#include <span>
#include <vector>

#include "fit/subject.h"
#include "model/fitted_model.h"
#include "model/row.h"
#include "model/row_predictor.h"

namespace raceway::rig {

/// Equilibria of the bearing at the rows of a record, for the model with the values of its file.
/// The equilibria are solved at the first request and then shared.
class EnteredBalances {
 public:
  EnteredBalances(const model::Model& model, const record::Record& record);
  /// Returns the equilibria by row; empty if the operating points of `rows` differ from those of
  /// the record. Several threads may call this function at the same time.
  [[nodiscard]] std::span<const model::Balance> of(std::span<const model::Row> rows) const;
  /// Works like of(), for a bearing with cylindrical rollers.
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
/// changes, the results of all stages before the first affected stage are kept.
class RigPredictor : public fit::Predictor {
 public:
  /// `entered` may be null; it is used only in the constructor.
  RigPredictor(const model::Model& model, const record::Record& record,
               std::vector<model::ParameterPlace> places, const EnteredBalances* entered);
  /// Values are in the order of the places. All readings are NaN for values that the model rejects.
  /// If the model rejects the values of its file, an exception with the reason is thrown instead.
  void readings(std::span<const double> values, std::span<double> out) override;

 private:
  model::Steps steps_;
  model::FittedModel fitted_;
  std::vector<model::RowPredictor> rows_;
};

}  // namespace raceway::rig
