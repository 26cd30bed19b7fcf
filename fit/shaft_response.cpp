#include "fit/shaft_response.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <stdexcept>
#include <utility>

namespace raceway::fit {

namespace {

bool same(double a, double b) { return a == b || (std::isnan(a) && std::isnan(b)); }

}  // namespace

DisplacementRows::DisplacementRows(const Model& model, std::span<const Row> rows) : steps_(model) {
  if (!model.shaft) throw std::invalid_argument("the model has no shaft");
  std::vector<double> preloads;
  rows_.reserve(rows.size());
  for (const Row& row : rows) {
    auto found = std::find_if(preloads.begin(), preloads.end(),
                              [&](double preload) { return same(preload, row.preload); });
    if (found == preloads.end()) {
      found = preloads.insert(preloads.end(), row.preload);
      balances_.emplace_back(row.preload);
    }
    rows_.push_back({.row = row,
                     .record = record_of(row),
                     .balance = static_cast<std::size_t>(found - preloads.begin())});
  }
}

double DisplacementRows::displacement(const Model& model, Known& known,
                                      const bearing::ArrangementEquilibrium* neighbour) {
  const ShaftBalance& balance = balances_[known.balance];
  const auto temperatures = set_temperatures(*model.shaft, known.row.inner_ring_temperature,
                                             known.row.outer_ring_temperature);
  if (temperatures) {
    known.record.inner_ring_temperature = temperatures->inner_ring;
    known.record.outer_ring_temperature = temperatures->outer_ring;
  }
  if (!balance.find_condition(model, steps_, known.row.point, known.record, temperatures, wanted_))
    return unset;
  if (known.version != balance.version() || !(wanted_.sets == known.condition)) {
    const bool solved_before = known.equilibrium.report.converged();
    bearing::ArrangementEquilibrium found =
        solve_arrangement(balance.arrangement(), wanted_.sets, model.solver,
                          solved_before ? &known.equilibrium : neighbour);
    if (!found.report.converged()) return unset;
    if (known.version != balance.version())
      known.standstill = balance.standstill(known.row.point.axial_load, model.solver);
    known.equilibrium = std::move(found);
    known.condition = wanted_.sets;
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
    const effects::DisplacementInputs inputs{
        .displacement = u, .point = known.row.point, .record = known.record};
    for (const std::size_t k : steps_.displacement)
      readings[i] += model.effects[k].description->displacement(inputs, model.effects[k].values);
  }
}

std::vector<double> predict_displacement(const Model& model, std::span<const Row> rows) {
  std::vector<double> readings(rows.size());
  DisplacementRows(model, rows).predict(model, readings);
  return readings;
}

std::function<Eigen::VectorXd(const Eigen::VectorXd&)> displacement_readings(
    const Model& model, std::span<const Row> rows, const std::vector<ModelParameter>& parameters) {
  struct Remembered {
    Model model;
    DisplacementRows rows;
  };
  const auto known = std::make_shared<Remembered>(Remembered{model, {model, rows}});
  return [known, parameters](const Eigen::VectorXd& x) {
    Eigen::VectorXd readings =
        Eigen::VectorXd::Constant(static_cast<Eigen::Index>(known->rows.size()), unset);
    try {
      for (std::size_t k = 0; k < parameters.size(); ++k)
        parameters[k].set(known->model, x[static_cast<Eigen::Index>(k)]);
      known->rows.predict(known->model, {readings.data(), known->rows.size()});
    } catch (const std::invalid_argument&) {
      readings.setConstant(unset);
    }
    return readings;
  };
}

}  // namespace raceway::fit
