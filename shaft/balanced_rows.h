#pragma once

#include <optional>
#include <vector>

#include "model/balance.h"
#include "model/row.h"
#include "shaft/shaft_balance.h"

namespace raceway::shaft {

/// Solves the equilibrium of the bearing sets on a shaft for the rows of a record. A fit can solve
/// the rows repeatedly with different parameter values of one model. Each row stores its last
/// equilibrium, and the next solution of the row starts from this equilibrium. A row is solved
/// again only if its input has changed: the mounted sets, the operating condition of the sets, or
/// the oil properties that determine the ball rotation (model::BallTurning).
///
/// The axial load of a row is the external load on the shaft. A record without axial load uses the
/// external load of the model. The recorded preload force at standstill and recorded ring
/// temperatures replace the values of the model. set_temperatures() gives the temperatures of shaft
/// and housing. If the model gives no ball temperature, the balls have the mean temperature of the
/// rings.
class BalancedRows {
 public:
  struct Row {
    /// Row of the record. Ring temperatures that the record lacks come from the model.
    model::Row row;
    std::optional<bearing::SetTemperatures> temperatures;
    /// Changes that the effects of the model make to each bearing, front set first.
    std::vector<effects::Condition> bearings{};
    bearing::ArrangementEquilibrium equilibrium{};
    int solved = 0;  ///< number of times that the equilibrium of this row was solved

   private:
    friend class BalancedRows;
    std::size_t balance = 0;  // index into balances_
    bearing::ArrangementCondition condition{};
    model::BallTurning turning{};
    int version = 0;  // ShaftBalance::version() at the last solution
  };

  /// The record must exist as long as this object. Throws std::invalid_argument for a model without
  /// a shaft, and for temperatures that add_expansion() rejects.
  BalancedRows(const Model& model, const record::Record& record);

  [[nodiscard]] std::size_t size() const { return rows_.size(); }
  [[nodiscard]] const Row& operator[](std::size_t i) const { return rows_[i]; }
  /// Returns the mounted sets with the preload of row i.
  [[nodiscard]] const ShaftBalance& sets(std::size_t i) const {
    return balances_[rows_[i].balance];
  }

  /// Mounts the sets with the parameter values of `model`. Then call find() for each row, in the
  /// order of the record.
  void mount(const Model& model, const Steps& steps);
  /// Solves the equilibrium of row i. Returns false if the sets cannot be mounted or have no
  /// equilibrium, or if the speed, the load or the result of an effect is not finite.
  [[nodiscard]] bool find(const Model& model, const Steps& steps, std::size_t i);

 private:
  [[nodiscard]] std::size_t balance_of(double preload);

  std::vector<Row> rows_;
  std::vector<double> preloads_;        // different preloads of the rows
  std::vector<ShaftBalance> balances_;  // one for each preload
  const Row* last_ = nullptr;           // last row in equilibrium
  ShaftCondition wanted_;
};

}  // namespace raceway::shaft
