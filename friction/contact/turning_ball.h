#pragma once

#include <array>
#include <cmath>

#include "bearing/balls.h"
#include "bearing/bearing.h"
#include "bearing/linear_solve.h"
#include "friction/contact/slip_forces.h"

// Only ball_attitude.cpp uses this header.
namespace raceway::friction::contact {

/// Unknowns of the solver [m/s]: slips v_i and v_o along rolling at the inner and outer contact
/// centre, slip across rolling (equal at both contacts), and the radial component ω_R sin β of the
/// ball rotation times TurningBall::length().
using Slips = std::array<double, 4>;

/// Ball between its two races. From four given slips, the class computes the speeds of the ball and
/// the net forces on the ball.
class TurningBall {
 public:
  TurningBall(const bearing::Bearing& bearing, const bearing::BallEquilibrium& ball, double speed,
              double inertia)
      : speed_(speed) {
    const bearing::BearingGeometry& g = bearing.geometry();
    si_ = std::sin(ball.inner_contact_angle), ci_ = std::cos(ball.inner_contact_angle);
    so_ = std::sin(ball.outer_contact_angle), co_ = std::cos(ball.outer_contact_angle);
    half_ = 0.5 * g.ball_diameter;
    inner_radius_ = 0.5 * g.pitch_diameter - half_ * ci_;
    outer_radius_ = 0.5 * g.pitch_diameter + half_ * co_;
    per_sum_ = 1.0 / (ci_ * outer_radius_ + co_ * inner_radius_);
    couple_ = inertia / half_;
  }

  /// Sets both contacts. length() becomes the mean of their semi-major axes.
  void set_contacts(const SlippingContact& inner, const SlippingContact& outer) {
    inner_ = inner;
    outer_ = outer;
    length_ = 0.5 * (inner.ellipse().semi_major_axis + outer.ellipse().semi_major_axis);
  }
  void smooth(double times) {
    inner_.smooth(times);
    outer_.smooth(times);
  }
  [[nodiscard]] double length() const { return length_; }

  /// Rotation and orbital speed of a ball [rad/s], calculated from its slips:
  ///
  ///   v_i = (ω - ω_m) ρ_i - (D/2)(A cos αi + B sin αi),   ρ_i = (d_m - D cos αi)/2
  ///   v_o = ω_m ρ_o - (D/2)(A cos αo + B sin αo),         ρ_o = (d_m + D cos αo)/2
  ///
  /// v_i and v_o are the slips along rolling (Slips), ω is the shaft speed and ω_m the orbital
  /// speed. D is the ball diameter, d_m the pitch diameter, and αi and αo are the contact angles.
  /// A, B and w_T are the components of the ball rotation, as in BallAttitude.
  struct Speeds {
    double along, across, orbital, cage;  // A, B, w_T, ω_m
  };
  [[nodiscard]] Speeds speeds(const Slips& q) const {
    const double across = q[3] / length_;
    const double inner = speed_ * inner_radius_ - q[0] - half_ * si_ * across;
    const double outer = q[1] + half_ * so_ * across;
    return {.along = (outer_radius_ * inner - inner_radius_ * outer) * per_sum_ / half_,
            .across = across,
            .orbital = -q[2] / half_,
            .cage = (ci_ * outer + co_ * inner) * per_sum_};
  }
  [[nodiscard]] SlipMotion inner_motion(const Slips& q, const Speeds& v) const {
    const double rest = speed_ - v.cage;
    return {q[0], q[2], v.along * ci_ + v.across * si_ + rest * ci_,
            v.along * si_ - v.across * ci_ + rest * si_};
  }
  [[nodiscard]] SlipMotion outer_motion(const Slips& q, const Speeds& v) const {
    return {q[1], q[2], v.along * co_ + v.across * so_ - v.cage * co_,
            v.across * co_ - v.along * so_ + v.cage * so_};
  }

  /// Forces at given slips, with their derivatives for the Newton step.
  struct Look {
    SlipForces inner, outer;
    std::array<double, 4> missing;  ///< net force for each of the four Slips [N]; 0 in equilibrium
    double size;                    ///< shear stress |τ|, integrated over both contacts [N]
    [[nodiscard]] double largest() const {
      double most = 0.0;
      for (const double x : missing) most = std::fmax(most, std::abs(x));
      return most;
    }
    [[nodiscard]] double merit() const {
      double sum = 0.0;
      for (const double x : missing) sum += x * x;
      return sum;
    }
  };

  [[nodiscard]] Look look(const Slips& q) const {
    const Speeds v = speeds(q);
    Look l;
    l.inner = inner_.forces(inner_motion(q, v));
    l.outer = outer_.forces(outer_motion(q, v));
    l.size = l.inner.size + l.outer.size;
    double arm[2][4][4];
    arms(arm);
    for (std::size_t k = 0; k < 4; ++k) {
      l.missing[k] = 0.0;
      for (std::size_t p = 0; p < 4; ++p)
        l.missing[k] += l.inner.force[p] * arm[0][p][k] + l.outer.force[p] * arm[1][p][k];
    }
    l.missing[2] -= couple_ * v.cage * v.across;
    l.missing[3] += couple_ * v.cage * q[2] / length_;
    return l;
  }

