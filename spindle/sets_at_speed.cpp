#include "spindle/sets_at_speed.h"

#include <fmt/format.h>

#include "fit/problem.h"
#include "spindle/warm_rollers.h"
#include "spindle/warm_sets.h"

namespace raceway::spindle {

struct SetsOfSpindle::Parts {
  model::Model model;
  WarmSets sets;
  std::optional<Simulator> simulator;  // made when the first warm state is asked for
  const std::atomic<bool>* cancelled = nullptr;

  explicit Parts(const model::Model& m) : model(m), sets(model, {}) {}
};

SetsOfSpindle::SetsOfSpindle(const model::Model& model) : parts_(std::make_unique<Parts>(model)) {}
SetsOfSpindle::SetsOfSpindle(SetsOfSpindle&&) noexcept = default;
SetsOfSpindle::~SetsOfSpindle() = default;

void SetsOfSpindle::stop_on(const std::atomic<bool>* cancelled) { parts_->cancelled = cancelled; }

const bearing::Arrangement& SetsOfSpindle::arrangement() const {
  return parts_->sets.arrangement();
}

/// The steady temperatures at these inputs.
bool SetsOfSpindle::heat(const Inputs& inputs, SetsAtSpeed& sets) {
  if (!parts_->simulator) parts_->simulator.emplace(parts_->model);
  parts_->simulator->stop_on(parts_->cancelled);
  Report report;
  sets.moment = parts_->simulator->steady(inputs, report);
  sets.status = report.status;
  sets.message = report.message;
  return report.converged();
}

std::vector<double> SetsOfSpindle::clearances(double speed,
                                              const std::optional<Moment>& warm) const {
  std::vector<double> list;
  const std::vector<model::RollerOnShaft>& rollers = parts_->model.spindle->rollers;
  if (rollers.empty()) return list;
  const std::size_t first = arrangement().bearings().size();
  if (warm) {
    for (std::size_t k = first; k < warm->bearings.size(); ++k)
      list.push_back(warm->bearings[k].clearance);
    return list;
  }
  const Layout layout = make_layout(parts_->model, model::Cells::coarse);
  const double cold = arrangement().design().mounting_temperature;
  for (std::size_t k = 0; k < rollers.size(); ++k) {
    WarmRollers seated(parts_->model, rollers[k], layout, layout.bearings[first + k]);
    seated.set_speed(speed);
    list.push_back(
        seated.clearance({.inner_ring = cold, .outer_ring = cold, .shaft = cold, .housing = cold}));
  }
  return list;
}

SetsAtSpeed SetsOfSpindle::at(const Inputs& inputs, bool warm) {
  SetsAtSpeed result;
  if (parts_->cancelled && parts_->cancelled->load()) throw fit::Cancelled();
  if (warm && !heat(inputs, result)) return result;
  result.status = Status::no_equilibrium;
  const std::size_t count = arrangement().bearings().size();
  const double mounted_at = arrangement().design().mounting_temperature;
  SetsAsked asked{.inner_ring = std::vector<double>(count, mounted_at),
                  .outer_ring = std::vector<double>(count, mounted_at)};
  if (warm) {
    for (std::size_t i = 0; i < count; ++i) {
      asked.inner_ring[i] = result.moment->bearings[i].inner_ring_temperature;
      asked.outer_ring[i] = result.moment->bearings[i].outer_ring_temperature;
    }
    asked.elongation = result.moment->elongation;
  }
  result.clearances = clearances(inputs.speed, result.moment);
  if (!parts_->sets.set_inputs(inputs) || !parts_->sets.solve(asked)) {
    result.message = "the bearing sets have no equilibrium";
    return result;
  }
  result.condition = parts_->sets.asked();
  result.equilibrium = parts_->sets.sets();
  const std::vector<bearing::GivenRotation> rotations = result.equilibrium.rotations();
  bearing::EquilibriumOptions options = parts_->model.solver;
  options.rotations = rotations;
  result.bearings = bearings_in_set(arrangement(), result.condition, result.equilibrium, options);
  for (std::size_t i = 0; i < count; ++i)
    if (!result.bearings[i].report.converged()) {
      result.message =
          fmt::format("bearing {} has no stiffness: its balls have no equilibrium", i + 1);
      return result;
    }
  result.status = Status::converged;
  return result;
}

}  // namespace raceway::spindle
