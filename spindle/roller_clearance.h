#pragma once

#include "bearing/roller_bearing.h"
#include "model/spindle.h"
#include "spindle/press_fit.h"

namespace raceway::spindle {

/// Seats of a cylindrical roller bearing.
struct RollerSeats {
  double shaft_bore = 0.0;          ///< diameter [m]; 0 for a solid shaft
  double inner_interference = 0.0;  ///< diametral, cold and at standstill [m]
  model::SolidMaterial shaft = {};
  /// Outer diameter of the housing around the outer ring [m]; NaN: nothing touches the outer ring.
  double housing_diameter = unset;
  double outer_clearance = 0.0;  ///< diametral, of outer ring and housing [m]
  model::SolidMaterial housing = {};
};

/// Rises of temperature over the mounting temperature [K].
struct RollerTemperatures {
  double shaft = 0.0, inner_ring = 0.0, outer_ring = 0.0, housing = 0.0;
  double rollers = unset;  ///< NaN: the mean of the rings
};

/// Clearance of a cylindrical roller bearing in operation.
struct OperatingClearance {
  double clearance = unset;           ///< s, diametral [m]
  double inner_raceway_growth = 0.0;  ///< u_i of the radius, from where the clearance is given [m]
  double outer_raceway_growth = 0.0;  ///< u_o [m]
  PressFit inner_seat, outer_seat;    ///< the outer one where there is a housing
};

/// Operating clearance of a bearing on its seats.
///
///   s = s0 - 2 u_i + 2 u_o - 2 α D ΔT(rollers)
///
/// u by press_fit(): each ring a plain sleeve between its seat and its raceway (d_m ∓ D). With
/// ClearanceState::free u counts from before mounting, with `mounted` from the seat cold and still.
/// Source:   derived; Lamé as press_fit(), held to a boundary value problem of the seats.
/// Domain:   bore given, with a housing the outer diameter too, else std::invalid_argument. The
///           outer ring stands still. Elastic rings between the rollers and a housing that gives
///           way are left out.
[[nodiscard]] OperatingClearance operating_clearance(const bearing::RollerBearing& bearing,
                                                     const RollerSeats& seats, double speed,
                                                     const RollerTemperatures& rises);

/// Interference on the shaft that leaves a clearance on the seats, cold and at standstill [m].
///
/// Domain:   a clearance given before mounting (ClearanceState::free), and above the wanted one:
///           else std::invalid_argument. Friction and embedding of the seat are left out.
[[nodiscard]] double interference_for(const bearing::RollerBearing& bearing,
                                      const RollerSeats& seats, double mounted_clearance);

/// Drive-up on a tapered seat that makes an interference: taper (12 for 1:12) times it [m].
[[nodiscard]] inline double drive_up(double taper, double interference) {
  return taper * interference;
}

}  // namespace raceway::spindle
