#include "rig/rig_predictor.h"

#include <tbb/task_arena.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>

namespace raceway::rig {
namespace {

bool same(double a, double b) { return a == b || (std::isnan(a) && std::isnan(b)); }

/// Of two points of records, which have no more than this.
bool same_point(const bearing::OperatingPoint& a, const bearing::OperatingPoint& b) {
  return same(a.speed, b.speed) && same(a.axial_load, b.axial_load) &&
         same(a.radial_load, b.radial_load) && same(a.temperature, b.temperature);
}

}  // namespace

EnteredBalances::EnteredBalances(const model::Model& model, const record::Record& record)
    : model_(model) {
  points_.reserve(record.rows());
  for (const model::Row& row : model::rows_of(record)) points_.push_back(row.point);
}

/// False where the points are others.
bool EnteredBalances::solve_for(std::span<const model::Row> rows) const {
  if (!std::equal(rows.begin(), rows.end(), points_.begin(), points_.end(),
                  [](const model::Row& row, const bearing::OperatingPoint& point) {
                    return same_point(row.point, point);
                  }))
    return false;
  std::call_once(solved_, [this] {
    // A thread that waits here for its helpers must not take up a task that asks the same.
    tbb::this_task_arena::isolate([this] {
      if (model_.bearing.rollers())
        rollers_ = entered_rollers(model_, points_);
      else
        balances_ = entered_balances(model_, points_);
    });
  });
  return true;
}

std::span<const model::Balance> EnteredBalances::of(std::span<const model::Row> rows) const {
  if (!solve_for(rows)) return {};
  return balances_;
}

std::span<const model::RowPredictor::Rollers> EnteredBalances::rollers_of(
    std::span<const model::Row> rows) const {
  if (!solve_for(rows)) return {};
  return rollers_;
}

RigPredictor::RigPredictor(const model::Model& model, const record::Record& record,
                           std::vector<model::ParameterPlace> places,
                           const EnteredBalances* entered)
    : steps_(model), fitted_(model, steps_, std::move(places)) {
  const std::vector<model::Row> rows = model::rows_of(record);
  std::span<const model::Balance> balances;
  std::span<const model::RowPredictor::Rollers> rollers;
  if (entered && steps_.equilibrium) {
    balances = entered->of(rows);
    rollers = entered->rollers_of(rows);
  }
  rows_.reserve(rows.size());
  for (std::size_t i = 0; i < rows.size(); ++i)
    rows_.emplace_back(fitted_.model(), steps_, rows[i].point, rows[i].record,
                       balances.empty() ? nullptr : balances[i], effects::Condition{}, nullptr,
                       rollers.empty() ? nullptr : rollers[i]);
}

void RigPredictor::readings(std::span<const double> values, std::span<double> out) {
  try {
    const model::Stage from = fitted_.set(values);
    predict_all(fitted_.model(), steps_, rows_, out, from);
  } catch (const std::invalid_argument&) {
    if (fitted_.as_entered()) throw;
    std::fill(out.begin(), out.end(), unset);
    return;
  }
  fitted_.keep(values);
}

}  // namespace raceway::rig
