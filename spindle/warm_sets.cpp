#include "spindle/warm_sets.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <stdexcept>
#include <utility>

#include "friction/contact/contact_law.h"
#include "friction/heat.h"
#include "model/balance.h"
#include "model/heat_split.h"

namespace raceway::spindle {
namespace {

/// Beyond these no balance is known: the range of add_expansion() [K], and what solve_arrangement()
/// takes [m].
constexpr double coldest = 50.0, hottest = 800.0;
constexpr double largest_shift = 1 * mm, largest_elongation = 10 * mm;

bool within_range(const SetsAsked& asked) {
  const auto known = [](double t) { return t >= coldest && t <= hottest; };
  return std::all_of(asked.inner_ring.begin(), asked.inner_ring.end(), known) &&
         std::all_of(asked.outer_ring.begin(), asked.outer_ring.end(), known);
}

bool within_range(const bearing::ArrangementCondition& sets) {
  return std::abs(sets.elongation) <= largest_elongation &&
         std::all_of(sets.shifts.begin(), sets.shifts.end(), [](const bearing::RingShift& s) {
           return std::max({std::abs(s.axial), std::abs(s.radial), std::abs(s.inner_length),
                            std::abs(s.outer_length)}) <= largest_shift;
         });
}

/// Of the oil in a bearing [K].
double oil_temperature(std::size_t bearing, const SetsAsked& asked) {
  return 0.5 * (asked.inner_ring[bearing] + asked.outer_ring[bearing]);
}

void add_heat(const BearingHeat& more, double share, BearingHeat& heat) {
  for (double BearingHeat::*const number :
       {&BearingHeat::inner, &BearingHeat::outer, &BearingHeat::force, &BearingHeat::radial_force,
        &BearingHeat::conductance, &BearingHeat::band})
    heat.*number += share * (more.*number);
}

/// The steps of effects that change the friction moment of a bearing in its set.
model::Steps friction_steps(const model::Model& model) {
  model::Steps steps(model);
  steps.condition.clear();  // the balance of the sets finds the conditions
  return steps;
}

}  // namespace

WarmSets::WarmSets(const model::Model& model, const effects::SpindleCondition& condition)
    : model_(model), steps_(model_), friction_(friction_steps(model_)) {
  has_effects_ =
      !friction_.entry.empty() || !friction_.lubricant.empty() || !friction_.moment.empty();
  has_conditions_ = !steps_.condition.empty();
  const double other = std::clamp(condition.other_preload_feedback, 0.0, 1.0);
  feedback_ = model.spindle->preload_feedback ? 1.0 - other : other;
  if (!balance_.mount(model_, steps_))
    throw std::invalid_argument(
        "arrangement: the bearing sets have no equilibrium at mounting: check the preload and the "
        "bearing data");
  const auto bearings = arrangement().bearings();
  heat_.resize(bearings.size());
  for (const bearing::MountedBearing& m : bearings)
    conduction_.emplace_back(*m.bearing, conductivity_of_element(m.bearing->balls()),
                             model::steel_of_rings.conductivity);
  if (has_effects_)
    for (const bearing::MountedBearing& m : bearings) {
      singles_.push_back(model_);
      singles_.back().shaft.reset();
      singles_.back().spindle.reset();
      singles_.back().bearing = *m.bearing;
    }
  const bearing::ArrangementEquilibrium still = solve_arrangement(arrangement(), {}, model_.solver);
  rest_ = still.report.converged() ? still.position : 0.0;
}

bool WarmSets::find_condition(const bearing::OperatingPoint& point,
                              shaft::ShaftCondition& condition) const {
  if (has_conditions_)
    return balance_.find_condition(model_, steps_, point, {}, std::nullopt, condition);
  condition.sets = {.speed = point.speed, .external_load = point.axial_load};
  condition.bearings.assign(bearings(), {});
  return true;
}

bool WarmSets::set_inputs(const Inputs& inputs) {
  const bearing::OperatingPoint point{.speed = inputs.speed,
                                      .axial_load = inputs.axial_load,
                                      .temperature = arrangement().design().mounting_temperature};
  if (!find_condition(point, speed_)) return false;
  if (speed_.sets.shifts.empty()) speed_.sets.shifts.assign(bearings(), {});
  bearing::ArrangementEquilibrium cold =
      solve_sets(model_, arrangement(), speed_.sets, {&point.temperature, 1},
                 cold_.report.converged() ? &cold_ : nullptr);
  if (!cold.report.converged()) return false;
  inputs_ = inputs;
  cold_ = std::move(cold);
  if (!sets_.report.converged()) sets_ = cold_;
  return true;
}

bool WarmSets::solve(const SetsAsked& asked) {
  if (!within_range(asked)) return false;
  asked_ = speed_;
  bearing::ArrangementCondition& sets = asked_.sets;
  sets.elongation += asked.elongation;
  const double mounted_at = arrangement().design().mounting_temperature;
  std::vector<double> temperatures;
  for (std::size_t k = 0; k < bearings(); ++k) {
    temperatures.push_back(oil_temperature(k, asked));
    const bearing::RingShift warm = thermal_shift(
        *arrangement().bearings()[k].bearing,
        {.inner_ring = asked.inner_ring[k], .outer_ring = asked.outer_ring[k]}, mounted_at);
    bearing::RingShift& shift = sets.shifts[k];
    shift.axial += warm.axial;
    shift.radial += warm.radial;
    shift.inner_length += warm.inner_length;
    shift.outer_length += warm.outer_length;
  }
  if (!within_range(sets)) return false;
  bearing::ArrangementEquilibrium found = solve_sets(model_, arrangement(), sets, temperatures,
                                                     sets_.report.converged() ? &sets_ : &cold_);
  if (!found.report.converged()) return false;
  std::vector<BearingHeat> heat(bearings());
  for (std::size_t k = 0; k < bearings(); ++k) {
    heat[k] = heat_of(k, asked, found);
    if (!more_.empty()) add_heat(more_[k], 1.0, heat[k]);
    if (!std::isfinite(heat[k].power())) return false;
  }
  sets_ = std::move(found);
  heat_ = std::move(heat);
  temperatures_ = asked;
  return true;
}

bool WarmSets::bear(const LoadedShaft* bent) {
  more_.clear();
  more_position_ = more_front_ = more_rear_ = 0.0;
  for (std::size_t k = 0; k < bearings(); ++k) {
    heat_[k] = heat_of(k, temperatures_, sets_);
    if (!bent) continue;
    const UnevenBalls uneven{bent->loads[k], bent->bearings[k]};
    BearingHeat loaded = heat_of(k, temperatures_, sets_, &uneven);
    more_.push_back(loaded);
    add_heat(heat_[k], -1.0, more_.back());
    heat_[k] = loaded;
    if (!std::isfinite(loaded.power())) return false;
  }
  if (!bent) return true;
  more_position_ = bent->position - sets_.position;
  more_front_ = bent->front_force - sets_.front_force;
  more_rear_ = bent->rear_force - sets_.rear_force;
  return true;
}

BearingHeat WarmSets::heat_of(std::size_t k, const SetsAsked& asked,
                              const bearing::ArrangementEquilibrium& sets,
                              const UnevenBalls* uneven) const {
  const bearing::BearingInSet& b = sets.bearings[k];
  BearingHeat heat;
  heat.force = b.axial_load;
  double load = feedback_ * b.axial_load + (1.0 - feedback_) * cold_.bearings[k].axial_load;
  if (uneven) {
    heat.force = uneven->load[0];
    heat.radial_force = std::hypot(uneven->load[1], uneven->load[2]);
    heat.conductance = conduction_[k].conductance(uneven->balls.balls);
    load += heat.force - b.axial_load;
  } else {
    heat.conductance =
        conduction_[k].conductance(b.lost() ? 0.0 : b.ball.inner_load, b.ball.outer_load);
  }
  const double temperature = oil_temperature(k, asked);
  friction::BearingState<double> state = model::bearing_state(model_,
                                                              {.speed = inputs_.speed,
                                                               .axial_load = load,
                                                               .radial_load = heat.radial_force,
                                                               .temperature = temperature},
                                                              nullptr);
  if (model_.law == friction::FrictionLaw::table && model_.table->has_band())
    heat.band = friction::power_loss(model_.law_values.front() * model_.table->half_width(state),
                                     inputs_.speed);
  if (has_effects_) {
    const BearingHeat split = heat_with_effects(k, load, temperature, asked, sets, uneven);
    heat.inner = split.inner, heat.outer = split.outer;
    return heat;
  }
  if (friction::needs_equilibrium(model_.law))
    return heat_of_contacts(k, temperature, sets, uneven, heat);
  state.bearing = arrangement().bearings()[k].bearing.get();
  const friction::BaseMoments<double> base =
      friction::base_moments<double>(model_.law, state, model_.law_values);
  const double share = model_.spindle->inner_heat_share;
  if (std::isfinite(share)) {
    const double power = friction::power_loss(base.load + base.viscous, inputs_.speed);
    heat.inner = share * power, heat.outer = (1.0 - share) * power;
    return heat;
  }
  const bearing::BearingEquilibrium balls = uneven ? uneven->balls : sets.bearing(k, arrangement());
  state.equilibrium = &balls;
  const friction::HeatSplit split =
      friction::split_heat(state, {.load = base.load, .viscous = base.viscous});
  heat.inner = split.inner, heat.outer = split.outer;
  return heat;
}

BearingHeat WarmSets::heat_of_contacts(std::size_t k, double temperature,
                                       const bearing::ArrangementEquilibrium& sets,
                                       const UnevenBalls* uneven, BearingHeat heat) const {
  heat.inner = heat.outer = 0.0;
  const auto add = [&](const bearing::BearingEquilibrium& balls, double weight) {
    friction::BearingState<double> state =
        model::bearing_state(model_, {.speed = inputs_.speed, .temperature = temperature}, &balls);
    state.bearing = arrangement().bearings()[k].bearing.get();
    const friction::HeatSplit split = friction::contact::ring_heat(
        friction::contact::contact_result(state, model_.law_values), inputs_.speed);
    heat.inner += weight * split.inner;
    heat.outer += weight * split.outer;
  };
  if (feedback_ != 0.0) add(uneven ? uneven->balls : sets.bearing(k, arrangement()), feedback_);
  if (feedback_ != 1.0) add(cold_.bearing(k, arrangement()), 1.0 - feedback_);
  const double share = model_.spindle->inner_heat_share;
  if (std::isfinite(share)) {
    const double power = heat.power();
    heat.inner = share * power, heat.outer = (1.0 - share) * power;
  }
  return heat;
}

BearingHeat WarmSets::heat_with_effects(std::size_t k, double load, double temperature,
                                        const SetsAsked& asked,
                                        const bearing::ArrangementEquilibrium& sets,
                                        const UnevenBalls* uneven) const {
  bearing::OperatingPoint alone{
      .speed = inputs_.speed, .axial_load = load, .temperature = temperature};
  if (uneven) alone.radial_load = uneven->load[1], alone.radial_load_z = uneven->load[2];
  model::Steps steps = friction_;
  steps.equilibrium = true;
  // The contacts follow the forces that friction is to follow.
  const bool cold = friction::needs_equilibrium(model_.law) && feedback_ < 0.5;
  auto balls = std::make_shared<const bearing::BearingEquilibrium>(
      cold     ? cold_.bearing(k, arrangement())
      : uneven ? uneven->balls
               : sets.bearing(k, arrangement()));
  const effects::Record record{.inner_ring_temperature = asked.inner_ring[k],
                               .outer_ring_temperature = asked.outer_ring[k]};
  model::RowPredictor row(singles_[k], steps, alone, record, balls, asked_.bearings[k],
                          arrangement().bearings()[k].bearing);
  (void)row.predict(singles_[k], steps);
  const model::FrictionPrediction friction = row.prediction(singles_[k]);
  const double power = friction::power_loss(friction.torque, inputs_.speed);
  BearingHeat heat;
  const double share = model_.spindle->inner_heat_share;
  if (std::isfinite(share)) {
    heat.inner = share * power, heat.outer = (1.0 - share) * power;
    return heat;
  }
  const friction::HeatSplit split = model::heat_split(singles_[k], alone, *balls, friction);
  heat.inner = split.inner, heat.outer = split.outer;
  return heat;
}

}  // namespace raceway::spindle
