#pragma once

#include <mutex>
#include <span>
#include <vector>

#include "fit/subject.h"
#include "model/parameters.h"
#include "model/row.h"
#include "model/row_predictor.h"

namespace raceway::rig {

/// Balances of the rows of a record as entered, solved at the first request and then shared.
class EnteredBalances {
 public:
  EnteredBalances(const model::Model& model, const record::Record& record);
  /// Balances by row; nothing where the points differ. May be called by several threads at once.
  [[nodiscard]] std::span<const model::Balance> of(std::span<const model::Row> rows) const;
  /// Balances of a bearing with cylindrical rollers, otherwise as of().
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

/// Friction torque that a rig reads at every row of a record [N m]. Results are kept for all stages
/// before the first one that a changed parameter affects.
class RigPredictor : public fit::Predictor {
 public:
  /// `entered` may be null; it is looked at here alone.
  RigPredictor(const model::Model& model, const record::Record& record,
               std::vector<model::ParameterPlace> places, const EnteredBalances* entered);
  /// Values by place. NaN throughout for values that the model cannot take; of the model as it is
  /// an exception says why.
  void readings(std::span<const double> values, std::span<double> out) override;

 private:
  void set(std::span<const double> values, model::Stage& from);

  model::Model model_;
  model::Steps steps_;
  std::vector<model::RowPredictor> rows_;
  std::vector<model::ParameterPlace> places_;
  std::vector<model::Stage> stages_;  // of the places
  std::vector<double> last_;
  bool known_ = false;  // all rows have the last values
};

}  // namespace raceway::rig
