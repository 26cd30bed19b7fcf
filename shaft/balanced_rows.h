#pragma once

#include <optional>
#include <vector>

#include "model/balance.h"
#include "model/row.h"
#include "shaft/shaft_balance.h"

namespace raceway::shaft {

/// Solves the equilibrium of the sets on a shaft at the rows of a record, repeatedly with different
/// parameters of one model. Each row stores its equilibrium as the start of its next solve. The
/// equilibrium is solved again only if the mounted sets, their condition or the inputs of ball
/// rotation have changed.
///
/// The axial load of a row is the external load. Without a recorded load, the model gives the load.
/// The recorded preload force at standstill and recorded ring temperatures replace the values of
/// the model. Balls, shaft and housing keep the temperatures of the model if it gives any.
/// Otherwise, the balls have the mean temperature of the rings, the shaft has the temperature of
/// the inner ring, and the housing has the temperature of the outer ring.
class BalancedRows {
 public:
  struct Row {
    model::Row row;  ///< row of the record; missing ring temperatures come from the model
    std::optional<bearing::SetTemperatures> temperatures;
    std::vector<effects::Condition> bearings{};  ///< changes by effects, front set first
    bearing::ArrangementEquilibrium equilibrium{};
    int solved = 0;  ///< number of solved equilibria

   private:
    friend class BalancedRows;
    std::size_t balance = 0;  // index into balances_
    bearing::ArrangementCondition condition{};
    model::BallTurning turning{};
    int version = 0;  // version() of its ShaftBalance when it was solved
  };

  /// The record must live longer than this object. Throws std::invalid_argument for a model without
  /// a shaft, and like add_expansion().
  BalancedRows(const Model& model, const record::Record& record);

  [[nodiscard]] std::size_t size() const { return rows_.size(); }
  [[nodiscard]] const Row& operator[](std::size_t i) const { return rows_[i]; }
  /// Returns the sets of a row.
  [[nodiscard]] const ShaftBalance& sets(std::size_t i) const {
    return balances_[rows_[i].balance];
  }

  /// Mounts the sets of a model. find() then solves the rows, in their order.
  void mount(const Model& model, const Steps& steps);
  /// Solves a row. Returns false if the sets have no equilibrium or an effect has no value.
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
