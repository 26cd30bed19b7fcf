#pragma once

#include <span>
#include <string>
#include <vector>

#include "shaft/balanced_rows.h"

namespace raceway::shaft {

/// Predicts the axial displacement of a shaft at the rows of a record. A fit can repeat the
/// prediction with different parameter values of one model. BalancedRows finds the equilibrium of
/// the sets at each row.
class DisplacementRows {
 public:
  /// The record must exist as long as this object. Throws std::invalid_argument in the same cases
  /// as BalancedRows.
  DisplacementRows(const Model& model, const record::Record& record);

  [[nodiscard]] std::size_t size() const { return rows_.size(); }
  /// Writes the displacement at every row to `readings` [m]: the values that predict_displacement()
  /// returns for `model`. `model` must have the same effects and temperatures as the model in the
  /// constructor; other parameters may differ.
  void predict(const Model& model, std::span<double> readings);

 private:
  struct Standstill {
    double position = 0.0;  ///< [m]
    int version = 0;        ///< value of ShaftBalance::version() when this position was computed
  };
  /// Returns the shaft position at standstill under the load of row i [m].
  [[nodiscard]] double standstill(const Model& model, std::size_t i);

  Steps steps_;
  BalancedRows rows_;
  std::vector<Standstill> standstills_;
};

/// Returns the displacement of the shaft at the rows of a record [m]: ShaftPrediction::displacement
/// plus the displacement that effects of the model add to the sensor reading. The value of a row is
/// NaN if the sets have no equilibrium or an effect gives no finite value. See BalancedRows for the
/// load, preload and temperatures of a row. Throws std::invalid_argument in the same cases as
/// BalancedRows.
[[nodiscard]] std::vector<double> predict_displacement(const Model& model,
                                                       const record::Record& record);

/// Returns a note if the record has rows at standstill under different loads. Displacement is
/// measured from standstill under the same load, so the model predicts 0 for these rows, whatever
/// the readings are. The text is empty if the record has no such rows.
[[nodiscard]] std::string note_on_standstill(const record::Record& record);

}  // namespace raceway::shaft
