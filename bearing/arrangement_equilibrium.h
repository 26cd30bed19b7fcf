#pragma once

#include <optional>
#include <span>
#include <vector>

#include "bearing/arrangement.h"
#include "bearing/bearing_equilibrium.h"

namespace raceway::bearing {

/// Shifts of the grooves of one bearing in an arrangement, relative to the mounted state [m].
struct RingShift {
  /// Axial shift of the inner groove relative to the outer groove. A positive shift compresses the
  /// bearing.
  double axial = 0.0;
  double radial = 0.0;  ///< radial growth of the inner groove minus growth of the outer groove
  /// Increase of the distance between inner groove centre and ball centre in the unloaded bearing.
  double inner_length = 0.0;
  /// Increase of the distance between outer groove centre and ball centre in the unloaded bearing.
  double outer_length = 0.0;
  [[nodiscard]] bool operator==(const RingShift&) const = default;
};

/// Operating condition of an arrangement.
struct ArrangementCondition {
  double speed = 0.0;          ///< [rad/s], >= 0
  double external_load = 0.0;  ///< axial load on the shaft, positive towards the tool [N]
  /// Elongation e of the shaft minus elongation of the housing, between the sets [m].
  double elongation = 0.0;
  /// One shift for each bearing, front set first. An empty list means no shift.
  std::vector<RingShift> shifts = {};
  [[nodiscard]] bool operator==(const ArrangementCondition&) const = default;
};

/// Temperatures of an arrangement [K].
struct SetTemperatures {
  double inner_ring = unset, outer_ring = unset;
  double balls = unset;  ///< if unset, the mean of both ring temperatures
  double shaft = unset, housing = unset;
};

/// Groove shifts by free thermal expansion of rings and balls from the mounting temperature T0:
///
///   radial  λ_r ((T_i - T0) R_i - (T_o - T0) R_o)
///   lengths λ_r (T - T0) f D - λ_b (T_b - T0) D/2
///   axial   λ_r ((T_i + T_o)/2 - T0) B D sin α0
///
/// λ_r and λ_b are the thermal expansion coefficients of rings and balls. T_i, T_o and T_b are the
/// temperatures of inner ring, outer ring and balls. T is T_i for `inner_length` and T_o for
/// `outer_length`. f, D, B, R_i, R_o and α0 are explained in BearingGeometry. If rings and balls
/// have the same material and the same temperature, all dimensions of the unloaded bearing change
/// by the same factor.
/// Source: derived. The formulas ignore interference fits and the stiffness of shaft and housing.
[[nodiscard]] RingShift thermal_shift(const Bearing& bearing, const SetTemperatures& temperatures,
                                      double mounting_temperature);

/// Adds thermal expansion to a condition: thermal_shift() of each bearing, and the elongation
///
///   e = L (λ_s (T_s - T0) - λ_h (T_h - T0))
///
/// L is the distance between the sets. λ_s and λ_h are the expansion coefficients of shaft and
/// housing, T_s and T_h are the temperatures of shaft and housing, and T0 is the mounting
/// temperature. Throws std::invalid_argument for a temperature outside 50 to 800 K. Only the
/// temperature of the balls may be missing.
void add_expansion(const Arrangement& arrangement, const SetTemperatures& temperatures,
                   ArrangementCondition& condition);

/// One bearing of a set in equilibrium. All balls of the bearing carry equal loads.
struct BearingInSet {
  double axial_load = unset;  ///< F_i, axial load of this bearing [N], >= 0
  /// Axial compression δ_i, including MountedBearing::offset and RingShift::axial [m].
  double displacement = unset;
  double axial_stiffness = unset;  ///< tangent stiffness of this bearing [N/m]
  BallEquilibrium ball;            ///< equilibrium of the ball at azimuth 0
  /// Rotation of the balls from EquilibriumOptions::rotations. Empty at standstill or if race
  /// control determines the rotation.
  std::optional<GivenRotation> rotation;
  double inner_pressure = 0.0, outer_pressure = 0.0;  ///< largest Hertz pressures [Pa]
  /// Minimum axial load for rolling without skidding, from minimum_load() [N].
  double minimum_load = unset;

