#pragma once

#include "bearing/roller_bearing.h"
#include "model/spindle.h"
#include "spindle/press_fit.h"

namespace raceway::spindle {

/// Fits of a cylindrical roller bearing on the shaft and in the housing.
struct RollerSeats {
  double shaft_bore = 0.0;          ///< diameter [m]; 0 for a solid shaft
  double inner_interference = 0.0;  ///< diametral interference, cold and at standstill [m]
  model::SolidMaterial shaft = {};
  /// Outer diameter of the housing around the outer ring [m]; NaN means an outer ring without
  /// housing.
  double housing_diameter = unset;
  double outer_clearance = 0.0;  ///< diametral clearance between outer ring and housing [m]
  model::SolidMaterial housing = {};
};

/// Temperature rises of the parts above the mounting temperature [K].
struct RollerTemperatures {
  double shaft = 0.0, inner_ring = 0.0, outer_ring = 0.0, housing = 0.0;
  double rollers = unset;  ///< if NaN, the mean rise of both rings is used
};

/// Clearance of a cylindrical roller bearing in operation.
struct OperatingClearance {
  double clearance = unset;  ///< diametral clearance s [m]
  /// Radial growth u_i of the inner raceway [m], relative to the state of the bearing that
  /// operating_clearance() names.
  double inner_raceway_growth = 0.0;
  double outer_raceway_growth = 0.0;  ///< radial growth u_o of the outer raceway [m]
  PressFit inner_seat, outer_seat;    ///< `outer_seat` is valid only with a housing
};

/// Returns the diametral clearance s of a roller bearing on its seats, at speed [rad/s] and
/// temperature.
///
///   s = s0 - 2 u_i + 2 u_o - 2 α D ΔT(rollers)
///
/// s0 is RollerGeometry::radial_clearance. D, α and ΔT are diameter, thermal expansion and
/// temperature rise of the rollers. press_fit() gives the growths u_i and u_o of the raceways. Each
/// ring is modelled as a plain sleeve between its seat and its raceway. The inner raceway has the
/// diameter d_m - D, and the outer raceway d_m + D, where d_m is the pitch diameter. With
/// ClearanceState::free, u_i and u_o are relative to the bearing before mounting. With
/// ClearanceState::mounted, u_i and u_o are relative to the mounted cold bearing at rest.
/// Source:   derived from Lamé's equations as in press_fit(), and compared with a numerical
///           solution of the boundary value problem of the seats.
/// Domain:   the bore of the bearing must be given, and with a housing also the outer diameter of
///           the bearing. Throws std::invalid_argument if a required diameter is missing. The outer
///           ring does not rotate. The deformation of the rings between the rollers and the
///           deformation of the housing are neglected.
[[nodiscard]] OperatingClearance operating_clearance(const bearing::RollerBearing& bearing,
                                                     const RollerSeats& seats, double speed,
                                                     const RollerTemperatures& rises);

/// Returns the diametral interference between inner ring and shaft [m] that gives the clearance
/// `mounted_clearance` [m] after mounting. Interference and clearance are cold and at standstill.
///
/// Domain:   the clearance of the bearing is given before mounting (ClearanceState::free) and is
///           not smaller than `mounted_clearance`. Otherwise the function throws
///           std::invalid_argument. Friction and smoothing of the seat surfaces are neglected.
[[nodiscard]] double interference_for(const bearing::RollerBearing& bearing,
                                      const RollerSeats& seats, double mounted_clearance);

/// Returns the axial drive-up on a tapered seat that gives a diametral interference [m]. The
/// drive-up is `taper` times the interference; `taper` is 12 for a taper of 1:12.
[[nodiscard]] inline double drive_up(double taper, double interference) {
  return taper * interference;
}

}  // namespace raceway::spindle
