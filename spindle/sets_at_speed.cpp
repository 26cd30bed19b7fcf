#include "spindle/sets_at_speed.h"

#include <fmt/format.h>

#include "fit/problem.h"
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
  if (!parts_->sets.set_inputs(inputs) || !parts_->sets.solve(asked)) {
    result.message = "the sets have no balance";
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
      result.message = fmt::format("bearing {} has no stiffness: its balls find no balance", i + 1);
      return result;
    }
  result.status = Status::converged;
  return result;
}

std::vector<double> bearing_places(const model::Spindle& spindle) {
  std::vector<double> places = spindle.front_positions;
  places.insert(places.end(), spindle.rear_positions.begin(), spindle.rear_positions.end());
  return places;
}

}  // namespace raceway::spindle
