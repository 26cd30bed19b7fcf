#include "tests/spindle_study/bearing_set.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace spindle_study {
namespace {

constexpr double steel_modulus = 208e9;  // [Pa]
constexpr double steel_poisson = 0.3;
constexpr double ball_density = 7800.0;  // [kg/m³]

/// Complete elliptic integrals of the first and second kind, of the modulus k, by the
/// arithmetic-geometric mean.
struct Elliptic {
  double first, second;
};

Elliptic elliptic(double k) {
  double a = 1.0, b = std::sqrt(1.0 - k * k), c = k, sum = 0.5 * c * c, power = 0.5;
  while (std::fabs(c) > 1e-16) {
    c = 0.5 * (a - b);
    const double mean = 0.5 * (a + b);
    b = std::sqrt(a * b);
    a = mean;
    power *= 2.0;
    sum += power * c * c;
    if (power > 1e9) break;
  }
  const double first = 0.5 * pi / a;
  return {first, first * (1.0 - sum)};
}

/// Ellipse of two steel bodies by Hertz: with the ratio x = a/b of the semi-axes, k² = 1 - 1/x²,
///   F = ((x² + 1) E - 2 K)/((x² - 1) E) = difference/sum of the curvatures,
///   a = (6 x² E Q/(π Σρ E'))^(1/3), b = a/x, δ = K Q-term; E' = E/(1 - ν²) of equal bodies.
Race race_of(double ball_diameter, double conformity, double pitch_diameter, double angle,
             bool is_inner) {
  const double gamma = ball_diameter * std::cos(angle) / pitch_diameter;
  const double rolling = is_inner ? 2.0 * gamma / (1.0 - gamma) : -2.0 * gamma / (1.0 + gamma);
  const double sum = (4.0 - 1.0 / conformity + rolling) / ball_diameter;
  const double wanted = (1.0 / conformity + rolling) / (4.0 - 1.0 / conformity + rolling);
  double low = 1.0 + 1e-9, high = 1e4;
  for (int i = 0; i < 200; ++i) {
    const double x = std::sqrt(low * high);
    const Elliptic e = elliptic(std::sqrt(1.0 - 1.0 / (x * x)));
    const double f = ((x * x + 1.0) * e.second - 2.0 * e.first) / ((x * x - 1.0) * e.second);
    (f < wanted ? low : high) = x;
  }
  const double x = std::sqrt(low * high);
  const Elliptic e = elliptic(std::sqrt(1.0 - 1.0 / (x * x)));
  const double modulus = steel_modulus / (1.0 - steel_poisson * steel_poisson);  // E'
  Race race;
  race.major = std::cbrt(6.0 * x * x * e.second / (pi * sum * modulus));
  race.minor = race.major / x;
  // δ = 3 K Q/(π E' a) for two equal bodies; a of 1 N gives δ of 1 N.
  const double approach = 3.0 * e.first / (pi * modulus * race.major);
  race.stiffness = std::pow(approach, -1.5);
  return race;
}

double hertz(double stiffness, double approach) {
  return approach > 0.0 ? stiffness * approach * std::sqrt(approach) : 0.0;
}

/// Centrifugal force and gyroscopic moment of a ball that rolls without spin at the outer race
/// (Harris, Rolling Bearing Analysis: outer race control).
struct Inertia {
  double force, friction;  // F_c [N]; 2 M_g/D at the outer contact [N]
};

Inertia inertia(const BearingData& d, double speed, double inner_angle, double outer_angle) {
  if (speed == 0.0) return {0.0, 0.0};
  const double g = d.ball_diameter / d.pitch_diameter;
  const double ci = std::cos(inner_angle), si = std::sin(inner_angle);
  const double co = std::cos(outer_angle), so = std::sin(outer_angle);
  const double beta = std::atan2(so, co + g);
  const double tangent = std::tan(beta);
  const double cage = speed * (1.0 - g * ci) / (1.0 + std::cos(inner_angle - outer_angle));
  // Turns against the cage: the moment presses the ball's contact angles apart.
  const double ball =
      -speed / (((co + tangent * so) / (1.0 + g * co) + (ci + tangent * si) / (1.0 - g * ci)) * g *
                std::cos(beta));
  const double mass = ball_density * pi * std::pow(d.ball_diameter, 3) / 6.0;
  const double moment =
      0.1 * mass * d.ball_diameter * d.ball_diameter * ball * cage * std::sin(beta);
  return {0.5 * mass * d.pitch_diameter * cage * cage, 2.0 * moment / d.ball_diameter};
}

}  // namespace

