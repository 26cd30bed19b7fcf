#pragma once

#include <vector>

#include "bearing/arrangement_equilibrium.h"
#include "bearing/bearing_equilibrium.h"
#include "bearing/ring_balance.h"

namespace raceway::bearing {

/// Finds the equilibrium of the balls, and the ball forces on the inner ring, for a given
/// displacement of this ring. This is the inverse problem of solve_bearing_equilibrium(). Use one
/// object for many displacements and groove shifts at the same speed. Each solve starts from the
/// previous solution. The object refers to the bearing, so the bearing must exist as long as the
/// object.
///
/// Domain:   speed >= 0. The grooves may be shifted (RingShift).
/// Accuracy: the imbalance of each ball is at most `options.tolerance` times the sum of its load at
///           the outer race and its approximate centrifugal force. If rounding errors stop the
///           iteration, the limit is 1e-8 instead of `options.tolerance`. The equations of the
///           balls are the same as in solve_bearing_equilibrium(). If the rings of an
///           angular-contact bearing are separated, no ball touches the inner race, as in
///           solve_arrangement().
class DisplacedBearing {
 public:
  DisplacedBearing(const Bearing& bearing, double speed, const RingShift& shift = {},
                   const EquilibriumOptions& options = {});

  /// Replaces the shift of the grooves.
  void set_shift(const RingShift& shift);
  /// Finds the equilibrium of the balls at the given displacement of the inner ring (see
  /// BearingEquilibrium::displacement). The shift of the grooves is added to the displacement.
  /// Returns false if no equilibrium is found for a ball; force and stiffness are then invalid.
  [[nodiscard]] bool hold(const Vector5& displacement);
  /// External forces on the ring that balance the ball forces: F_x, F_y, F_z [N], M_y, M_z [N m].
  [[nodiscard]] const Vector5& force() const { return force_; }
  /// Tangent stiffness ∂force/∂displacement with the balls in equilibrium [SI].
  [[nodiscard]] const Matrix5& stiffness() const { return stiffness_; }
  /// Returns all results at the displacement of the last call of hold(). The axial displacement of
  /// the result includes RingShift::axial, as in BearingInSet.
  [[nodiscard]] BearingEquilibrium equilibrium() const;

 private:
  template <BallModel model>
  bool hold_as(const Vector5& scaled);
  template <BallModel model>
  bool balance(Plane centre, InnerContact contact, const GivenRotation* given, Plane& ball) const;
  template <BallModel model>
  bool find(Plane centre, InnerContact contact, const GivenRotation* given, Plane& ball) const;
  template <BallModel model>
  void report_into(BearingEquilibrium& result) const;
  [[nodiscard]] InnerContact contact_at(Plane centre) const;
  [[nodiscard]] Plane resting_ball(Plane centre) const;
  [[nodiscard]] Plane thrown_ball() const;

  const Bearing* bearing_;
  EquilibriumOptions options_;
  RingPoint<double> unshifted_, point_;
  BallCircle circle_;
  BallModel model_;
  double axial_shift_;
  bool one_shoulder_;
  std::vector<Plane> balls_;
  bool placed_ = false;
  /// Displacement of the inner ring plus shift of the grooves. The two tilts are multiplied by
  /// RingPoint::lever [m].
  Vector5 ring_ = Vector5::Zero();
  Vector5 force_ = Vector5::Constant(unset);
  Matrix5 stiffness_ = Matrix5::Constant(unset);
};

/// Returns the equilibrium of each bearing of an arrangement, front set first. The result includes
/// all components of the tangent stiffness. Each result is in the coordinates of its bearing, in
/// which +x is the direction of the axial load. `equilibrium` must be the solution for `condition`.
[[nodiscard]] std::vector<BearingEquilibrium> bearings_in_set(
    const Arrangement& arrangement, const ArrangementCondition& condition,
    const ArrangementEquilibrium& equilibrium, const EquilibriumOptions& options = {});

}  // namespace raceway::bearing
