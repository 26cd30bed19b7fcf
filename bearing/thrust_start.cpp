#include "bearing/thrust_start.h"

#include <algorithm>
#include <cmath>

namespace raceway::bearing {
namespace {

/// Statics of a ball at a given cotangent of the inner contact angle.
struct Statics {
  bool possible = false;
  double si = 0.0, ci = 1.0, so = 0.0, co = 1.0;
  double inner_length = unset, outer_length = unset;  ///< groove centre to ball centre [m]
};

double norm_of(double a, double b) { return std::sqrt(a * a + b * b); }

double length(double load, double stiffness, double radius) {
  const double root = std::cbrt(load / stiffness);
  return radius + root * root;
}

/// `s` holds the outer angle of a neighbouring cotangent (or an outer angle of zero).
void statics(const BallConstants& c, double thrust, double cotangent, Statics& s) {
  s.possible = false;
  s.si = 1.0 / std::sqrt(1.0 + cotangent * cotangent);
  s.ci = cotangent * s.si;
  double qi = 0.0, qo = 0.0;
  // The speed depends on αo, αo on the speed: a contraction, a few rounds make a good start.
  for (int round = 0; round < 6; ++round) {
    const double before = s.so;
    const double cd = s.ci * s.co + s.si * s.so;
    const double m = cage_speed_ratio(c.race_control, s.ci, s.co, cd, c.diameter_ratio);
    const double fc = c.full_centrifugal * m * m;
    double ti = 0.0;
    if (c.race_control == RaceControl::inner)
      ti = 0.2 * c.full_centrifugal * c.gyroscopic * m * (1.0 - m) * s.si;
    qi = (thrust - ti * s.ci) / s.si;
    if (!(qi > 0.0)) return;
    const double radial = qi * s.ci - ti * s.si + fc;
    double norm;
    if (c.race_control == RaceControl::inner) {
      // P cos αo - R sin αo = To: turn (P, R) back by asin(To/ρ).
      norm = norm_of(thrust, radial);
      if (!(ti < norm)) return;
      const double sin_turn = ti / norm, cos_turn = std::sqrt(1.0 - sin_turn * sin_turn);
      s.so = (thrust * cos_turn - radial * sin_turn) / norm;
      s.co = (radial * cos_turn + thrust * sin_turn) / norm;
    } else {
      const double turned = radial + 0.4 * fc * c.gyroscopic;
      norm = norm_of(thrust, turned);
      s.so = thrust / norm;
      s.co = turned / norm;
    }
    qo = thrust * s.so + radial * s.co;
    if (std::abs(s.so - before) < 1e-4) break;
  }
  if (!(qo > 0.0)) return;
  s.inner_length = length(qi, c.inner_stiffness, c.inner_radius);
  s.outer_length = length(qo, c.outer_stiffness, c.outer_radius);
  s.possible = true;
}

}  // namespace

bool thrust_start(const BallConstants& c, Plane free, double thrust, ThrustStart& start) {
  const auto excess = [&](double cotangent, Statics& s) {
    statics(c, thrust, cotangent, s);
    if (!s.possible) return unset;
    return s.outer_length * s.co + s.inner_length * s.ci - free.radial;
  };
  // From flat contact angles (too long) to steep ones (too short). Under inner control statics may
  // become impossible on the way: then there may be no root.
  Statics s;
  double high = free.radial / std::max(free.axial, 0.01 * free.radial);
  double at_high = excess(high, s);
  for (int i = 0; i < 20 && at_high < 0.0; ++i) at_high = excess(high *= 4.0, s);
  if (!(at_high >= 0.0)) return false;
  double low = high, at_low = at_high;
  for (int i = 0; at_low > 0.0; ++i) {
    if (i == 80) return false;
    high = low;
    at_high = at_low;
    low = low > 0.05 ? low * 0.7 : low - 0.5;
    at_low = excess(low, s);
  }
  if (std::isnan(at_low)) {
    // The edge of what statics allows lies between low and high: look for a root before it.
    for (int i = 0; i < 60 && !(at_low <= 0.0); ++i) {
      const double middle = 0.5 * (low + high);
      const double value = excess(middle, s);
      if (std::isnan(value)) {
        low = middle;
      } else if (value > 0.0) {
        high = middle;
        at_high = value;
      } else {
        low = middle;
        at_low = value;
      }
    }
    if (!(at_low <= 0.0)) return false;
  }
  double cotangent = high;
  for (int i = 0; i < 30; ++i) {
    const double secant = high - at_high * (high - low) / (at_high - at_low);
    cotangent = std::isfinite(secant) ? secant : 0.5 * (low + high);
    const double value = excess(cotangent, s);
    if (std::abs(value) < 1e-4 * free.radial || high - low < 1e-9 * (1.0 + std::abs(high))) break;
    // Illinois: halve the value at the end that stays, so that both ends move.
    if (value > 0.0) {
      high = cotangent;
      at_high = value;
      at_low *= 0.5;
    } else {
      low = cotangent;
      at_low = value;
      at_high *= 0.5;
    }
  }
  if (!s.possible) return false;
  start.ball_centre = {s.outer_length * s.so, s.outer_length * s.co};
  start.axial_displacement = s.outer_length * s.so + s.inner_length * s.si - free.axial;
  return true;
}

bool ball_under_force(const BallConstants& c, Plane force, Plane& groove_centre,
                      Plane& ball_centre) {
  double si = 0.0, ci = 1.0, so = 0.0, co = 1.0, qi = 0.0, qo = 0.0;
  for (int round = 0; round < 12; ++round) {
    const double m =
        cage_speed_ratio(RaceControl::inner, ci, co, ci * co + si * so, c.diameter_ratio);
    const double tau = 0.2 * c.full_centrifugal * c.gyroscopic * m * (1.0 - m);
    const double fc = c.full_centrifugal * m * m;
    const double turned = force.radial + tau;
    const double norm = norm_of(force.axial, turned);
    si = force.axial / norm;
    ci = turned / norm;
    const double radial = force.radial + fc, friction = tau * si;
    const double outer = norm_of(force.axial, radial);
    if (!(friction < outer)) return false;
    const double sin_turn = friction / outer, cos_turn = std::sqrt(1.0 - sin_turn * sin_turn);
    so = (force.axial * cos_turn - radial * sin_turn) / outer;
    co = (radial * cos_turn + force.axial * sin_turn) / outer;
    qi = force.axial * si + force.radial * ci;
    qo = force.axial * so + radial * co;
  }
  if (!(qi > 0.0 && qo > 0.0)) return false;
  const double inner = length(qi, c.inner_stiffness, c.inner_radius);
  const double outer = length(qo, c.outer_stiffness, c.outer_radius);
  ball_centre = {outer * so, outer * co};
  groove_centre = {ball_centre.axial + inner * si, ball_centre.radial + inner * ci};
  return true;
}

}  // namespace raceway::bearing
