#include "model/needs.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "effects/lubricant_drag.h"
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

bool is_met(Need need, const Model& model, const record::Record& record) {
  switch (need) {
    case Need::speed_levels:
      return has_levels(record::speed, record);
    case Need::load_levels:
      return has_levels(record::axial_load, record) || has_levels(record::radial_load, record);
    case Need::preload_levels:
      return has_levels(record::preload, record);
    case Need::viscosity_levels:
      return has_levels(record::temperature, record);
    case Need::time:
      return record.complete(record::time);
    case Need::ring_temperatures:
      return record.complete(record::inner_ring_temperature) &&
             record.complete(record::outer_ring_temperature);
    case Need::loads:
      return model.shaft || every_row_is_loaded(record);  // the sets load each other
    case Need::ball_load_law:
      return model.shaft || needs_equilibrium(model);
    case Need::opposed_sets:
      return model.shaft && !model.shaft->arrangement.design().rear.empty();
    case Need::palmgren_law:
      return model.law != friction::FrictionLaw::skf;
    case Need::cold_friction:
      return model.spindle && !model.spindle->preload_feedback;
    case Need::torque_standard:
      return false;
  }
  return true;
}

std::string first_unmet(const effects::Description& effect, const Model& model,
                        const record::Record& record, bool levels) {
  for (const Need need : effect.needs)
    if (is_for_levels(need) == levels && !is_met(need, model, record))
      return std::string(effects::text(need));
  return {};
}

}  // namespace

std::string ruled_out(const effects::Description& effect, const Model& model) {
  if (effect.works_with(model.supply)) return {};
  return fmt::format("the bearing is lubricated by {}, this needs {}",
                     friction::words(*model.supply), effects::text(effect.supplies));
}

std::string refused_by_law(const effects::Description& effect, const Model& model) {
  if (model.law != friction::FrictionLaw::contact) return {};
  if (!effect.within_contacts.empty())
    return fmt::format("another base law: the contact law has it itself, as {}",
                       effect.within_contacts);
  // Both count what balls push aside.
  if (effect.id == effects::LubricantDrag::id && model.law_values.back() > 0.0)
    return "oil_fraction = 0 under [friction]: the contact law has the drag of the balls itself";
  return {};
}

std::string missing_need(const effects::Description& effect, const Model& model,
                         const record::Record& record) {
  if (std::string why = refused_by_law(effect, model); !why.empty()) return why;
  if (!effect.moves(model.form())) {
    if (effect.of_spindles_alone())
      return "a model of a spindle, with [shaft] and [housing], in which alone it acts";
    if (model.form() == effects::Form::spindle && effect.condition && effect.follows_heat)
      return "a model without temperatures of its own: those of a spindle do this already";
    return model.form() == effects::Form::rig
               ? "axial displacement of a shaft, on which alone it acts"
               : "friction torque, on which alone it acts";
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