BallBearing::BallBearing(const BearingData& data)
    : data_(data),
      inner_(race_of(data.ball_diameter, data.inner_conformity, data.pitch_diameter,
                     data.contact_angle, true)),
      outer_(race_of(data.ball_diameter, data.outer_conformity, data.pitch_diameter,
                     data.contact_angle, false)) {}

BearingLoad BallBearing::pressed(double axial, double speed, const RingState& rings) const {
  const BearingData& d = data_;
  // Centres of the grooves. A ring grows as a whole; the ball has the mean of both.
  const double growth_i = steel_expansion * rings.inner, growth_o = steel_expansion * rings.outer;
  const double growth_b = 0.5 * (growth_i + growth_o);
  const double li0 = (d.inner_conformity - 0.5) * d.ball_diameter;
  const double lo0 = (d.outer_conformity - 0.5) * d.ball_diameter;
  const double c = std::cos(d.contact_angle), s = std::sin(d.contact_angle);
  const double half_pitch = 0.5 * d.pitch_diameter;
  const double across =
      (half_pitch + li0 * c) * (1.0 + growth_i) - (half_pitch - lo0 * c) * (1.0 + growth_o);
  const double along = (li0 + lo0) * s * (1.0 + growth_b) + axial;
  // Ball centre to groove centre without load: radius of the groove less that of the ball.
  const double li = d.inner_conformity * d.ball_diameter * (1.0 + growth_i) -
                    0.5 * d.ball_diameter * (1.0 + growth_b);
  const double lo = d.outer_conformity * d.ball_diameter * (1.0 + growth_o) -
                    0.5 * d.ball_diameter * (1.0 + growth_b);
  const double distance = std::hypot(along, across);
  const double closed = distance - li - lo;
  if (speed == 0.0) {
    if (closed <= 0.0) return {};
    const double compliance =
        std::pow(inner_.stiffness, -2.0 / 3.0) + std::pow(outer_.stiffness, -2.0 / 3.0);
    const double load = std::pow(closed / compliance, 1.5);
    return {d.ball_count * load * along / distance, load, load};
  }
  // Place of the ball's centre against that of the outer groove (along, across).
  const double thrown = inertia(d, speed, d.contact_angle, d.contact_angle).force;
  const double start =
      lo + 0.5 * std::max(closed, 0.0) + std::pow(thrown / outer_.stiffness, 2.0 / 3.0);
  double x = along * start / distance, y = across * start / distance;
  BearingLoad load;
  double sine = 0.0;
  for (int i = 0; i < 100; ++i) {
    const double ro = std::hypot(x, y), ux = along - x, uy = across - y, ri = std::hypot(ux, uy);
    const double qo = hertz(outer_.stiffness, ro - lo), qi = hertz(inner_.stiffness, ri - li);
    const Inertia f = inertia(d, speed, std::atan2(ux, uy), std::atan2(x, y));
    sine = ux / ri;
    load.inner_contact = qi;
    load.outer_contact = qo;
    const double no = x / ro, mo = y / ro, ni = ux / ri, mi = uy / ri;
    const double rx = qi * ni - qo * no + f.friction * mo;
    const double ry = qi * mi - qo * mo - f.friction * no + f.force;
    const double ko = ro > lo ? 1.5 * outer_.stiffness * std::sqrt(ro - lo) : 0.0;
    const double ki = ri > li ? 1.5 * inner_.stiffness * std::sqrt(ri - li) : 0.0;
    const double to = qo / ro, ti = qi / ri;
    const double axx = ki * ni * ni + ti * mi * mi + ko * no * no + to * mo * mo;
    const double ayy = ki * mi * mi + ti * ni * ni + ko * mo * mo + to * no * no;
    const double axy = (ki - ti) * ni * mi + (ko - to) * no * mo;
    const double det = axx * ayy - axy * axy + 1e-12 * (axx + ayy) * (axx + ayy);
    double dx = (rx * ayy - ry * axy) / det, dy = (ry * axx - rx * axy) / det;
    const double limit = 0.2 * lo, step = std::hypot(dx, dy);
    if (step > limit) {
      dx *= limit / step;
      dy *= limit / step;
    }
    x += dx;
    y += dy;
    if (step < 1e-13 * d.ball_diameter) break;
  }
  load.force = d.ball_count * load.inner_contact * sine;
  return load;
}

