#include "shaft/set_friction.h"

#include <cmath>
#include <stdexcept>
#include <utility>

namespace raceway::shaft {
namespace {

const model::Shaft& shaft_of(const Model& model) {
  if (!model.shaft) throw std::invalid_argument("the model has no shaft");
  return *model.shaft;
}

/// Radial growth that changes the free contact angle as much as a shift does [m].
double equal_growth(const bearing::Bearing& b, const bearing::RingShift& s) {
  const double distance = b.geometry().groove_centre_distance();
  const double radial = distance * std::cos(b.geometry().contact_angle);
  const double length = distance + s.inner_length + s.outer_length;
  return (radial + s.radial) * distance / length - radial;
}

}  // namespace

SetFriction::SetFriction(const Model& model)
    : mounting_temperature_(shaft_of(model).arrangement.design().mounting_temperature),
      steps_(model) {
  steps_.condition.clear();
  steps_.reading.clear();
  const auto bearings = model.shaft->arrangement.bearings();
  for (const bearing::MountedBearing& m : bearings) {
    models_.push_back(model);
    models_.back().shaft.reset();
    models_.back().bearing = *m.bearing;
    models_.back().rig.bearings = static_cast<int>(bearings.size());
    entered_.push_back(m.bearing);
  }
}

void SetFriction::take(const Model& model) {
  const auto bearings = model.shaft->arrangement.bearings();
  for (std::size_t i = 0; i < models_.size(); ++i) {
    models_[i].law_values = model.law_values;
    models_[i].effects = model.effects;
    if (entered_[i] == bearings[i].bearing) continue;
    entered_[i] = bearings[i].bearing;
    models_[i].bearing = *entered_[i];
  }
}

model::RowPredictor SetFriction::row(std::size_t i, const SetState& sets,
                                     const Steps& steps) const {
  const bearing::OperatingPoint alone{.speed = sets.speed,
                                      .axial_load = sets.equilibrium.bearings[i].axial_load,
                                      .temperature = sets.temperature};
  effects::Condition condition = sets.bearings[i];
  if (condition.tilt != 0.0) {
    if (sets.temperatures)
      condition.radial_growth += equal_growth(
          models_[i].bearing,
          thermal_shift(models_[i].bearing, *sets.temperatures, mounting_temperature_));
    return {models_[i], steps, alone, sets.record, nullptr, condition};
  }
  model::Balance balls;
  if (steps.equilibrium)
    balls = std::make_shared<const bearing::BearingEquilibrium>(
        sets.equilibrium.bearing(i, sets.mounted));
  const auto& mounted = sets.mounted.bearings()[i].bearing;
  return {models_[i],
          steps,
          alone,
          sets.record,
          std::move(balls),
          condition,
          mounted == entered_[i] ? nullptr : mounted};
}

model::RowPredictor SetFriction::nothing(std::size_t i) const {
  return {models_[i], steps_, {.speed = unset, .axial_load = unset}, {}};
}

}  // namespace raceway::shaft
