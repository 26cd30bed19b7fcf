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
  /// Outer diameter of the housing around the outer ring [m]; NaN means that the outer ring is
  /// free.
  double housing_diameter = unset;
  double outer_clearance = 0.0;  ///< diametral, between outer ring and housing [m]
  model::SolidMaterial housing = {};
};

/// Temperature rises above the mounting temperature [K].
struct RollerTemperatures {
  double shaft = 0.0, inner_ring = 0.0, outer_ring = 0.0, housing = 0.0;
  double rollers = unset;  ///< NaN: mean of the rings
};

/// Clearance of a cylindrical roller bearing in operation.
struct OperatingClearance {
  double clearance = unset;  ///< diametral clearance s [m]
  /// radial growth u_i from the state in which the clearance is given [m]
  double inner_raceway_growth = 0.0;
  double outer_raceway_growth = 0.0;  ///< radial growth u_o [m]
  PressFit inner_seat, outer_seat;    ///< the outer seat is valid only with a housing
};

/// Returns the operating clearance of a bearing on its seats.
///
///   s = s0 - 2 u_i + 2 u_o - 2 α D ΔT(rollers)
///
/// The growths u_i and u_o come from press_fit(), with each ring as a plain sleeve between its seat
/// and its raceway (d_m ∓ D). With ClearanceState::free, u is the growth relative to the bearing
/// before mounting. With ClearanceState::mounted, u is the growth relative to the cold seat at
/// standstill.
/// Source:   derived; Lamé as in press_fit(), compared with a numerical boundary value solution of
///           the seats.
/// Domain:   the bore must be given. If there is a housing, the outer diameter must also be given.
///           The function throws std::invalid_argument if one of these diameters is missing. The
///           outer ring does not rotate. The deformation of the rings between the rollers and the
///           deformation of the housing are neglected.
[[nodiscard]] OperatingClearance operating_clearance(const bearing::RollerBearing& bearing,
                                                     const RollerSeats& seats, double speed,
                                                     const RollerTemperatures& rises);

/// Returns the interference on the shaft that gives a wanted clearance on the seats, cold and at
/// standstill [m].
///
/// Domain:   the clearance is given before mounting (ClearanceState::free) and is larger than the
///           wanted one; otherwise std::invalid_argument is thrown. Friction and embedding of the
///           seat are neglected.
[[nodiscard]] double interference_for(const bearing::RollerBearing& bearing,
                                      const RollerSeats& seats, double mounted_clearance);

/// Returns the drive-up on a tapered seat for an interference: taper (12 for 1:12) times
/// interference [m].
[[nodiscard]] inline double drive_up(double taper, double interference) {
  return taper * interference;
}

}  // namespace raceway::spindle
