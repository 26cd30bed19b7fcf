#include "spindle/warm_rollers.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "friction/roller_friction.h"
#include "spindle/bearing_conduction.h"

namespace raceway::spindle {

WarmRollers::WarmRollers(const model::Model& model, const model::RollerOnShaft& rollers,
                         const Layout& layout, const BearingPlace& place)
    : bearing_(rollers),
      lubricant_(model.lubricant),
      seats_{.shaft_bore = 2.0 * place.seat_bore,
             .inner_interference = place.inner_interference,
             .shaft = layout.material(place.shaft_below),
             .housing_diameter = 2.0 * place.housing_outer,
             .outer_clearance = place.outer_clearance,
             .housing = layout.material(place.housing_above)},
      mounted_at_(model.shaft->arrangement.design().mounting_temperature),
      roller_conductivity_(conductivity_of_element(rollers.bearing.rollers())) {}

double WarmRollers::clearance(const RollersAsked& asked) const {
  return operating_clearance(bearing_.bearing, seats_, speed_,
                             {.shaft = asked.shaft - mounted_at_,
                              .inner_ring = asked.inner_ring - mounted_at_,
                              .outer_ring = asked.outer_ring - mounted_at_,
                              .housing = asked.housing - mounted_at_})
      .clearance;
}

void WarmRollers::take(const bearing::RollerEquilibrium& rollers) {
  taken_ = rollers;
  inner_sum_ = rollers.inner_sum(), outer_sum_ = rollers.outer_sum();
  conductance_ = friction::roller_conductance(bearing_.bearing, rollers, roller_conductivity_,
                                              model::steel_of_rings.conductivity);
}

BearingHeat WarmRollers::heat(const RollersAsked& asked) const {
  BearingHeat heat;
  heat.radial_force = std::hypot(taken_.load[0], taken_.load[1]);
  heat.clearance = clearance(asked);
  heat.conductance = conductance_;
  // No roller pulls.
  const double more =
      std::max(taken_.sum_by_clearance * (heat.clearance - taken_.clearance), -inner_sum_);
  const friction::RollerState state{.bearing = &bearing_.bearing,
                                    .counted = bearing_.counted,
                                    .speed = speed_,
                                    .radial_load = heat.radial_force,
                                    .inner_sum = inner_sum_ + more,
                                    .outer_sum = outer_sum_ + more,
                                    .kinematic_viscosity = lubricant_.kinematic_viscosity(
                                        0.5 * (asked.inner_ring + asked.outer_ring))};
  const friction::HeatSplit split = friction::split_heat(
      state, friction::roller_moments(friction::FrictionLaw::roller_palmgren, state,
                                      std::array{bearing_.f0, bearing_.f1}));
  heat.inner = split.inner, heat.outer = split.outer;
  return heat;
}

}  // namespace raceway::spindle
