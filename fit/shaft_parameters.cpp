#include "fit/shaft_parameters.h"

#include <algorithm>
#include <stdexcept>
#include <utility>

namespace raceway::fit {

namespace {

/// Whether one bearing, that of the model, stands in all places of the arrangement.
bool one_bearing(const Shaft& shaft) {
  const auto bearings = shaft.arrangement.bearings();
  return !shaft.own_bearings &&
         std::all_of(bearings.begin(), bearings.end(), [&](const bearing::MountedBearing& b) {
           return b.bearing == bearings.front().bearing;
         });
}

void set_bearing(Model& model, const bearing::BearingGeometry& geometry) {
  bearing::ArrangementDesign design = model.shaft->arrangement.design();
  const auto changed = std::make_shared<const bearing::Bearing>(geometry, model.bearing.balls(),
                                                                model.bearing.rings());
  for (auto* set : {&design.front, &design.rear})
    for (bearing::MountedBearing& m : *set) m.bearing = changed;
  model.shaft->arrangement = bearing::Arrangement(std::move(design));
  model.bearing = *changed;
}

}  // namespace

std::vector<ShaftParameter> shaft_parameters(const Model& model) {
  std::vector<ShaftParameter> list;
  if (!model.shaft) return list;
  if (std::holds_alternative<bearing::PreloadForce>(model.shaft->arrangement.design().preload))
    list.push_back({ShaftNumber::preload, "preload_N", "N", 0.001, 1e8});
  if (!one_bearing(*model.shaft)) return list;
  const bearing::BearingGeometry& g = model.bearing.geometry();
  list.push_back({ShaftNumber::inner_conformity, "inner_conformity", "1", 0.5005, 0.7});
  list.push_back({ShaftNumber::outer_conformity, "outer_conformity", "1", 0.5005, 0.7});
  if (g.inner_conformity == g.outer_conformity)
    list.push_back({ShaftNumber::conformity, "conformity", "1", 0.5005, 0.7});
  if (g.contact_angle > 0.0)
    list.push_back({ShaftNumber::contact_angle, "contact_angle_deg", "deg", 1.0, 65.0});
  return list;
}

double shaft_value(const Model& model, ShaftNumber number) {
  const bearing::BearingGeometry& g = model.bearing.geometry();
  switch (number) {
    case ShaftNumber::preload:
      return std::get<bearing::PreloadForce>(model.shaft->arrangement.design().preload).force;
    case ShaftNumber::inner_conformity:
    case ShaftNumber::conformity:
      return g.inner_conformity;
    case ShaftNumber::outer_conformity:
      return g.outer_conformity;
    case ShaftNumber::contact_angle:
      return g.contact_angle / degree;
    case ShaftNumber::none:
      break;
  }
  return unset;
}

void set_shaft_value(Model& model, ShaftNumber number, double value) {
  if (value == shaft_value(model, number)) return;
  if (number == ShaftNumber::preload) {
    bearing::ArrangementDesign design = model.shaft->arrangement.design();
    design.preload = bearing::PreloadForce{value};
    model.shaft->arrangement = bearing::Arrangement(std::move(design));
    return;
  }
  bearing::BearingGeometry g = model.bearing.geometry();
  if (number == ShaftNumber::inner_conformity || number == ShaftNumber::conformity)
    g.inner_conformity = value;
  if (number == ShaftNumber::outer_conformity || number == ShaftNumber::conformity)
    g.outer_conformity = value;
  if (number == ShaftNumber::contact_angle) g.contact_angle = value * degree;
  set_bearing(model, g);
}

}  // namespace raceway::fit
