#include "spindle/roller_clearance.h"

#include <cmath>
#include <sstream>
#include <stdexcept>

#include "bearing/validation.h"

namespace raceway::spindle {
namespace {

model::SolidMaterial elastic(const bearing::Material& m) {
  model::SolidMaterial solid;
  solid.density = m.density;
  solid.thermal_expansion = m.thermal_expansion;
  solid.elastic_modulus = m.elastic_modulus;
  solid.poissons_ratio = m.poisson_ratio;
  return solid;
}

/// Seats and growth of both raceways at one state.
OperatingClearance grown(const bearing::RollerBearing& bearing, const RollerSeats& seats,
                         double speed, const RollerTemperatures& rises) {
  const bearing::RollerGeometry& g = bearing.geometry();
  const model::SolidMaterial ring = elastic(bearing.rings());
  const double inner_raceway = g.raceway_diameter(bearing::Race::inner);
  const double outer_raceway = g.raceway_diameter(bearing::Race::outer);
  OperatingClearance state;
  state.inner_seat =
      press_fit({seats.shaft_bore, g.bore, seats.shaft, rises.shaft},
                {g.bore, inner_raceway, ring, rises.inner_ring}, seats.inner_interference, speed);
  state.inner_raceway_growth = state.inner_seat.outer_radius_growth;
  state.outer_raceway_growth = 0.5 * outer_raceway * ring.thermal_expansion * rises.outer_ring;
  if (!std::isnan(seats.housing_diameter)) {
    state.outer_seat =
        press_fit({outer_raceway, g.outer_diameter, ring, rises.outer_ring},
                  {g.outer_diameter, seats.housing_diameter, seats.housing, rises.housing},
                  -seats.outer_clearance, 0.0);
    state.outer_raceway_growth = state.outer_seat.inner_radius_growth;
  }
  return state;
}

void require_seats(const bearing::RollerBearing& bearing, const RollerSeats& seats) {
  const bearing::RollerGeometry& g = bearing.geometry();
  bearing::require_between("bore", g.bore, 0.1 * mm, g.raceway_diameter(bearing::Race::inner), mm,
                           "mm");
  bearing::require_between("shaft_bore", seats.shaft_bore, 0.0, 0.99 * g.bore, mm, "mm");
  if (std::isnan(seats.housing_diameter)) return;
  bearing::require_between("outer_diameter", g.outer_diameter,
                           g.raceway_diameter(bearing::Race::outer), 10.0, mm, "mm");
  bearing::require_between("housing_diameter", seats.housing_diameter, 1.001 * g.outer_diameter,
                           100.0, mm, "mm");
}

}  // namespace

OperatingClearance operating_clearance(const bearing::RollerBearing& bearing,
                                       const RollerSeats& seats, double speed,
                                       const RollerTemperatures& rises) {
  require_seats(bearing, seats);
  const bearing::RollerGeometry& g = bearing.geometry();
  OperatingClearance now = grown(bearing, seats, speed, rises);
  if (g.clearance_state == bearing::ClearanceState::mounted) {
    const OperatingClearance mounted = grown(bearing, seats, 0.0, {});
    now.inner_raceway_growth -= mounted.inner_raceway_growth;
    now.outer_raceway_growth -= mounted.outer_raceway_growth;
  }
  const double rollers =
      std::isnan(rises.rollers) ? 0.5 * (rises.inner_ring + rises.outer_ring) : rises.rollers;
  now.clearance = g.radial_clearance - 2.0 * now.inner_raceway_growth +
                  2.0 * now.outer_raceway_growth -
                  2.0 * bearing.rollers().thermal_expansion * g.roller_diameter * rollers;
  return now;
}

double interference_for(const bearing::RollerBearing& bearing, const RollerSeats& seats,
                        double mounted_clearance) {
  require_seats(bearing, seats);
  const bearing::RollerGeometry& g = bearing.geometry();
  const double taken = g.radial_clearance - mounted_clearance;
  if (g.clearance_state != bearing::ClearanceState::free || !(taken >= 0.0)) {
    std::ostringstream text;
    text << "mounted_clearance = " << mounted_clearance / um << " um: must be at most "
         << g.radial_clearance / um
         << " um, the radial_clearance of the bearing; clearance_state must be free";
    throw std::invalid_argument(text.str());
  }
  // A seat that holds is linear in its interference.
  RollerSeats one = seats;
  one.inner_interference = 1 * um;
  return taken / (2.0 * grown(bearing, one, 0.0, {}).inner_raceway_growth) * um;
}

}  // namespace raceway::spindle
