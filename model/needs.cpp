#include "model/needs.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "model/course.h"
#include "model/steps.h"

namespace raceway::model {
namespace {

using effects::Need;

constexpr double other_level = 0.01;       // of the highest value
constexpr double other_temperature = 1.0;  // [K]

/// Whether values differ by more than these; NaN is passed over.
bool vary(std::span<const double> values, double relative, double absolute) {
  double low = std::numeric_limits<double>::infinity(), high = -low;
  for (const double v : values) {
    low = std::min(low, v);
    high = std::max(high, v);
  }
  return high - low > relative * std::abs(high) + absolute;
}

bool is_for_levels(Need need) {
  return need == Need::speed_levels || need == Need::load_levels || need == Need::preload_levels ||
         need == Need::viscosity_levels;
}

bool every_row_is_loaded(const record::Record& record) {
  for (std::size_t i = 0; i < record.rows(); ++i)
    if (!(record.value(record::axial_load, i) > 0.0) &&
        !(std::abs(record.value(record::radial_load, i)) > 0.0))
      return false;
  return true;
}

bool has_levels(const record::Channel& channel, const record::Record& record) {
  return channel.ratio ? vary(record.values(channel), other_level, 0.0)
                       : vary(record.values(channel), 0.0, other_temperature);
}

bool has_torque_of_sets(const Model& model, const record::Record& record) {
  return model.form() == effects::Form::shaft &&
         measured_of_shaft(record) == record::friction_torque;
}

/// Whether rows of both directions are at least a tenth each.
bool goes_both_ways(const record::Record& record) {
  std::size_t falling = 0, known = 0;
  for (const Course& c : course_of(record)) {
    if (std::isnan(c.direction)) continue;
    ++known;
    falling += c.direction < 0.0 ? 1 : 0;
  }
  return 10 * falling >= known && 10 * (known - falling) >= known && falling > 0;
}

bool is_met(Need need, const Model& model, const record::Record& record) {
  switch (need) {
    case Need::speed_levels:
      return has_levels(record::speed, record);
    case Need::load_levels:
      return has_levels(record::axial_load, record) || has_levels(record::radial_load, record);
    case Need::preload_levels:  // heat varies it, and an external load what the bearings carry
      return model.spindle || has_levels(record::preload, record) ||
             (has_torque_of_sets(model, record) && has_levels(record::axial_load, record));
    case Need::viscosity_levels:
      return has_levels(record::temperature, record);
    case Need::time:
      return record.complete(record::time);
    case Need::ring_temperatures:
      return record.complete(record::inner_ring_temperature) &&
             record.complete(record::outer_ring_temperature);
    case Need::loads:
      return model.shaft || every_row_is_loaded(record);  // the sets load each other
    case Need::several_axial_loads:
      return has_levels(record::axial_load, record);
    case Need::several_bearings:
      return !model.shaft && model.rig.bearings > 1;
    case Need::rising_and_falling:
      return goes_both_ways(record);
    case Need::ball_load_law:
      return model.shaft || needs_equilibrium(model);
    case Need::opposed_sets:
      return model.shaft && !model.shaft->arrangement.design().rear.empty();
    case Need::palmgren_law:
      return model.law != friction::FrictionLaw::skf &&
             model.law != friction::FrictionLaw::roller_skf &&
             model.law != friction::FrictionLaw::table;
    case Need::cold_friction:
      return model.spindle && !model.spindle->preload_feedback;
    case Need::torque_standard:
      return false;
  }
  return true;
}

std::string first_unmet(const effects::Description& effect, const Model& model,
                        const record::Record& record, bool levels) {
  for (const Need need : effect.needs) {
    // What leaves the forces of the sets alone is seen by a law of ball loads alone.
    const bool met = need == Need::ball_load_law && effect.friction_alone
                         ? needs_equilibrium(model)
                         : is_met(need, model, record);
    if (is_for_levels(need) == levels && !met) return std::string(effects::text(need));
  }
  return {};
}

}  // namespace

std::string ruled_out(const effects::Description& effect, const Model& model) {
  if (effect.works_with(model.supply)) return {};
  return fmt::format("the bearing is lubricated by {}, but this effect needs {}",
                     friction::words(*model.supply), effects::text(effect.supplies));
}

namespace {

/// Why cylindrical rollers have no such effect, in words; empty if they do.
std::string refused_by_rollers(const effects::Description& effect) {
  if (!effect.not_for_rollers.empty())
    return fmt::format("a ball bearing, because {}", effect.not_for_rollers);
  if (effect.condition)
    return "a ball bearing, because the effect moves rings against balls in grooves; for "
           "cylindrical rollers, enter the operating clearance as radial_clearance_um";
  return effect.needs_equilibrium ? "a ball bearing, because the formula of the effect is for balls"
                                  : "";
}

/// Why a measured torque has no such effect, in words; empty if it does.
std::string refused_by_table(const effects::Description& effect) {
  if (effect.lubricant || effect.base_law || effect.of_viscous_moment)
    return "another base law, because the program does not change the viscous moment of a friction "
           "table";
  return {};
}

}  // namespace

std::string refused_by_law(const effects::Description& effect, const Model& model) {
  if (model.bearing.rollers()) return refused_by_rollers(effect);
  if (model.law == friction::FrictionLaw::table) return refused_by_table(effect);
  if (model.law != friction::FrictionLaw::contact) return {};
  if (!effect.within_contacts.empty())
    return fmt::format(
        "another base law, because the contact law already includes this effect as {}",
        effect.within_contacts);
  if (effect.within_oil_fraction && model.law_values.back() > 0.0)
    return "oil_fraction = 0 under [friction], because with a larger oil_fraction the contact law "
           "already includes the drag of the balls";
  return {};
}

const record::Channel& measured_of_shaft(const record::Record& record) {
  return record.has(record::friction_torque) && !record.has(record::axial_displacement)
             ? record::friction_torque
             : record::axial_displacement;
}

std::string missing_need(const effects::Description& effect, const Model& model,
                         const record::Record& record) {
  if (!effect.moves(model.form(), measured_of_shaft(record))) {
    if (effect.of_spindles_alone())
      return "a spindle model with [shaft] and [housing], because the effect acts only on spindles";
    if (model.form() == effects::Form::spindle && effect.condition && effect.follows_heat)
      return "a model that does not compute temperatures, because a spindle model already includes "
             "this effect";
    if (effect.reads(record::axial_displacement))
      return "readings of the axial displacement of a shaft, because the effect does not act on "
             "other readings";
    if (model.form() == effects::Form::rig)
      return "a model with an [arrangement], because the effect acts on bearing sets, not on a "
             "bearing on a rig";
    return has_torque_of_sets(model, record)
               ? "a single bearing on a rig, because the bearings of a set share the load"
               : "readings of the friction torque, because the effect does not act on other "
                 "readings";
  }
  if (std::string unmet = first_unmet(effect, model, record, false); !unmet.empty()) return unmet;
  for (const record::Channel* channel : effect.channels)
    if (!record.complete(*channel)) return effects::text(*channel);
  return {};
}

std::string missing_levels(const effects::Description& effect, const Model& model,
                           const record::Record& record) {
  return first_unmet(effect, model, record, true);
}

}  // namespace raceway::model
