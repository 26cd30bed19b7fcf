#pragma once

#include <cstddef>
#include <vector>

#include "bearing/ring_system.h"

namespace raceway::bearing {

/// Chooses the balls that keep contact with the inner race under inner control (RaceControl), and
/// computes the positions of the ring and the balls from static equilibrium. A ball that keeps this
/// contact is called a kept ball. A ball without this contact is called a lost ball: it touches
/// only the outer race.
///
/// A kept ball exerts the axial force f and the radial force f_r on the ring. The class assumes
/// that f is a linear function of c = cos(ψ - φ). ψ is the azimuth of the ball, and φ is the
/// argument `direction`: the azimuth of the load, or the opposite azimuth. The axial load and the
/// moment on the ring determine f(c). With locked tilt, the moment is an unknown reaction, and the
/// class finds the moment for which the tilt of the ring is zero. The contact angles of a ball
/// follow from f:
///
///   tan αi = f/(f_r + τ),   τ = Ti/sin αi,   Lo cos αo + Li cos αi = R
///
/// αi and αo are the contact angles, and Ti is the friction force at the inner race. Lo and Li are
/// the distances from the ball centre to the outer and the inner groove centre, and R is the radial
/// distance between the two groove centres. The radial displacement of the ring follows from the
/// condition that Σ f_r c equals the radial load. τ comes from the gyroscopic couple and does not
/// decrease with the load, so only a few balls carry a light load. choose() adds kept balls until
/// no lost ball penetrates the inner race.
class LoadShares {
 public:
  LoadShares(const RingSystem& system, double direction);

  /// Chooses the kept balls, and computes the positions of the ring and the balls. Returns false if
  /// static equilibrium gives no result, for example if the axial load is not above 0.
  [[nodiscard]] bool choose(std::vector<InnerContact>& contacts, RingState& state) const;
  /// Computes the positions of the ring and the balls if the kept balls are given by `contacts`.
  /// Returns false if no ring position is found.
  [[nodiscard]] bool spread(const std::vector<InnerContact>& contacts, RingState& state) const;
  /// Computes the positions like spread(). Returns the largest error of the choice of kept balls in
  /// `contacts` [m]. For a kept ball in tension, the error is the gap at the inner race. For a lost
  /// ball, the error is the depth by which the ball penetrates the inner race. Returns NaN if no
  /// ring position is found.
  [[nodiscard]] double violation(const std::vector<InnerContact>& contacts, RingState& state) const;
  /// Indices of the balls in decreasing order of c = cos(ψ - φ).
  [[nodiscard]] const std::vector<std::size_t>& order() const { return order_; }
  [[nodiscard]] Plane thrown_ball() const { return thrown_; }

 private:
  struct Sums {
    /// Sums of w, w c and w c² over the kept balls; w is RingSystem::weight() of a ball.
    double w = 0.0, c = 0.0, cc = 0.0;
    double most = -2.0, least = 2.0;  ///< largest and smallest c of the kept balls
    void add(double weight, double cosine);
  };
  /// Forces and angles of a kept ball.
  struct Share {
    double radial;      ///< radial force of the ball on the ring [N]
    double inner_load;  ///< load at the inner race, negative in tension [N]
    double outer_load;
    double tau;  ///< Ti/sin αi [N]
    double inner_angle, outer_angle;
    bool found;
    Plane groove, ball;
  };

  /// Residuals of the equilibrium equations of a kept ball, and their derivatives. In equilibrium,
  /// `force` and `radius` are zero. The suffixes _i and _o denote derivatives with respect to the
  /// inner and the outer contact angle [1/rad].
  struct Excess {
    double force, force_i, force_o;     ///< force on the ball, tangential to the outer contact [N]
    double radius, radius_i, radius_o;  ///< Lo cos αo + Li cos αi minus the given R [m]
  };

  /// Computes all other members of `share` from the contact angles in `share`. `axial` is the axial
  /// force f of the ball, and `radius` is the radial distance R of its groove centres.
  [[nodiscard]] Excess set_forces(double axial, double radius, Share& share) const;
  /// Computes forces and angles of a kept ball from its axial force f (`axial`) and the radial
  /// distance R of its groove centres (`radius`). Newton's method finds both contact angles; the
  /// angles in `near` are the start values.
  [[nodiscard]] Share share_at(double axial, double radius, const Share& near) const;
  [[nodiscard]] bool ring_of(const Sums& sums, Vector5& ring) const;
  [[nodiscard]] bool even_ring(const Sums& sums, Vector5& ring) const;
  [[nodiscard]] bool linear_ring(const Sums& sums, double moment, Vector5& ring) const;
  [[nodiscard]] bool untilted_ring(const Sums& sums, Vector5& ring, double& moment) const;
  [[nodiscard]] double axial_share(const Sums& sums, double moment, double c) const;
  [[nodiscard]] Sums sums_of(const std::vector<InnerContact>& contacts) const;
  /// Returns the position in order() of the lost ball that penetrates the inner race most. If no
  /// lost ball penetrates the race, the result is the size of order(). The kept balls are the first
  /// `first` and the last `last` balls in order().
  [[nodiscard]] std::size_t reaching(const Vector5& ring, std::size_t first,
                                     std::size_t last) const;

  const RingSystem& system_;
  BallConstantsOf<double> constants_;
  bool tilts_;
  double cos_direction_, sin_direction_;
  double axial_, radial_, moment_;  ///< applied loads; the moment is divided by system.lever() [N]
  Plane free_, thrown_;
  std::vector<double> along_;  ///< c = cos(ψ - φ) of each ball
  std::vector<std::size_t> order_;
};

}  // namespace raceway::bearing
