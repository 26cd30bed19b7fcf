#include "friction/contact/ball_attitude.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "bearing/linear_solve.h"

namespace raceway::friction::contact {
namespace {

using bearing::SolveStatus;

constexpr double attitude_tolerance = 1e-11;  // of Σ|τ| [1]
constexpr double attitude_rounding = 1e-8;    // where rounding stops a step short of it [1]
constexpr int most_attitude_steps = 60;
constexpr double film_tolerance = 1e-8;  // on the cage speed that a film was made at [1]
constexpr int most_films = 12;

/// Slip at both centres along rolling, at both across, and ω_R sin β times a length: all [m/s].
using Slips = std::array<double, 4>;

/// One ball between its races.
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

  /// Film and shear of both contacts; `length` makes a speed of ω_R sin β.
  void set_contacts(const SlippingContact& inner, const SlippingContact& outer) {
    inner_ = &inner;
    outer_ = &outer;
    length_ = 0.5 * (inner.ellipse().semi_major_axis + outer.ellipse().semi_major_axis);
  }
  [[nodiscard]] double length() const { return length_; }

  /// Speeds of the ball that has these slips:
  ///
  ///   v_i = (ω - ω_m) ρ_i - (D/2)(A cos αi + B sin αi),   ρ_i = (d_m - D cos αi)/2
  ///   v_o = ω_m ρ_o - (D/2)(A cos αo + B sin αo),         ρ_o = (d_m + D cos αo)/2
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

  /// All forces at given slips, and Newton's step.
  struct Look {
    SlipForces inner, outer;
    std::array<double, 4> missing;  ///< [N]
    double size;                    ///< Σ|τ| of both [N]
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
    l.inner = inner_->forces(inner_motion(q, v));
    l.outer = outer_->forces(outer_motion(q, v));
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

  /// Newton's step from q, where `l` was seen.
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

  /// What traction takes from the shaft, ω (Σ τ_x ρ_i + Σ τ_x h cos αi + M_s sin αi) [W].
  [[nodiscard]] double shaft_power(const SlipForces& inner) const {
    return speed_ * (inner.force[0] * inner_radius_ + inner.force[2] * ci_ + inner.force[3] * si_);
  }
  [[nodiscard]] double inner_surface_speed(double cage) const {
    return (speed_ - cage) * inner_radius_;
  }
  [[nodiscard]] double outer_surface_speed(double cage) const { return cage * outer_radius_; }
  [[nodiscard]] double across_of_pitch(double tangent) const {
    // A = B/tan β from rolling without slip.
    const double si = ci_ + tangent * si_, so = co_ + tangent * so_;
    const double cage = inner_radius_ * so / (inner_radius_ * so + outer_radius_ * si) * speed_;
    return tangent * cage * outer_radius_ / (half_ * so);
  }

 private:
  /// ∂ω_m/∂q.
  [[nodiscard]] std::array<double, 4> cage_slope() const {
    return {-co_ * per_sum_, ci_ * per_sum_, 0.0,
            half_ * (ci_ * so_ - co_ * si_) * per_sum_ / length_};
  }
  /// ∂(motion of contact c)/∂q.
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

