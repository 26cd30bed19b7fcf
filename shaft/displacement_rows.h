#pragma once

#include <span>
#include <string>
#include <vector>

#include "shaft/balanced_rows.h"

namespace raceway::shaft {

/// Predicts the displacement of a shaft at the rows of a record, repeatedly with different
/// parameters of one model. BalancedRows finds the equilibrium of the sets at each row.
class DisplacementRows {
 public:
  /// The record must live longer than this object. Throws std::invalid_argument like BalancedRows.
  DisplacementRows(const Model& model, const record::Record& record);

  [[nodiscard]] std::size_t size() const { return rows_.size(); }
  /// Computes the readings of all rows [m], like predict_displacement(). `model` must have the same
  /// effects and temperatures as the previous model; the parameters may differ.
  void predict(const Model& model, std::span<double> readings);

 private:
  struct Standstill {
    double position = 0.0;  ///< [m]
    int version = 0;        ///< ShaftBalance::version() at this position
  };
  /// Returns the position at standstill [m].
  [[nodiscard]] double standstill(const Model& model, std::size_t i);

  Steps steps_;
  BalancedRows rows_;
  std::vector<Standstill> standstills_;
};

/// Returns the displacement of the shaft at the rows of a record [m]: ShaftPrediction::displacement
/// plus the contributions of effects on the reading. The value of a row is NaN if the sets have no
/// equilibrium or an effect has no value. Loads, preload and temperatures of a row come from
/// BalancedRows. Throws std::invalid_argument for a model without a shaft, and like
/// add_expansion().
[[nodiscard]] std::vector<double> predict_displacement(const Model& model,
                                                       const record::Record& record);

/// Returns a note on rows at standstill under different loads. Displacement is measured from
/// standstill under the same load, so the model predicts 0 for these rows, whatever the readings
/// are. The text is empty if there are no such rows.
[[nodiscard]] std::string note_on_standstill(const record::Record& record);

}  // namespace raceway::shaft