double BallBearing::approach_under(double force) const {
  double low = 0.0, high = 0.02 * data_.ball_diameter;
  for (int i = 0; i < 100; ++i) {
    const double middle = 0.5 * (low + high);
    (pressed(middle, 0.0, {}).force < force ? low : high) = middle;
  }
  return 0.5 * (low + high);
}

BearingSet::BearingSet(const BearingData& data, int front_count, int rear_count, double preload)
    : bearing(data),
      front(front_count),
      rear(rear_count),
      front_pressed(bearing.approach_under(preload / front)),
      rear_pressed(bearing.approach_under(preload / rear)) {}

SetState balance(const BearingSet& set, double speed, const std::vector<RingState>& rings,
                 double elongation, double guess) {
  SetState state;
  const auto imbalance = [&](double u) {
    state.position = u;
    state.bearings.clear();
    state.front_force = 0.0;
    double rear = 0.0;
    for (int k = 0; k < set.front + set.rear; ++k) {
      const bool is_front = k < set.front;
      const double pressed = is_front ? set.front_pressed - u : set.rear_pressed + u - elongation;
      state.bearings.push_back(
          set.bearing.pressed(pressed, speed, rings[static_cast<std::size_t>(k)]));
      (is_front ? state.front_force : rear) += state.bearings.back().force;
    }
    return state.front_force - rear;
  };
  // Falls as u grows: bracketed from the guess, then regula falsi with halved ends (Illinois).
  double step = 0.2e-6, low = guess - step, high = guess + step;
  double at_low = imbalance(low), at_high = imbalance(high);
  while (at_low < 0.0 && step < 1e-3) {
    high = low, at_high = at_low;
    low -= step *= 2.0;
    at_low = imbalance(low);
  }
  while (at_high > 0.0 && step < 1e-3) {
    low = high, at_low = at_high;
    high += step *= 2.0;
    at_high = imbalance(high);
  }
  int side = 0;
  for (int i = 0; i < 100 && high - low > 1e-14; ++i) {
    const double middle = at_low > at_high ? (at_low * high - at_high * low) / (at_low - at_high)
                                           : 0.5 * (low + high);
    const double value = imbalance(middle);
    if (std::fabs(value) < 1e-9 * (1.0 + state.front_force)) break;
    if (value > 0.0) {
      low = middle, at_low = value;
      if (side == 1) at_high *= 0.5;
      side = 1;
    } else {
      high = middle, at_high = value;
      if (side == -1) at_low *= 0.5;
      side = -1;
    }
  }
  return state;
}

double contact_conductance(const BallBearing& bearing, const BearingLoad& load,
                           double conductivity) {
  double resistance = 0.0;
  for (const auto& [race, force] : {std::pair(bearing.inner(), load.inner_contact),
                                    std::pair(bearing.outer(), load.outer_contact)}) {
    if (!(force > 0.0)) return 0.0;
    const double a = race.major * std::cbrt(force), b = race.minor * std::cbrt(force);
    const double k = std::sqrt(1.0 - b * b / (a * a));
    resistance += elliptic(k).first / (2.0 * pi * a) * 2.0 / conductivity;
  }
  return bearing.data().ball_count / resistance;
}

}  // namespace spindle_study