  const SlippingContact *inner_ = nullptr, *outer_ = nullptr;
  double speed_, half_, si_, ci_, so_, co_;
  double inner_radius_, outer_radius_, per_sum_;  // ρ_i, ρ_o, 1/(ρ_o cos αi + ρ_i cos αo)
  double couple_;                                 // 2 J/D
  double length_ = unset;
};

/// Newton's method down to the tolerance; false leaves q anywhere.
bool turn(const TurningBall& ball, Slips& q, TurningBall::Look& now, bearing::SolveReport& report) {
  now = ball.look(q);
  for (int i = 0; i < most_attitude_steps; ++i) {
    report.residual = now.largest() / now.size;
    if (report.residual <= attitude_tolerance) return true;
    if (!std::isfinite(report.residual)) {
      report.status = SolveStatus::not_finite;
      return false;
    }
    const Slips s = ball.step(q, now);
    ++report.iterations;
    double fraction = 1.0;
    Slips next;
    TurningBall::Look trial;
    for (int halving = 0;; ++halving) {
      for (std::size_t k = 0; k < 4; ++k) next[k] = q[k] + fraction * s[k];
      trial = ball.look(next);
      if (trial.merit() < (1.0 - 0.1 * fraction) * now.merit() || halving == 8) break;
      fraction *= 0.5;
    }
    if (!(trial.merit() < now.merit())) {
      report.status = SolveStatus::iteration_limit;
      return report.residual <= attitude_rounding;
    }
    q = next;
    now = trial;
  }
  report.status = SolveStatus::iteration_limit;
  return false;
}

Traction traction_of(const SlipForces& f, const SlipMotion& m, double load) {
  return {.converged = true,
          .slip = {m.along, m.across},
          .power = f.power,
          .spin_moment = f.force[3],
          .mean_friction = f.size / load,
          .mean_slip = f.pressure_slip / load};
}

}  // namespace

BallAttitudes::BallAttitudes(const bearing::Bearing& bearing, double speed, const OilState& oil,
                             const ContactLaw& law)
    : bearing_(&bearing),
      speed_(speed),
      inner_(race_friction(bearing, bearing::Race::inner, oil, law, speed)),
      outer_(race_friction(bearing, bearing::Race::outer, oil, law, speed)) {}

BallAttitude BallAttitudes::on_outer_race(const bearing::BallEquilibrium& ball) const {
  const double angle = ball.outer_contact_angle;
  const bearing::BallRotation r = bearing::ball_rotation(
      bearing::RaceControl::outer, angle, angle, bearing_->geometry().diameter_ratio(), turning());
  BallAttitude a;
  a.cage_speed = r.cage_speed;
  a.along = r.along;
  a.across = r.across;
  a.orbital = 0.0;
  const ContactMotion m = ball_motion(bearing_->geometry(), r, angle, angle, turning()).outer;
  const ContactFriction film = outer_.film(ball.outer_load, m, film_speed());
  a.outer = film_traction(outer_.ellipse(film, ball.outer_load, m), outer_.shear(film, m));
  a.outer_slip = {a.outer.slip.along, 0.0, m.rolling, 0.0};
  a.inner.converged = true;
  a.inner.power = a.inner.spin_moment = 0.0;
  a.inner_force = 0.0;
  a.outer_force = ball.outer_friction;
  a.shaft_power = 0.0;
  a.report = {.status = SolveStatus::converged, .iterations = 0, .residual = 0.0};
  return a;
}

BallAttitude BallAttitudes::solve(const bearing::BallEquilibrium& ball,
                                  const BallAttitude* start) const {
  if (!(ball.inner_load > 0.0)) return on_outer_race(ball);
  // At rest nothing turns fast enough for a gyroscopic moment.
  TurningBall turning_ball(*bearing_, ball, turning(),
                           speed_ > 0.0 ? bearing_->ball_inertia() : 0.0);
  BallAttitude a;
  Slips q{};
  double cage = unset;
  if (start && start->report.converged()) {
    cage = start->cage_speed;
  } else {
    const double g = bearing_->geometry().diameter_ratio();
    cage = turning() * bearing::ball_rotation(bearing::RaceControl::outer, ball.inner_contact_angle,
                                              ball.outer_contact_angle, g, 1.0)
                           .cage_speed;
  }
  for (int films = 0; films < most_films; ++films) {
    const ContactMotion mi{.surface_speed = turning_ball.inner_surface_speed(cage)};
    const ContactMotion mo{.surface_speed = turning_ball.outer_surface_speed(cage)};
    const ContactFriction fi = inner_.film(ball.inner_load, mi, film_speed());
    const ContactFriction fo = outer_.film(ball.outer_load, mo, film_speed());
    const SlippingContact ci(inner_.ellipse(fi, ball.inner_load, mi), inner_.shear(fi, mi),
                             inner_.shape.pressed_radius);
    const SlippingContact co(outer_.ellipse(fo, ball.outer_load, mo), outer_.shear(fo, mo),
                             outer_.shape.pressed_radius);
    turning_ball.set_contacts(ci, co);
    if (films == 0) {
      if (start && start->report.converged()) {
        q = {start->inner_slip.along, start->outer_slip.along, start->inner_slip.across,
             start->across * turning_ball.length()};
      } else {
        q = {0.0, 0.0, 0.0, turning_ball.across_of_pitch(std::tan(0.0)) * turning_ball.length()};
      }
    }
    TurningBall::Look look;
    if (!turn(turning_ball, q, look, a.report)) return a;
    const TurningBall::Speeds v = turning_ball.speeds(q);
    const bool same = std::abs(v.cage - cage) <= film_tolerance * turning();
    cage = v.cage;
    if (!same) continue;
    a.cage_speed = v.cage;
    a.along = v.along;
    a.across = v.across;
    a.orbital = v.orbital;
    a.inner_slip = turning_ball.inner_motion(q, v);
    a.outer_slip = turning_ball.outer_motion(q, v);
    a.inner = traction_of(look.inner, a.inner_slip, ball.inner_load);
    a.outer = traction_of(look.outer, a.outer_slip, ball.outer_load);
    a.inner_force = look.inner.force[1];
    a.outer_force = look.outer.force[1];
    a.shaft_power = turning_ball.shaft_power(look.inner);
    a.report.status = SolveStatus::converged;
    return a;
  }
  a.report.status = SolveStatus::iteration_limit;
  return a;
}

BallMotion ball_motion(const bearing::BearingGeometry& g, const BallAttitude& a,
                       const bearing::BallEquilibrium& ball, double speed) {
  // The inner contact angle of a ball off the race is no number.
  const double outer = ball.outer_contact_angle;
  const double inner = ball.inner_load > 0.0 ? ball.inner_contact_angle : outer;
  return ball_motion(g,
                     bearing::BallRotation{.cage_speed = a.cage_speed,
                                           .along = a.along,
                                           .across = a.across,
                                           .inner_spin_speed = std::abs(a.inner_slip.spin),
                                           .outer_spin_speed = std::abs(a.outer_slip.spin)},
                     inner, outer, speed);
}

}  // namespace raceway::friction::contact
