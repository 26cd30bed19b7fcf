#pragma once

#include <optional>
#include <vector>

#include "model/balance.h"
#include "model/row.h"
#include "shaft/shaft_balance.h"

namespace raceway::shaft {

/// Solves the equilibrium of the bearing sets on a shaft at the rows of a record, repeatedly with
/// different parameters of one model. Each row stores its equilibrium as the start of its next
/// solve. The equilibrium is solved again only if the mounted sets, the condition of the sets or
/// the oil properties that determine the ball rotation (model::BallTurning) have changed.
///
/// The axial load of a row is the external load on the shaft. A record without axial load uses the
/// external load of the model. The recorded preload force at standstill and recorded ring
/// temperatures replace the values of the model. set_temperatures() gives the temperatures of shaft
/// and housing. If the model gives no ball temperature, the balls have the mean temperature of the
/// rings.
class BalancedRows {
 public:
  struct Row {
    model::Row row;  ///< row of the record; missing ring temperatures come from the model
    std::optional<bearing::SetTemperatures> temperatures;
    /// Changes by effects for each bearing, front set first.
    std::vector<effects::Condition> bearings{};
    bearing::ArrangementEquilibrium equilibrium{};
    int solved = 0;  ///< number of equilibria solved for this row

   private:
    friend class BalancedRows;
    std::size_t balance = 0;  // index into balances_
    bearing::ArrangementCondition condition{};
    model::BallTurning turning{};
    int version = 0;  // ShaftBalance::version() at the last solve
  };

  /// The record must live longer than this object. Throws std::invalid_argument for a model without
  /// a shaft, and for temperatures that add_expansion() rejects.
  BalancedRows(const Model& model, const record::Record& record);

  [[nodiscard]] std::size_t size() const { return rows_.size(); }
  [[nodiscard]] const Row& operator[](std::size_t i) const { return rows_[i]; }
  /// Returns the mounted sets with the preload of row i.
  [[nodiscard]] const ShaftBalance& sets(std::size_t i) const {
    return balances_[rows_[i].balance];
  }

  /// Mounts the sets with the parameter values of a model. Then call find() for the rows in order.
  void mount(const Model& model, const Steps& steps);
  /// Solves the equilibrium of row i. Returns false if the sets cannot be mounted or have no
  /// equilibrium, if the speed or the load is not finite, or if an effect gives no finite value.
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
