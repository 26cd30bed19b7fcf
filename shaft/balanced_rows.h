#pragma once

#include <optional>
#include <vector>

#include "model/balance.h"
#include "model/row.h"
#include "shaft/shaft_balance.h"

namespace raceway::shaft {

/// The sets of a model's shaft in balance at the rows of a record, asked for again and again with
/// other numbers of one model. A row remembers its balance, from which the next one is found, and
/// which is solved again only where something has moved the sets.
///
/// The axial load of a row is the external load; where none was recorded it comes from the model.
/// Recorded values replace the values of the model: the preload as force at standstill, ring
/// temperatures. Balls, shaft and housing keep the temperatures of the model where it has any;
/// otherwise they follow the rings: balls their mean, the shaft the inner, the housing the outer.
class BalancedRows {
 public:
  struct Row {
    model::Row row;  ///< ring temperatures taken from the model where the row has none
    std::optional<bearing::SetTemperatures> temperatures;
    std::vector<effects::Condition> bearings{};  ///< changes by effects, front set first
    bearing::ArrangementEquilibrium equilibrium{};
    int solved = 0;  ///< how often

   private:
    friend class BalancedRows;
    std::size_t balance = 0;  // index into balances_
    bearing::ArrangementCondition condition{};
    model::BallTurning turning{};
    int version = 0;  // of the balance that it belongs to
  };

  /// The record must outlive it. Throws std::invalid_argument for a model without shaft, and as
  /// add_expansion() does.
  BalancedRows(const Model& model, const record::Record& record);

  [[nodiscard]] std::size_t size() const { return rows_.size(); }
  [[nodiscard]] const Row& operator[](std::size_t i) const { return rows_[i]; }
  /// The sets of a row.
  [[nodiscard]] const ShaftBalance& sets(std::size_t i) const {
    return balances_[rows_[i].balance];
  }

  /// Mounts the sets of a model; find() follows for the rows, in their order.
  void mount(const Model& model, const Steps& steps);
  /// Balances a row. False where the sets do not balance or an effect has no number.
  [[nodiscard]] bool find(const Model& model, const Steps& steps, std::size_t i);

 private:
  [[nodiscard]] std::size_t balance_of(double preload);

  std::vector<Row> rows_;
  std::vector<double> preloads_;        // that rows have
  std::vector<ShaftBalance> balances_;  // one for each
  const Row* last_ = nullptr;           // that was in balance
  ShaftCondition wanted_;
};

}  // namespace raceway::shaft
