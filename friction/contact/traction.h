#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <utility>

#include "friction/contact/ellipse_points.h"
#include "friction/contact/shear.h"
#include "record/units.h"

namespace raceway::friction::contact {

/// Loaded ellipse in which ball and race slide on each other: x along rolling, y across.
struct SlidingEllipse {
  double load = unset;             ///< Q [N]
  double semi_major_axis = unset;  ///< a, along y [m]
  double semi_minor_axis = unset;  ///< b, along x [m]
  /// Coefficient of the differential slip by rolling in a groove, ω_roll/(2 R) [1/(m s)]. ω_roll is
  /// the relative rotation about the y axis, R the radius of the deformed contact across rolling.
  double differential = 0.0;
  double spin = 0.0;  ///< ω_s, rotation about the normal [rad/s]

  [[nodiscard]] double peak_pressure() const {
    return 1.5 * load / (pi * semi_major_axis * semi_minor_axis);
  }
};

/// Sliding velocity at the centre of a contact ellipse: v_x0 along rolling, v_y0 across [m/s].
struct CentreSlip {
  double along = 0.0, across = 0.0;
};

/// Integrals over a contact ellipse (written Σ), and derivatives of the forces with respect to the
/// slip velocity at the centre. τ is the shear stress, v the sliding velocity and p the contact
/// pressure at a point.
struct TractionSums {
  double along = 0.0, across = 0.0;  ///< Σ τ_x, Σ τ_y [N]
  double along_slope = 0.0;          ///< d(Σ τ_x)/dv_x0 [N s/m]
  double mixed_slope = 0.0;          ///< d(Σ τ_x)/dv_y0 = d(Σ τ_y)/dv_x0 [N s/m]
  double across_slope = 0.0;         ///< d(Σ τ_y)/dv_y0 [N s/m]
  double power = 0.0;                ///< Σ τ v [W]
  double spin_moment = 0.0;          ///< Σ (x τ_y - y τ_x) [N m]
  double force = 0.0;                ///< Σ |τ| [N], regardless of direction
  double pressure_slip = 0.0;        ///< Σ p |v| [N m/s]
};

/// Traction of a contact over its whole ellipse, for dry friction or a film.
///
///   v_x = v_x0 + ω_roll y²/(2 R) - ω_s y,   v_y = v_y0 + ω_s x,   τ = τ(p, |v|) v/|v|
///
/// v is the sliding velocity and τ the shear stress at a point. SlidingEllipse describes the
/// rotations ω_roll and ω_s and the radius R. One integral includes spin, differential and
/// gyroscopic sliding, because their friction forces cannot be computed separately and added.
/// Source:   derived. With dry friction, pure spin gives the moment (3/8) μ Q a E(k) of
///           [Harris2006, vol. 2, ch. 5] (μ: friction coefficient, Q: contact load, E(k): see
///           ContactShape). Pure differential sliding gives the power
///           0.1611 μ Q ω_roll a²/(2 R).
/// Domain:   Q > 0; the ellipse is small compared with the radii of ball and groove.
/// Accuracy: with 16 x 32 points of the whole ellipse, the power is accurate to 0.03 % with a film
///           and to 0.2 % with dry friction.
template <class Shear, std::size_t Radial, std::size_t Angles>
class TractionField {
 public:
  TractionField(const SlidingEllipse& ellipse, const Shear& shear) : ellipse_(ellipse) {
    for (std::size_t i = 0; i < Radial; ++i)
      points_[i] = shear.at_pressure(ellipse.peak_pressure() * grid().s[i]);
  }

  /// Returns the integrals over the whole ellipse. If `whole` is false, the function integrates
  /// over one half of the ellipse and doubles the result. v_y0 must then be 0, so that both halves
  /// are symmetric.
  [[nodiscard]] TractionSums sums(const CentreSlip& centre, bool whole) const {
    const TractionSums right = half(centre, 1.0);
    if (whole) return added(right, half(centre, -1.0));
    TractionSums sum = added(right, right);
    sum.across = sum.mixed_slope = 0.0;
    return sum;
  }

