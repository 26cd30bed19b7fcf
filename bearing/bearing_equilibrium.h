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

/// Tilt of the inner ring: held at zero (a shaft does so), or free to carry the given moments.
enum class Tilt { locked, free };

struct EquilibriumOptions {
  RaceControl race_control = RaceControl::outer;
  Tilt tilt = Tilt::locked;
  bool gyroscopic_moment = true;  ///< false leaves M_g out, for comparison
  double tolerance = 1e-11;       ///< on the scaled residual [1]
  int max_iterations = 2000;      ///< Newton steps over all stages
  /// Rotation of the balls where race control does not decide it: one for each ball of the bearing
  /// by azimuth (those that the load leaves alike have the same), or one for all; of an arrangement
  /// one for each bearing. Not looked at at rest. The span must outlive the solve.
  std::span<const GivenRotation> rotations = {};
};

/// The inner-ring displacement that carries a load, and all that follows from it.
/// Only `report` is set unless the solve converged.
struct BearingEquilibrium {
  /// x, y, z [m], θ_y, θ_z [rad] of the inner ring at the plane of its groove centres, counted from
  /// the no-load position at standstill, where balls just touch at the nominal contact angle
  /// (deep groove, α0 = 0: from the centred position).
  Vector5 displacement = Vector5::Constant(unset);
  Balls balls;
  /// Given rotation of each of balls.distinct(); empty under race control.
  std::vector<GivenRotation> rotations;
  /// Tangent stiffness ∂(F_x, F_y, F_z, M_y, M_z)/∂displacement [N/m, N/rad, N m/m, N m/rad]. Not
  /// quite symmetric at speed, since centrifugal and gyroscopic forces follow the motion.
  Matrix5 stiffness = Matrix5::Constant(unset);
  SolveReport report;

  /// Balls that carry nothing at the inner race [1].
  [[nodiscard]] int lost_balls() const;
  /// Ball speeds of ball k: as its rotation was given, else by race control; under outer control
  /// where the inner race is lost.
  [[nodiscard]] BallSpeeds speeds(std::size_t k, const Bearing& bearing, double speed,
                                  RaceControl race_control) const;
};

/// Finds the displacement of the inner ring at which the balls carry the applied load.
///
/// Newton-Raphson on ring and balls together, the two unknowns of each ball eliminated (Schur
/// complement), all derivatives analytic; loads that leave all balls alike, or are mirrored about
/// the x-y plane, are solved with one ball or half of them. Where a cold start fails the solution
/// is followed from the pure thrust case in load and from standstill in speed, and under inner
/// control searched over the balls that may have lost the race (equilibrium_search.h says what that
/// covers). `no_equilibrium` is returned where all this finds nothing, and where no load presses
/// the rings together.
///
/// Domain:   speed >= 0; a bearing with contact angle carries axial load only in +x.
/// Accuracy: `tolerance` on the residual scaled by the applied load, near rounding in practice.
///           Physically: rigid rings, quasi-static, race control as assumed; cage, film and
///           roll-over of the contact ellipse at the groove's edge are left out.
/// Throws std::invalid_argument for an operating point that is not finite.
[[nodiscard]] BearingEquilibrium solve_bearing_equilibrium(const Bearing& bearing,
                                                           const OperatingPoint& point,
                                                           const EquilibriumOptions& options = {});

/// Solves from a neighbour's solution, for sweeps; falls back to the cold start.
[[nodiscard]] BearingEquilibrium solve_bearing_equilibrium(const Bearing& bearing,
                                                           const OperatingPoint& point,
                                                           const EquilibriumOptions& options,
                                                           const BearingEquilibrium& neighbour);

}  // namespace raceway::bearing
