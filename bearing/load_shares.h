#pragma once

#include <cstddef>
#include <vector>

#include "bearing/ring_system.h"

namespace raceway::bearing {

/// Finds the balls that can stay in contact with the inner race under inner control, and the
/// positions of ring and balls. The class uses statics only, without a Newton step of the ring.
///
/// The axial force of a kept ball at azimuth ψ is a linear function of c = cos(ψ - φ), where φ is
/// the argument `direction`: the azimuth of the load, or the opposite azimuth. With locked tilt,
/// this function has the slope at which the ring does not tilt. For a kept ball with the axial
/// force f, the radial force f_r and its inner groove centre at radius R:
///
///   tan αi = f/(f_r + τ),   τ = Ti/sin αi,   Lo cos αo + Li cos αi = R
///
/// Lo and Li are the distances from the ball centre to the outer and the inner groove centre. Axial
/// load and moment determine f. The radial displacement follows from the condition that Σ f_r c
/// equals the radial load. The force τ from the gyroscopic couple does not decrease with the load,
/// so only a few balls carry a light load. The number of kept balls is the smallest number for
/// which the ring touches none of the lost balls.
class LoadShares {
 public:
  LoadShares(const RingSystem& system, double direction);

  /// Chooses the kept balls. Returns false if statics cannot decide, for example for a load without
  /// an axial component.
  [[nodiscard]] bool choose(std::vector<InnerContact>& contacts, RingState& state) const;
  /// Computes the positions of the ring and the balls for these contacts. The lost balls lie
  /// against the outer race. Returns false if no ring position is found.
  [[nodiscard]] bool spread(const std::vector<InnerContact>& contacts, RingState& state) const;
  /// Computes the positions like spread(). Returns the largest distance by which a ball violates
  /// the assumed state of its contact [m]; NaN if no ring position is found.
  [[nodiscard]] double violation(const std::vector<InnerContact>& contacts, RingState& state) const;
  /// Indices of the balls in decreasing order of c = cos(ψ - φ).
  [[nodiscard]] const std::vector<std::size_t>& order() const { return order_; }
  [[nodiscard]] Plane thrown_ball() const { return thrown_; }

 private:
  struct Sums {
    double w = 0.0, c = 0.0, cc = 0.0;  ///< sums over kept balls: weight, weight c, weight c²
    double most = -2.0, least = 2.0;    ///< largest and smallest c
    void add(double weight, double cosine);
  };
  /// Forces and angles of a kept ball.
  struct Share {
    double radial;      ///< radial force of the ball on the ring [N]
    double inner_load;  ///< negative if the contact would be in tension [N]
    double outer_load;
    double tau;  ///< Ti/sin αi [N]
    double inner_angle, outer_angle;
    bool found;
    Plane groove, ball;
  };

  /// Residuals of a Share, which are zero in equilibrium, and their derivatives (_i, _o: per radian
  /// of the inner and the outer contact angle).
  struct Excess {
    double force, force_i, force_o;     ///< force on the ball, tangential to the outer contact [N]
    double radius, radius_i, radius_o;  ///< radius of the groove centre minus given radius [m]
  };

  /// Computes the other members of `share` from its contact angles.
  [[nodiscard]] Excess set_forces(double axial, double radius, Share& share) const;
  /// Computes forces and angles of a kept ball that carries this axial force, with its inner groove
  /// centre at this radius, by Newton's method on both contact angles from `near`.
  [[nodiscard]] Share share_at(double axial, double radius, const Share& near) const;
  [[nodiscard]] bool ring_of(const Sums& sums, Vector5& ring) const;
  [[nodiscard]] bool even_ring(const Sums& sums, Vector5& ring) const;
  [[nodiscard]] bool linear_ring(const Sums& sums, double moment, Vector5& ring) const;
  [[nodiscard]] bool untilted_ring(const Sums& sums, Vector5& ring, double& moment) const;
  [[nodiscard]] double axial_share(const Sums& sums, double moment, double c) const;
  [[nodiscard]] Sums sums_of(const std::vector<InnerContact>& contacts) const;
  /// Position in order() of the lost ball that penetrates the inner race most; the size of order()
  /// if no lost ball penetrates the race. The first `first` and the last `last` balls of order()
  /// are kept.
  [[nodiscard]] std::size_t reaching(const Vector5& ring, std::size_t first,
                                     std::size_t last) const;

  const RingSystem& system_;
  BallConstantsOf<double> constants_;
  bool tilts_;
  double cos_direction_, sin_direction_;
  double axial_, radial_, moment_;  ///< applied load; the moment is divided by system.lever() [N]
  Plane free_, thrown_;
  std::vector<double> along_;  ///< c of the balls
  std::vector<std::size_t> order_;
};

}  // namespace raceway::bearing
