#pragma once

#include <vector>

#include "bearing/arrangement_equilibrium.h"
#include "bearing/bearing_equilibrium.h"
#include "bearing/ring_balance.h"

namespace raceway::bearing {

/// One bearing whose inner ring is held: the balls find their places between the grooves, and what
/// they press on the ring with follows. The other way round than solve_bearing_equilibrium().
/// For one speed and for many displacements and states of the rings; each is solved from the one
/// before it. Keeps a reference to the bearing.
///
/// Domain:   speed >= 0; grooves that a shift has moved, see RingShift.
/// Accuracy: `options.tolerance` on the balance of each ball, relative to what presses on it.
///           Physically as solve_bearing_equilibrium(). An angular-contact bearing whose rings
///           have come apart touches nothing, as in solve_arrangement().
class DisplacedBearing {
 public:
  DisplacedBearing(const Bearing& bearing, double speed, const RingShift& shift = {},
                   const EquilibriumOptions& options = {});

  /// Moves the rings to another state of the same bearing.
  void set_shift(const RingShift& shift);
  /// Balances the balls at this displacement of the inner ring, counted as in BearingEquilibrium;
  /// the shift comes on top. False where a ball finds no balance: force and stiffness are not
  /// valid then.
  [[nodiscard]] bool hold(const Vector5& displacement);
  /// F_x, F_y, F_z [N], M_y, M_z [N m] that hold the ring against its balls.
  [[nodiscard]] const Vector5& force() const { return force_; }
  /// ∂force/∂displacement, the balls following.
  [[nodiscard]] const Matrix5& stiffness() const { return stiffness_; }
  /// All of it at the last displacement, the axial one with the shift as BearingInSet has it.
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
  Vector5 ring_ = Vector5::Zero();  ///< tilts times the lever, shift included [m]
  Vector5 force_ = Vector5::Constant(unset);
  Matrix5 stiffness_ = Matrix5::Constant(unset);
};

/// The bearings of an arrangement in balance with their whole tangent stiffness, in the frame of
/// each: +x where its inner ring is pressed. Front set first. `condition` belongs to the balance.
[[nodiscard]] std::vector<BearingEquilibrium> bearings_in_set(
    const Arrangement& arrangement, const ArrangementCondition& condition,
    const ArrangementEquilibrium& equilibrium, const EquilibriumOptions& options = {});

}  // namespace raceway::bearing
