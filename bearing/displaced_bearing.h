#pragma once

#include <vector>

#include "bearing/arrangement_equilibrium.h"
#include "bearing/bearing_equilibrium.h"
#include "bearing/ring_balance.h"

namespace raceway::bearing {

/// Finds the equilibrium of the balls, and the ball forces on the inner ring, for a given
/// displacement of this ring. This class solves the inverse problem of solve_bearing_equilibrium().
/// Use this class for one speed with many displacements and groove shifts. Each solve starts from
/// the previous solution. The bearing must exist as long as the object.
///
/// Domain:   speed >= 0. The grooves may be shifted (RingShift).
/// Accuracy: the imbalance of each ball is at most `options.tolerance` times the sum of its outer
///           contact load and its approximate centrifugal force, or 1e-8 times this sum if rounding
///           stops the iteration. The physics is the same as in solve_bearing_equilibrium(). No
///           ball touches the inner race if the rings of an angular-contact bearing are separated,
///           as in solve_arrangement().
class DisplacedBearing {
 public:
  DisplacedBearing(const Bearing& bearing, double speed, const RingShift& shift = {},
                   const EquilibriumOptions& options = {});

  /// Replaces the shift of the grooves.
  void set_shift(const RingShift& shift);
  /// Finds the equilibrium of the balls at this displacement of the inner ring, defined as in
  /// BearingEquilibrium. The shift of the grooves is added to this displacement. Returns false if
  /// no equilibrium is found for a ball; force and stiffness are then invalid.
  [[nodiscard]] bool hold(const Vector5& displacement);
  /// External forces on the ring that balance the ball forces: F_x, F_y, F_z [N], M_y, M_z [N m].
  [[nodiscard]] const Vector5& force() const { return force_; }
  /// Tangent stiffness ∂force/∂displacement with the balls in equilibrium [SI].
  [[nodiscard]] const Matrix5& stiffness() const { return stiffness_; }
  /// Returns all results at the last displacement. The axial displacement includes the shift, as in
  /// BearingInSet.
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
  /// Ring displacement with the shift; tilts are multiplied by RingPoint::lever [m].
  Vector5 ring_ = Vector5::Zero();
  Vector5 force_ = Vector5::Constant(unset);
  Matrix5 stiffness_ = Matrix5::Constant(unset);
};

/// Returns the equilibrium of each bearing of an arrangement with the full tangent stiffness, front
/// set first. In the frame of a bearing, +x is the direction of its axial load. `equilibrium` must
/// be the solution for `condition`.
[[nodiscard]] std::vector<BearingEquilibrium> bearings_in_set(
    const Arrangement& arrangement, const ArrangementCondition& condition,
    const ArrangementEquilibrium& equilibrium, const EquilibriumOptions& options = {});

}  // namespace raceway::bearing
