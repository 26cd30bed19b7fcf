#include "shaft/balanced_rows.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>

namespace raceway::shaft {
namespace {

bool same(double a, double b) { return a == b || (std::isnan(a) && std::isnan(b)); }

}  // namespace

BalancedRows::BalancedRows(const Model& model, const record::Record& record) {
  if (!model.shaft) throw std::invalid_argument("the model has no shaft");
  const Shaft& shaft = *model.shaft;
  rows_.reserve(record.rows());
  for (model::Row& row : model::rows_of(record)) {
    Row& known = rows_.emplace_back();
    known.row = std::move(row);
    effects::Record& recorded = known.row.record;
    if (!record.has(record::axial_load)) known.row.point.axial_load = shaft.external_load;
    known.temperatures =
        set_temperatures(shaft, recorded.inner_ring_temperature, recorded.outer_ring_temperature);
    if (known.temperatures) {
      add_expansion(shaft.arrangement, *known.temperatures, wanted_.sets);  // for its checks
      recorded.inner_ring_temperature = known.temperatures->inner_ring;
      recorded.outer_ring_temperature = known.temperatures->outer_ring;
    }
    known.balance = balance_of(known.row.preload);
  }
}

std::size_t BalancedRows::balance_of(double preload) {
  const auto found = std::find_if(preloads_.begin(), preloads_.end(),
                                  [&](double known) { return same(known, preload); });
  const auto index = static_cast<std::size_t>(found - preloads_.begin());
  if (found == preloads_.end()) {
    preloads_.push_back(preload);
    balances_.emplace_back(preload);
  }
  return index;
}

void BalancedRows::mount(const Model& model, const Steps& steps) {
  for (ShaftBalance& balance : balances_) (void)balance.mount(model, steps);
  last_ = nullptr;
}

bool BalancedRows::find(const Model& model, const Steps& steps, std::size_t i) {
  Row& known = rows_[i];
  const ShaftBalance& balance = balances_[known.balance];
  const bearing::OperatingPoint& point = known.row.point;
  if (!balance.mounted() || !std::isfinite(point.speed) || !std::isfinite(point.axial_load))
    return false;
  if (!balance.find_condition(model, steps, point, known.row.record, known.temperatures, wanted_))
    return false;
  const model::BallTurning turning = ball_turning(model, model.lubricant, point.temperature);
  if (known.version != balance.version() || !(wanted_.sets == known.condition) ||
      turning != known.turning) {
    const bearing::ArrangementEquilibrium* start =
        known.equilibrium.report.converged()       ? &known.equilibrium
        : last_ && last_->balance == known.balance ? &last_->equilibrium
                                                   : nullptr;
    bearing::ArrangementEquilibrium found =
        solve_sets(model, balance.arrangement(), wanted_.sets, {&point.temperature, 1}, start);
    if (!found.report.converged()) return false;
    known.equilibrium = std::move(found);
    known.condition = wanted_.sets;
    known.turning = turning;
    known.version = balance.version();
    ++known.solved;
  }
  known.bearings = wanted_.bearings;
  last_ = &known;
  return true;
}

}  // namespace raceway::shaft
