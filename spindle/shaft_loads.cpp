#include "spindle/shaft_loads.h"

#include <cmath>

namespace raceway::spindle {

std::vector<ShaftLoad> shaft_loads(const model::Spindle& spindle, const Inputs& inputs) {
  // θ = dv/ds counts rearwards: a force in front of the nose turns the shaft against it.
  std::vector<ShaftLoad> loads{
      {.position = 0.0, .radial = inputs.radial_load, .moment = -inputs.moment}};
  if (!spindle.belt) return loads;
  const model::Belt& belt = *spindle.belt;
  const double force = std::isnan(inputs.belt_force) ? belt.force : inputs.belt_force;
  loads.push_back({.position = belt.position,
                   .radial = force * std::cos(belt.angle),
                   .radial_z = force * std::sin(belt.angle)});
  return loads;
}

std::vector<double> load_places(const model::Spindle& spindle) {
  std::vector<double> places;
  for (const ShaftLoad& load : shaft_loads(spindle, {})) places.push_back(load.position);
  return places;
}

std::vector<double> bearing_places(const model::Spindle& spindle) {
  std::vector<double> places = spindle.front_positions;
  places.insert(places.end(), spindle.rear_positions.begin(), spindle.rear_positions.end());
  return places;
}

ShaftBearings bearings_of_shaft(const model::Spindle& spindle, const bearing::Arrangement& sets) {
  ShaftBearings held{.sets = &sets, .places = bearing_places(spindle)};
  for (const model::RollerOnShaft& r : spindle.rollers)
    held.rollers.push_back({&r.bearing, r.position});
  return held;
}

std::vector<double> beam_places(const model::Spindle& spindle) {
  std::vector<double> places = bearing_places(spindle);
  for (const model::RollerOnShaft& r : spindle.rollers) places.push_back(r.position);
  for (const double p : load_places(spindle)) places.push_back(p);
  return places;
}

}  // namespace raceway::spindle