  [[nodiscard]] const SlidingEllipse& ellipse() const { return ellipse_; }

 private:
  using Point = decltype(std::declval<const Shear&>().at_pressure(0.0));

  static const EllipsePoints<Radial, Angles>& grid() { return ellipse_points<Radial, Angles>; }

  [[nodiscard]] TractionSums half(const CentreSlip& centre, double side) const {
    const double a = ellipse_.semi_major_axis, b = ellipse_.semi_minor_axis;
    const double spin = ellipse_.spin;
    const double peak = ellipse_.peak_pressure();
    TractionSums total;
    for (std::size_t i = 0; i < Radial; ++i) {
      TractionSums ring;
      for (std::size_t j = 0; j < Angles; ++j) {
        const double x = side * b * grid().radius[i] * grid().cosine[j];
        const double y = a * grid().radius[i] * grid().sine[j];
        const double vx = centre.along + (ellipse_.differential * y - spin) * y;
        const double vy = centre.across + spin * x;
        const double speed2 = vx * vx + vy * vy;
        const ShearResponse r = points_[i](speed2);
        const double turn = speed2 > 0.0 ? (r.tangent - r.secant) / speed2 : 0.0;
        const double speed = std::sqrt(speed2);
        ring.along += r.secant * vx;
        ring.across += r.secant * vy;
        ring.along_slope += r.secant + turn * vx * vx;
        ring.mixed_slope += turn * vx * vy;
        ring.across_slope += r.secant + turn * vy * vy;
        ring.power += r.secant * speed2;
        ring.spin_moment += r.secant * (x * vy - y * vx);
        ring.force += r.secant * speed;
        ring.pressure_slip += speed;
      }
      ring.pressure_slip *= peak * grid().s[i];
      total = added(total, ring, a * b * grid().weight[i]);
    }
    return total;
  }

  static TractionSums added(TractionSums sum, const TractionSums& more, double weight = 1.0) {
    sum.along += weight * more.along;
    sum.across += weight * more.across;
    sum.along_slope += weight * more.along_slope;
    sum.mixed_slope += weight * more.mixed_slope;
    sum.across_slope += weight * more.across_slope;
    sum.power += weight * more.power;
    sum.spin_moment += weight * more.spin_moment;
    sum.force += weight * more.force;
    sum.pressure_slip += weight * more.pressure_slip;
    return sum;
  }

