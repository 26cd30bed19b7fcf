#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "model/balance.h"
#include "model/row.h"
#include "shaft/shaft_balance.h"

namespace raceway::shaft {

/// Predicts the displacement of a shaft at the rows of a record, repeatedly with different
/// parameters of one model. Each row stores its balance as the start for the next one. The balance
/// is solved again only if the condition of the sets has changed.
class DisplacementRows {
 public:
  /// The record must live longer than this object. Throws std::invalid_argument for a model without
  /// a shaft, and like add_expansion().
  DisplacementRows(const Model& model, const record::Record& record);

  [[nodiscard]] std::size_t size() const { return rows_.size(); }
  /// Computes the readings of all rows [m], like predict_displacement(). `model` must have the same
  /// effects and temperatures as the previous model; its parameters may differ.
  void predict(const Model& model, std::span<double> readings);

 private:
  struct Known {
    model::Row row;  ///< row with ring temperatures of the model if it has none of its own
    std::optional<bearing::SetTemperatures> temperatures;
    std::size_t balance = 0;  ///< index into balances_
    bearing::ArrangementCondition condition{};
    model::BallTurning turning{};
    bearing::ArrangementEquilibrium equilibrium{};
    int version = 0;          ///< version of the mounted sets for this balance
    double standstill = 0.0;  ///< [m]
  };
  [[nodiscard]] std::size_t balance_of(double preload);
  /// Returns the position relative to standstill [m].
  double displacement(const Model& model, Known& known,
                      const bearing::ArrangementEquilibrium* neighbour);

  Steps steps_;
  std::vector<Known> rows_;
  std::vector<double> preloads_;        // preloads that occur in rows
  std::vector<ShaftBalance> balances_;  // one balance for each preload
  ShaftCondition wanted_;
};

/// Returns the displacement of the shaft at the rows of a record [m]: ShaftPrediction::displacement
/// plus the contributions of effects on the reading. It is NaN if the sets have no balance or an
/// effect has no value. The axial load of a row is the external load. Without a recorded load, the
/// model gives it.
///
/// Recorded values replace values of the model: the preload force at standstill and ring
/// temperatures. Balls, shaft and housing keep the temperatures of the model if it gives any.
/// Otherwise, balls take the mean of the rings, the shaft takes the inner ring and the housing
/// takes the outer ring. Throws std::invalid_argument for a model without a shaft, and like
/// add_expansion().
[[nodiscard]] std::vector<double> predict_displacement(const Model& model,
                                                       const record::Record& record);

/// Returns a note on rows at standstill under different loads. Displacement is measured from
/// standstill under the same load, so the model predicts 0 for these rows, whatever the readings
/// are. The text is empty if there are no such rows.
[[nodiscard]] std::string note_on_standstill(const record::Record& record);

}  // namespace raceway::shaft
