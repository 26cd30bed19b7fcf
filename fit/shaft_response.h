#pragma once

#include <Eigen/Core>
#include <functional>
#include <span>
#include <vector>

#include "fit/free_parameters.h"
#include "fit/shaft_balance.h"

namespace raceway::fit {

/// Displacement of a model's shaft at rows that are predicted again and again with other parameter
/// values of one model. A row remembers its balance, from which the next one is found, and which is
/// solved again only where something has moved the sets.
class DisplacementRows {
 public:
  /// Rows are copied.
  DisplacementRows(const Model& model, std::span<const Row> rows);

  [[nodiscard]] std::size_t size() const { return rows_.size(); }
  /// Readings of all rows [m], as predict_displacement(). `model` has the arrangement and the
  /// effects of the one before, with any numbers. Throws std::invalid_argument as add_expansion()
  /// does.
  void predict(const Model& model, std::span<double> readings);

 private:
  struct Known {
    Row row;
    effects::Record record;
    std::size_t balance = 0;  ///< index into balances_
    bearing::ArrangementCondition condition{};
    bearing::ArrangementEquilibrium equilibrium{};
    int version = 0;          ///< of the balance that it belongs to
    double standstill = 0.0;  ///< [m]
  };
  /// Position against standstill [m].
  double displacement(const Model& model, Known& known,
                      const bearing::ArrangementEquilibrium* neighbour);

  Steps steps_;
  std::vector<Known> rows_;
  std::vector<ShaftBalance> balances_;  // one for each preload that rows have
  ShaftCondition wanted_;
};

/// Displacement of the model's shaft at rows of measured displacement [m], as
/// ShaftPrediction::displacement with the readings that effects add; NaN where the sets do not
/// balance or an effect has no number. The axial load of a row is the external load.
///
/// What was recorded with a row stands in the place of what the model says: the preload as force at
/// standstill, ring temperatures. Balls, shaft and housing keep the temperatures of the model where
/// it has any; otherwise they follow the rings: balls their mean, the shaft the inner, the housing
/// the outer.
/// Throws std::invalid_argument for a model without shaft, and as add_expansion() does.
[[nodiscard]] std::vector<double> predict_displacement(const Model& model,
                                                       std::span<const Row> rows);

/// The same as a function of these parameters of the model [m by row]; NaN throughout for values
/// that no arrangement can take.
[[nodiscard]] std::function<Eigen::VectorXd(const Eigen::VectorXd&)> displacement_readings(
    const Model& model, std::span<const Row> rows, const std::vector<ModelParameter>& parameters);

}  // namespace raceway::fit