  SlidingEllipse ellipse_;
  std::array<Point, Radial> points_{};
};

/// Traction of a contact, with the slip velocity that the solver found at the contact centre.
struct Traction {
  bool converged = false;
  CentreSlip slip;               ///< v_x0, v_y0 [m/s]
  double power = unset;          ///< friction power [W], >= 0
  double spin_moment = unset;    ///< moment that resists ω_s [N m]
  double mean_friction = unset;  ///< mean friction coefficient Σ |τ|/Q [1]
  double mean_slip = unset;      ///< mean sliding speed Σ p |v|/Q [m/s]
};

/// Value and slope of an increasing function, with a reference value `size`, for example Σ |τ|.
/// find_zero() treats a value as zero if it is small compared with `size`.
struct GrowingValue {
  double value, slope, size;
};
/// Finds the zero of an increasing function by Newton's method inside the bracket from `low` to
/// `high`. `value(v)` returns a GrowingValue. `v` is the start value and receives the zero. A
/// bisection step replaces a Newton step that would leave the bracket, and follows a Newton step
/// that did not halve the function value. The search ends when |value| <= tolerance * size, or when
/// the width of the bracket is at most `tolerance` times the initial width. Returns false if the
/// search has not ended after 200 steps.
template <class Value>
[[nodiscard]] bool find_zero(const Value& value, double low, double high, double& v,
                             double tolerance = 1e-11) {
  const double narrow = tolerance * (high - low);
  double before = std::numeric_limits<double>::infinity();
  for (int step = 0; step < 200; ++step) {
    const GrowingValue f = value(v);
    if (std::abs(f.value) <= tolerance * f.size) return true;
    (f.value > 0.0 ? high : low) = v;
    const double newton = v - f.value / f.slope;
    const double middle = 0.5 * (low + high);
    if (!(high - low > narrow && middle > low && middle < high)) return true;
    const bool good = newton > low && newton < high && std::abs(f.value) < 0.5 * before;
    before = std::abs(f.value);
    v = good ? newton : middle;
  }
  return false;
}

/// Finds the slip v_x0 along rolling at the contact centre for which the contact rolls freely, Σ
/// τ_x = 0. The slip v_y0 across rolling is given. v_x0 lies between -ω_roll a²/(2 R) and 0.
/// Returns false if the search fails.
template <class Field>
[[nodiscard]] bool find_free_rolling(const Field& field, bool whole, CentreSlip& slip) {
  const SlidingEllipse& e = field.ellipse();
  const double range = e.differential * e.semi_major_axis * e.semi_major_axis;
  if (range == 0.0) {
    slip.along = 0.0;  // the friction of both sides of the ellipse cancels
    return true;
  }
  const double low = std::min(-range, 0.0), high = std::max(-range, 0.0);
  if (!(slip.along > low && slip.along < high)) slip.along = -0.2 * range;
  return find_zero(
      [&](double v) {
        const TractionSums s = field.sums({v, slip.across}, whole);
        return GrowingValue{s.along, s.along_slope, s.force};
      },
      low, high, slip.along);
}

template <class Field>
[[nodiscard]] Traction traction_at(const Field& field, const CentreSlip& slip, bool whole,
                                   bool converged) {
  const TractionSums s = field.sums(slip, whole);
  const double load = field.ellipse().load;
  return {.converged = converged,
          .slip = slip,
          .power = s.power,
          .spin_moment = s.spin_moment,
          .mean_friction = s.force / load,
          .mean_slip = s.pressure_slip / load};
}

/// Traction of a freely rolling contact without transverse force, as under race control: Σ τ_x = 0,
/// v_y0 = 0.
template <class Field>
[[nodiscard]] Traction rolling_traction(const Field& field) {
  CentreSlip slip;
  const bool found = find_free_rolling(field, false, slip);
  return traction_at(field, slip, false, found);
}

/// Traction of a freely rolling contact that slips transversely, so that its transverse friction
/// balances a force T: Σ τ_x = 0, Σ τ_y = T [N]. The search does not converge if no slip up to 1
/// km/s balances T. Do not use this function for a ball under race control, because traction in a
/// film cannot balance the gyroscopic moment of such a ball.
template <class Field>
[[nodiscard]] Traction holding_traction(const Field& field, double force) {
  if (force == 0.0) return rolling_traction(field);
  CentreSlip slip;
  bool found = true;
  const double sign = force > 0.0 ? 1.0 : -1.0;
  const auto value = [&](double creep) {
    slip.across = sign * creep;
    found = find_free_rolling(field, true, slip);
    const TractionSums s = field.sums(slip, true);
    // v_x0 depends on v_y0.
    const double follow = s.along_slope > 0.0 ? s.mixed_slope * s.mixed_slope / s.along_slope : 0.0;
    return GrowingValue{sign * s.across - std::abs(force), s.across_slope - follow, s.force};
  };
  double high = 1e-9;
  while (high < 1e3 && value(high).value < 0.0) high *= 4.0;
  if (high >= 1e3) return {};
  double creep = 0.5 * high;
  const bool held = find_zero(value, 0.0, high, creep);
  return traction_at(field, slip, true, found && held);
}

}  // namespace raceway::friction::contact