  /// Computes the Newton step from the slips `q`. `l` must be the result of look(q).
  [[nodiscard]] Slips step(const Slips& q, const Look& l) const {
    const Speeds v = speeds(q);
    double arm[2][4][4], a[4][4] = {}, b[4];
    arms(arm);
    for (int c = 0; c < 2; ++c) {
      const auto& slope = c == 0 ? l.inner.slope : l.outer.slope;
      double half[4][4];
      for (int p = 0; p < 4; ++p)
        for (int k = 0; k < 4; ++k) {
          half[p][k] = 0.0;
          for (int r = 0; r < 4; ++r) half[p][k] += slope[p][r] * arm[c][r][k];
        }
      for (int j = 0; j < 4; ++j)
        for (int k = 0; k < 4; ++k)
          for (int p = 0; p < 4; ++p) a[j][k] += arm[c][p][j] * half[p][k];
    }
    const std::array<double, 4> cage = cage_slope();
    for (std::size_t k = 0; k < 4; ++k) {
      a[2][k] -= couple_ * cage[k] * v.across;
      a[3][k] += couple_ * cage[k] * q[2] / length_;
      b[k] = -l.missing[k];
    }
    a[2][3] -= couple_ * v.cage / length_;
    a[3][2] += couple_ * v.cage / length_;
    bearing::solve_linear<4>(a, b);
    return {b[0], b[1], b[2], b[3]};
  }

  /// Power taken from the shaft by traction, ω (Σ τ_x ρ_i + Σ τ_x h cos αi + M_s sin αi) with h =
  /// y²/(2 R) and the spin moment M_s of the inner contact [W]. y, R and the stress τ_x along
  /// rolling are explained in slip_forces.h; ω, ρ_i and αi at Speeds.
  [[nodiscard]] double shaft_power(const SlipForces& inner) const {
    return speed_ * (inner.force[0] * inner_radius_ + inner.force[2] * ci_ + inner.force[3] * si_);
  }
  [[nodiscard]] double inner_surface_speed(double cage) const {
    return (speed_ - cage) * inner_radius_;
  }
  [[nodiscard]] double outer_surface_speed(double cage) const { return cage * outer_radius_; }
  /// Slips of a ball that rolls without gyroscopic creep. `pitch` is tan β, where β is the angle
  /// between the rotation axis of the ball and the bearing axis.
  [[nodiscard]] Slips rolling(double pitch) const {
    const double across =
        pitch * rolling_cage_speed(pitch) * outer_radius_ / (half_ * (co_ + pitch * so_));
    Slips q{0.0, 0.0, 0.0, across * length_};
    const Speeds v = speeds(q);
    q[0] = free_rolling(inner_, inner_motion(q, v));
    q[1] = free_rolling(outer_, outer_motion(q, v));
    return q;
  }
  [[nodiscard]] double rolling_cage_speed(double pitch) const {
    const double inner = ci_ + pitch * si_, outer = co_ + pitch * so_;
    return speed_ * inner_radius_ * outer / (inner_radius_ * outer + outer_radius_ * inner);
  }
  /// Returns tan β under outer control.
  [[nodiscard]] double outer_control() const { return so_ / (co_ + half_ / pitch_radius()); }
  /// Returns tan β under inner control.
  [[nodiscard]] double inner_control() const { return si_ / (ci_ - half_ / pitch_radius()); }

 private:
  [[nodiscard]] double pitch_radius() const { return inner_radius_ + half_ * ci_; }
  /// Returns the approximate slip v_x0 along rolling at which the traction force Σ τ_x of a contact
  /// is zero. This slip is not 0, because the differential slip is forward at the ends of the
  /// ellipse.
  static double free_rolling(const SlippingContact& contact, const SlipMotion& motion) {
    const double a = contact.ellipse().semi_major_axis;
    return -0.2 * motion.rolling * a * a / (2.0 * contact.pressed_radius());
  }
  /// Returns the derivatives of the orbital speed ω_m with respect to the four Slips.
  [[nodiscard]] std::array<double, 4> cage_slope() const {
    return {-co_ * per_sum_, ci_ * per_sum_, 0.0,
            half_ * (ci_ * so_ - co_ * si_) * per_sum_ / length_};
  }
  /// Computes the derivatives of the SlipMotion of each contact (0: inner, 1: outer) with respect
  /// to the four Slips.
  void arms(double (&arm)[2][4][4]) const {
    const std::array<double, 4> cage = cage_slope();
    const std::array<double, 4> along{
        -outer_radius_ * per_sum_ / half_, -inner_radius_ * per_sum_ / half_, 0.0,
        -(outer_radius_ * si_ + inner_radius_ * so_) * per_sum_ / length_};
    for (std::size_t k = 0; k < 4; ++k) {
      const double across = k == 3 ? 1.0 / length_ : 0.0;
      arm[0][0][k] = k == 0 ? 1.0 : 0.0;
      arm[1][0][k] = k == 1 ? 1.0 : 0.0;
      arm[0][1][k] = arm[1][1][k] = k == 2 ? 1.0 : 0.0;
      arm[0][2][k] = (along[k] - cage[k]) * ci_ + across * si_;
      arm[0][3][k] = (along[k] - cage[k]) * si_ - across * ci_;
      arm[1][2][k] = (along[k] - cage[k]) * co_ + across * so_;
      arm[1][3][k] = across * co_ - (along[k] - cage[k]) * so_;
    }
  }

  SlippingContact inner_, outer_;
  double speed_, half_, si_, ci_, so_, co_;
  double inner_radius_, outer_radius_, per_sum_;  // ρ_i, ρ_o, 1/(ρ_o cos αi + ρ_i cos αo)
  double couple_;                                 // 2 J/D
  double length_ = unset;
};

}  // namespace raceway::friction::contact
