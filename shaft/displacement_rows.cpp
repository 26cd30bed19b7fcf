#include "shaft/displacement_rows.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <utility>

namespace raceway::shaft {
namespace {

bool same(double a, double b) { return a == b || (std::isnan(a) && std::isnan(b)); }

}  // namespace

DisplacementRows::DisplacementRows(const Model& model, const record::Record& record)
    : steps_(model, false, record::axial_displacement) {
  if (!model.shaft) throw std::invalid_argument("the model has no shaft");
  const Shaft& shaft = *model.shaft;
  rows_.reserve(record.rows());
  for (model::Row& row : model::rows_of(record)) {
    Known& known = rows_.emplace_back(Known{.row = row, .temperatures = {}});
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

std::size_t DisplacementRows::balance_of(double preload) {
  const auto found = std::find_if(preloads_.begin(), preloads_.end(),
                                  [&](double known) { return same(known, preload); });
  const auto index = static_cast<std::size_t>(found - preloads_.begin());
  if (found == preloads_.end()) {
    preloads_.push_back(preload);
    balances_.emplace_back(preload);
  }
  return index;
}

double DisplacementRows::displacement(const Model& model, Known& known,
                                      const bearing::ArrangementEquilibrium* neighbour) {
  const ShaftBalance& balance = balances_[known.balance];
  const bearing::OperatingPoint& point = known.row.point;
  if (!std::isfinite(point.speed) || !std::isfinite(point.axial_load)) return unset;
  if (!balance.find_condition(model, steps_, point, known.row.record, known.temperatures, wanted_))
    return unset;
  const model::BallTurning turning = ball_turning(model, model.lubricant, point.temperature);
  if (known.version != balance.version() || !(wanted_.sets == known.condition) ||
      turning != known.turning) {
    const bool solved_before = known.equilibrium.report.converged();
    bearing::ArrangementEquilibrium found =
        solve_sets(model, balance.arrangement(), wanted_.sets, {&point.temperature, 1},
                   solved_before ? &known.equilibrium : neighbour);
    if (!found.report.converged()) return unset;
    if (known.version != balance.version())
      known.standstill = balance.standstill(point.axial_load, model.solver);
    known.equilibrium = std::move(found);
    known.condition = wanted_.sets;
    known.turning = turning;
    known.version = balance.version();
  }
  return known.equilibrium.position - known.standstill;
}

void DisplacementRows::predict(const Model& model, std::span<double> readings) {
  for (ShaftBalance& balance : balances_) (void)balance.mount(model, steps_);
  const Known* last = nullptr;  // that was in balance
  for (std::size_t i = 0; i < rows_.size(); ++i) {
    Known& known = rows_[i];
    readings[i] = unset;
    if (!balances_[known.balance].mounted()) continue;
    const bool near = last && last->balance == known.balance;
    const double u = displacement(model, known, near ? &last->equilibrium : nullptr);
    if (std::isnan(u)) continue;
    last = &known;
    readings[i] = u;
    const effects::ReadingInputs inputs{
        .value = u, .point = known.row.point, .record = known.row.record};
    for (const std::size_t k : steps_.reading)
      readings[i] += model.effects[k].description->reading(inputs, model.effects[k].values);
  }
}

std::vector<double> predict_displacement(const Model& model, const record::Record& record) {
  std::vector<double> readings(record.rows());
  DisplacementRows(model, record).predict(model, readings);
  return readings;
}

std::string note_on_standstill(const record::Record& record) {
  const std::span<const double> speed = record.values(record::speed),
                                load = record.values(record::axial_load),
                                read = record.values(record::axial_displacement);
  if (load.empty() || read.empty()) return {};
  std::size_t rows = 0;
  double least = std::numeric_limits<double>::infinity(), most = -least;
  for (std::size_t i = 0; i < speed.size(); ++i) {
    if (speed[i] != 0.0 || !std::isfinite(read[i])) continue;
    ++rows;
    least = std::min(least, load[i]);
    most = std::max(most, load[i]);
  }
  if (rows == 0 || !(most - least > 1e-3 * std::max(std::abs(most), std::abs(least)))) return {};
  return fmt::format(
      "{} row{} at standstill, {:.6g} to {:.6g} N: axial_displacement_um counts from standstill "
      "under "
      "the same load, so that the model has 0 um there; the load-deflection curve is "
      "axial_position_um, of raceway table --speed 0 --axial-load FROM:TO:STEP",
      rows, rows == 1 ? "" : "s", least, most);
}

}  // namespace raceway::shaft
