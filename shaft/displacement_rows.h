#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "model/balance.h"
#include "model/row.h"
#include "shaft/shaft_balance.h"

namespace raceway::shaft {

/// Displacement of a model's shaft at the rows of a record, predicted again and again with other
/// numbers of one model. A row remembers its balance, from which the next one is found, and which
/// is solved again only where something has moved the sets.
class DisplacementRows {
 public:
  /// The record must outlive it. Throws std::invalid_argument for a model without shaft, and as
  /// add_expansion() does.
  DisplacementRows(const Model& model, const record::Record& record);

  [[nodiscard]] std::size_t size() const { return rows_.size(); }
  /// Readings of all rows [m], as predict_displacement(). `model` has the effects of the one before
  /// and its temperatures, with any other numbers.
  void predict(const Model& model, std::span<double> readings);

 private:
  struct Known {
    model::Row row;  ///< ring temperatures taken from the model where the row has none
    std::optional<bearing::SetTemperatures> temperatures;
    std::size_t balance = 0;  ///< index into balances_
    bearing::ArrangementCondition condition{};
    model::BallTurning turning{};
    bearing::ArrangementEquilibrium equilibrium{};
    int version = 0;          ///< of the balance that it belongs to
    double standstill = 0.0;  ///< [m]
  };
  [[nodiscard]] std::size_t balance_of(double preload);
  /// Position against standstill [m].
  double displacement(const Model& model, Known& known,
                      const bearing::ArrangementEquilibrium* neighbour);

  Steps steps_;
  std::vector<Known> rows_;
  std::vector<double> preloads_;        // that rows have
  std::vector<ShaftBalance> balances_;  // one for each
  ShaftCondition wanted_;
};

/// Displacement of the model's shaft at the rows of a record [m], as ShaftPrediction::displacement
/// with the readings that effects add; NaN where the sets do not balance or an effect has no
/// number. The axial load of a row is the external load; where none was recorded it comes from the
/// model.
///
/// Recorded values replace the values of the model: the preload as force at standstill, ring
/// temperatures. Balls, shaft and housing keep the temperatures of the model where it has any;
/// otherwise they follow the rings: balls their mean, the shaft the inner, the housing the outer.
/// Throws std::invalid_argument for a model without shaft, and as add_expansion() does.
[[nodiscard]] std::vector<double> predict_displacement(const Model& model,
                                                       const record::Record& record);

/// Note on rows at standstill under different loads: their displacement counts from standstill
/// under the same load, so the model gives 0 there whatever was read. Empty where there are none.
[[nodiscard]] std::string note_on_standstill(const record::Record& record);

}  // namespace raceway::shaft