  [[nodiscard]] bool lost() const { return !(ball.inner_load > 0.0); }
  [[nodiscard]] bool below_minimum() const { return axial_load < minimum_load; }
};

/// Results for a shaft in equilibrium on its bearing sets. If the solver did not converge, only
/// `report` is set.
struct ArrangementEquilibrium {
  /// Shaft position x [m], positive towards the tool. x is zero in the mounted state.
  double position = unset;
  /// Sum of the axial forces of the front bearings, and sum of the axial forces of the rear
  /// bearings [N]. In tandem, `rear_force` is the spring force.
  double front_force = unset, rear_force = unset;
  double rear_displacement = unset;  ///< δ_r, axial compression of the rear set [m]
  double axial_stiffness = unset;    ///< tangent stiffness of the shaft under external load [N/m]
  std::vector<BearingInSet> bearings;
  SolveReport report;

  /// Returns the equilibrium of bearing i for the friction laws. Only the axial displacement and
  /// the axial stiffness are known. The other displacements are 0, and the other stiffness
  /// components are NaN.
  [[nodiscard]] BearingEquilibrium bearing(std::size_t i, const Arrangement& arrangement) const;
  /// Returns the ball rotation of each bearing, so that another calculation can use the list as
  /// EquilibriumOptions::rotations. The list is empty under race control and at standstill.
  [[nodiscard]] std::vector<GivenRotation> rotations() const;
};

/// Returns `options` for a calculation of bearing i alone: EquilibriumOptions::rotations of the
/// result contains only the rotation of bearing i.
[[nodiscard]] EquilibriumOptions options_of_bearing(const EquilibriumOptions& options,
                                                    std::size_t i);

/// Minimum axial load for rolling without skidding [N]. At this load, the radial component of each
/// inner contact load equals the centrifugal force F_c of the ball. Z is the number of balls, and
/// α0 is the nominal contact angle:
///
///   F_min = Z F_c tan α0
///
/// Source:   derived. The manufacturer GMN gives a minimum spring preload. At the speed limit, this
///           preload is 0.9 to 1.3 F_min for the S series, and 0.5 to 0.8 F_min for series with
///           smaller balls.
[[nodiscard]] double minimum_load(const Bearing& bearing, double centrifugal_force);

/// Finds the shaft position at equilibrium of front set, rear set and external load.
///
/// The solver uses the Newton-Raphson method with analytic derivatives. The unknowns are the
/// position of the shaft, the position of the rear set, and two coordinates of one ball of every
/// bearing, because an axial load loads all balls equally. The iteration starts from `neighbour`,
/// the solution for a similar condition. If there is no `neighbour` or this start fails, the solver
/// starts from the equilibrium at standstill under the full load, and increases the speed. If this
/// also fails, the solver starts from the mounted state, and increases speed, load, elongation and
/// shifts together. The status `no_equilibrium` does not prove that no equilibrium exists. If both
/// sets are unloaded, the position of the shaft is undetermined, and the status is `singular`.
///
/// A bearing without inner contacts carries no load. A state with such a bearing is a valid
/// equilibrium.
/// Domain:   speed >= 0. A state in which a bearing is in tension is not an equilibrium.
/// Accuracy: the imbalance of the forces on the shaft is at most `options.tolerance` times the
///           largest of preload, external load, front force and rear force. If rounding errors stop
///           the iteration, an imbalance of up to ten times this limit is accepted. The tilt of the
///           inner rings is locked at zero. The equations of the balls are the same as in
///           solve_bearing_equilibrium().
/// Throws std::invalid_argument if a value of `condition` is NaN or out of range, or if the number
/// of shifts or rotations differs from the number of bearings.
[[nodiscard]] ArrangementEquilibrium solve_arrangement(
    const Arrangement& arrangement, const ArrangementCondition& condition,
    const EquilibriumOptions& options = {}, const ArrangementEquilibrium* neighbour = nullptr);

/// Solves several conditions one after the other. Each solve starts from the last converged
/// solution. Throws std::invalid_argument for an invalid condition, and if `conditions` and
/// `results` differ in size.
void solve_arrangement(const Arrangement& arrangement,
                       std::span<const ArrangementCondition> conditions,
                       std::span<ArrangementEquilibrium> results,
                       const EquilibriumOptions& options = {});

}  // namespace raceway::bearing
