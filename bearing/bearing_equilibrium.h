#pragma once

#include <Eigen/Core>
#include <span>
#include <vector>

#include "bearing/balls.h"
#include "bearing/bearing.h"
#include "bearing/kinematics.h"
#include "bearing/operating_point.h"
#include "bearing/solve.h"

namespace raceway::bearing {

using Vector5 = Eigen::Matrix<double, 5, 1>;
using Matrix5 = Eigen::Matrix<double, 5, 5>;

/// Tilt of the inner ring: locked, as on a rigid shaft, or free to balance the given moments. For a
/// ball bearing, a locked tilt is zero.
enum class Tilt { locked, free };

struct EquilibriumOptions {
  RaceControl race_control = RaceControl::outer;
  Tilt tilt = Tilt::locked;
  bool gyroscopic_moment = true;  ///< false: the moment M_g of the balls is neglected
  double tolerance = 1e-11;   ///< largest accepted imbalance of forces, relative to the load [1]
  int max_iterations = 2000;  ///< limit of the Newton steps, summed over all search stages
  /// Rotations of the balls, used instead of race control. For one bearing, the list has one
  /// rotation for each ball, in the order of azimuth, or one rotation for all balls. For an
  /// arrangement, the list has one rotation for each bearing. If the list is empty, race control
  /// determines the rotations. Balls with equal loads by symmetry need equal rotations. The
  /// rotations are ignored at rest. The array must exist until the solver returns.
  std::span<const GivenRotation> rotations = {};
};

/// Equilibrium of the inner ring under a load. If the solver did not converge, only `report` is
/// set.
struct BearingEquilibrium {
  /// Displacement x, y, z [m], θ_y, θ_z [rad] of the inner ring at the plane of its groove centres.
  /// The displacement is zero in the no-load position at standstill, in which the balls just touch
  /// both races at the nominal contact angle. For a deep-groove bearing (α0 = 0), the displacement
  /// is zero in the centred position.
  Vector5 displacement = Vector5::Constant(unset);
  Balls balls;
  /// Rotation of each ball in balls.distinct(), from EquilibriumOptions::rotations. The list is
  /// empty under race control.
  std::vector<GivenRotation> rotations;
  /// Tangent stiffness ∂(F_x, F_y, F_z, M_y, M_z)/∂displacement [N/m, N/rad, N m/m, N m/rad]. The
  /// matrix is slightly asymmetric at speed, because centrifugal and gyroscopic forces depend on
  /// the displacement.
  Matrix5 stiffness = Matrix5::Constant(unset);
  SolveReport report;

  /// Number of balls without load at the inner contact [1].
  [[nodiscard]] int lost_balls() const;
  /// Returns the speeds of ball k. The speeds follow from the given rotation of the ball or,
  /// without a given rotation, from race control. A ball without inner contact is under outer
  /// control.
  [[nodiscard]] BallSpeeds speeds(std::size_t k, const Bearing& bearing, double speed,
                                  RaceControl race_control) const;
};

/// Finds the displacement of the inner ring at which the balls carry the applied load.
///
/// The Newton-Raphson method calculates the positions of ring and balls together, with analytic
/// derivatives. For symmetric loads, the solver uses one ball (pure thrust) or half of the balls
/// (load in the x-y plane). If the method does not converge from the first starting point, the
/// solver increases the load in steps from pure thrust to the full load, or the speed in steps from
/// standstill to the full speed. Under inner control, the solver also searches for the balls that
/// have lost contact with the inner race. The file equilibrium_search.h states how often the solver
/// does not find an equilibrium. The status is `no_equilibrium` if no load presses the rings
/// together. If no method finds a solution, the status is `no_equilibrium` or gives a numerical
/// reason, such as `iteration_limit`.
///
/// Domain:   speed >= 0. An angular-contact bearing carries axial load only in +x.
/// Accuracy: the residual, relative to the applied load, is at most EquilibriumOptions::tolerance.
///           In practice, the residual is near the rounding error. The model assumes rigid rings,
///           quasi-static motion and the chosen race control. The model ignores the cage, the film
///           and the truncation of the contact ellipse at the edge of the groove.
/// Throws std::invalid_argument for an operating point outside the range of validate(), and for a
/// wrong number of elements in EquilibriumOptions::rotations.
[[nodiscard]] BearingEquilibrium solve_bearing_equilibrium(const Bearing& bearing,
                                                           const OperatingPoint& point,
                                                           const EquilibriumOptions& options = {});

/// Finds the equilibrium from the solution of a neighbouring operating point, for example in a
/// sweep over speed. If this start fails, the solver starts without the neighbour.
[[nodiscard]] BearingEquilibrium solve_bearing_equilibrium(const Bearing& bearing,
                                                           const OperatingPoint& point,
                                                           const EquilibriumOptions& options,
                                                           const BearingEquilibrium& neighbour);

}  // namespace raceway::bearing
