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

/// Tilt of the inner ring: locked at zero, as on a rigid shaft, or free to balance the given
/// moments.
enum class Tilt { locked, free };

struct EquilibriumOptions {
  RaceControl race_control = RaceControl::outer;
  Tilt tilt = Tilt::locked;
  bool gyroscopic_moment = true;  ///< false omits the moment M_g of the balls, for comparison
  double tolerance = 1e-11;       ///< largest accepted imbalance, relative to the load [1]
  int max_iterations = 2000;      ///< limit of the Newton steps, summed over all search stages
  /// Rotations of the balls, used instead of race control: one for each ball, in the order of
  /// azimuth, or one for all balls. If empty, race control determines the rotations. Balls that are
  /// equal by symmetry need equal rotations. An arrangement needs one rotation for each bearing. At
  /// rest the rotations are ignored. The array must exist until the solve ends.
  std::span<const GivenRotation> rotations = {};
};

/// Equilibrium of the inner ring under a load. If the solve did not converge, only `report` is set.
struct BearingEquilibrium {
  /// Displacement x, y, z [m], θ_y, θ_z [rad] of the inner ring at the plane of its groove centres,
  /// measured from the no-load position at standstill, where the balls just touch at the nominal
  /// contact angle (deep groove, α0 = 0: from the centred position).
  Vector5 displacement = Vector5::Constant(unset);
  Balls balls;
  /// Rotation of each ball in balls.distinct(), from EquilibriumOptions::rotations; empty under
  /// race control.
  std::vector<GivenRotation> rotations;
  /// Tangent stiffness ∂(F_x, F_y, F_z, M_y, M_z)/∂displacement [N/m, N/rad, N m/m, N m/rad]. The
  /// matrix is slightly asymmetric at speed, because centrifugal and gyroscopic forces depend on
  /// the displacement.
  Matrix5 stiffness = Matrix5::Constant(unset);
  SolveReport report;

  /// Number of balls without inner contact load [1].
  [[nodiscard]] int lost_balls() const;
  /// Returns the speeds of ball k: from its given rotation, or by race control if no rotation is
  /// given. A ball without inner contact is treated as under outer control.
  [[nodiscard]] BallSpeeds speeds(std::size_t k, const Bearing& bearing, double speed,
                                  RaceControl race_control) const;
};

/// Finds the displacement of the inner ring at which the balls carry the applied load.
///
/// The Newton-Raphson method solves for ring and balls together. The two unknowns of each ball are
/// eliminated, and all derivatives are analytic. For symmetric loads, the solver uses one ball
/// (thrust) or half of the balls (load in the x-y plane). If a direct start fails, the solver
/// follows the solution from pure thrust to the full load, and from standstill to the full speed.
/// Under inner control, the solver also searches for the balls that have lost contact with the
/// inner race. equilibrium_search.h gives the share of missed equilibria. The status is
/// `no_equilibrium` if no load presses the rings together. If no method finds a solution, the
/// status is `no_equilibrium` or gives a numerical reason, such as `iteration_limit`.
///
/// Domain:   speed >= 0. An angular-contact bearing carries axial load only in +x.
/// Accuracy: the residual, relative to the applied load, is at most `tolerance`; in practice the
///           residual is near the rounding error. The model assumes rigid rings, quasi-static
///           motion and the chosen race control. The model ignores the cage, the film and the
///           truncation of the contact ellipse at the edge of the groove.
/// Throws std::invalid_argument for an operating point outside the range of validate().
[[nodiscard]] BearingEquilibrium solve_bearing_equilibrium(const Bearing& bearing,
                                                           const OperatingPoint& point,
                                                           const EquilibriumOptions& options = {});

/// Finds the equilibrium from the solution of a neighbouring point, for sweeps. If this start
/// fails, the solver starts without the neighbour.
[[nodiscard]] BearingEquilibrium solve_bearing_equilibrium(const Bearing& bearing,
                                                           const OperatingPoint& point,
                                                           const EquilibriumOptions& options,
                                                           const BearingEquilibrium& neighbour);

}  // namespace raceway::bearing
