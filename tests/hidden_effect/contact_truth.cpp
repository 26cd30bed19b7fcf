#include "tests/hidden_effect/contact_truth.h"

#include <algorithm>
#include <array>
#include <boost/math/tools/roots.hpp>
#include <cmath>
#include <cstdint>
#include <numbers>

namespace hidden_effect {
namespace {

using std::numbers::pi;

// In SI from here on.
constexpr double roughness = 0.05e-6;  // of race and ball together
constexpr double friction_of_asperities = 0.10;
constexpr double limit_of_film = 0.06;  // shear stress over pressure
constexpr double eyring = 5e6;
constexpr double conductivity = 0.13;

double density(double celsius) { return 880.0 * (1.0 - 6.5e-4 * (celsius - 15.0)); }

/// The oil at one temperature.
struct Oil {
  double eta, alpha, beta;

  Oil(const Bearing& bearing, double celsius) {
    const auto thickness = [&](double at) { return 1e-6 * bearing.viscosity(at) * density(at); };
    eta = thickness(celsius);
    alpha = 9.904e-9 * std::pow(bearing.viscosity(celsius), 0.139);
    constexpr double h = 0.05;
    beta = -std::log(thickness(celsius + h) / thickness(celsius - h)) / (2.0 * h);
  }

  /// Roelands.
  [[nodiscard]] double under(double pressure) const {
    const double L = std::log(eta) + 9.67, Z = alpha * 1.96e8 / L;
    return eta * std::exp(L * (std::pow(1.0 + pressure / 1.96e8, Z) - 1.0));
  }
};

/// A race's contact at one load, and how ball and race move there.
struct Pressed {
  double load, a, b, modulus;    // E' = 2/(sum of compliances)
  double along, across, second;  // R_x, R_z, E(e)
  double speed, rolling, spin;   // u, turning about the tangent, about the normal
  double conformity, diameter;
};

/// Power of the slip in the ellipse, its resultant along rolling being zero.
double sliding_power(const Pressed& c, const Oil& oil, double film, double asperities) {
  constexpr int strips = 20, points = 8;
  const double p0 = 1.5 * c.load / (pi * c.a * c.b);
  const double bend = c.rolling / (4.0 * c.conformity * c.diameter / (2.0 * c.conformity + 1.0));
  const double small = 1e-6 * c.speed;
  struct Spot {
    double v_along, v_across, area, pressure, thinner;
  };
  std::array<Spot, strips * points> spots{};
  for (int i = 0; i < strips; ++i) {
    // Across rolling and along it by sines, which lie denser at the rim.
    const double t = pi * ((i + 0.5) / strips - 0.5);
    const double y = c.a * std::sin(t), width = std::cos(t);
    for (int j = 0; j < points; ++j) {
      const double q = 0.5 * pi * (j + 0.5) / points;
      const double x = c.b * width * std::sin(q);
      const double p = p0 * width * std::cos(q);
      spots[static_cast<std::size_t>(i * points + j)] = {
          .v_along = bend * y * y - c.spin * y,
          .v_across = c.spin * x,
          .area =
              2.0 * c.a * width * (pi / strips) * c.b * width * std::cos(q) * (0.5 * pi / points),
          .pressure = p,
          .thinner = film > 0.0 ? oil.under(p) / (film * eyring) : 0.0};
    }
  }
  double power = 0.0;
  const auto pull = [&](double centre) {
    double along = 0.0;
    power = 0.0;
    for (const Spot& s : spots) {
      const double vx = centre + s.v_along, v = std::hypot(vx, s.v_across);
      if (!(v > 0.0)) continue;
      const double stress =
          (1.0 - asperities) *
              std::min(eyring * std::asinh(s.thinner * v), limit_of_film * s.pressure) +
          asperities * friction_of_asperities * s.pressure * v / std::hypot(v, small);
      along += s.area * stress * vx / v;
      power += s.area * stress * v;
    }
    return along;
  };
  const double most = bend * c.a * c.a;
  std::uintmax_t steps = 100;
  const auto [low, high] = boost::math::tools::toms748_solve(
      pull, -most * (1.0 + 1e-9), 0.0, boost::math::tools::eps_tolerance<double>(30), steps);
  pull(0.5 * (low + high));
  return power;
}

struct Powers {
  double rolling, sliding, hysteresis;
};

Powers powers(const Pressed& c, const Oil& oil) {
  const double ellipse = c.a / c.b, area = c.modulus * c.along * c.along;
  const double W = c.load / area, G = oil.alpha * c.modulus;
  const double U = oil.eta * c.speed / (c.modulus * c.along);
  const double heat = oil.eta * oil.beta * c.speed * c.speed / conductivity;
  const double warm = 1.0 / (1.0 + 0.1 * std::pow(heat, 0.64));
  const double central = warm * c.along * 2.69 * std::pow(U, 0.67) * std::pow(G, 0.53) *
                         std::pow(W, -0.067) * (1.0 - 0.61 * std::exp(-0.73 * ellipse));
  const double least = warm * c.along * 3.63 * std::pow(U, 0.68) * std::pow(G, 0.49) *
                       std::pow(W, -0.073) * (1.0 - std::exp(-0.68 * ellipse));
  const double asperities = std::exp(-1.8 * std::pow(least / roughness, 1.2));

  const double U2 = 2.0 * U, radii = c.along / c.across;
  const double bet = 4.0 / pi * c.second / (1.0 + radii);
  const double M = std::pow(bet, 0.25) / ellipse * W / std::pow(U2, 0.75);
  const double rigid = 0.835 * std::pow(radii, -0.358) * std::pow(U2, 0.636) * std::pow(W, 0.364);
  const double elastic = 1.544 * std::cbrt(bet) * std::pow(ellipse, 0.577) * std::pow(U2, 0.656) *
                         std::pow(W, 0.466) * std::pow(G, 0.022);
  const double force = area * ((rigid - elastic) / (1.0 + M / 6.6) + elastic);
  const double rolling = 2.0 * force * c.speed / (1.0 + 0.29 * std::pow(heat, 0.78));

  const double steel = 2.0 / (2.0 * (1.0 - 0.09) / 208e9);
  const double moment = 7.48e-7 * std::pow(0.5 * c.diameter, 0.33) * std::pow(c.load, 1.33) *
                        (1.0 - 3.519e-3 * std::pow(1.0 / radii - 1.0, 0.8063)) *
                        std::cbrt(0.5 * steel / (0.5 * c.modulus));
  return {rolling, sliding_power(c, oil, central, asperities), moment * c.rolling};
}

}  // namespace

ContactMoments contact_moments(const Bearing& bearing, double speed, double load,
                               double temperature) {
  const Machine& m = bearing.machine();
  const Balance& b = bearing.balance(speed, load);
  const Oil oil(bearing, temperature);
  const double w = speed * pi / 30.0, D = 1e-3 * m.ball_diameter, dm = 1e-3 * m.pitch_diameter;
  const double g = D * std::cos(m.contact_angle * pi / 180.0) / dm;
  const auto pressed = [&](const Contact& c, double Q, double f, double along) {
    const double a = 1e-3 * c.major_axis * std::cbrt(Q);
    const double steel = 208e9 / (1.0 - 0.09);
    return Pressed{.load = Q,
                   .a = a,
                   .b = a / c.ellipse_ratio,
                   .modulus = steel / c.softer_by,
                   .along = along,
                   .across = f * D / (2.0 * f - 1.0),
                   .second = c.second_ellipse,
                   .speed = 0.0,
                   .rolling = 0.0,
                   .spin = 0.0,
                   .conformity = f,
                   .diameter = D};
  };
  Pressed inner = pressed(bearing.inner(), b.inner_load, m.inner_conformity, 0.5 * D * (1.0 - g));
  inner.speed = 0.5 * (1.0 - b.cage_ratio) * w * (dm - D * std::cos(b.inner_angle));
  inner.rolling = b.inner_rolling * w;
  inner.spin = std::abs(b.spin_ratio) * w;
  Pressed outer = pressed(bearing.outer(), b.outer_load, m.outer_conformity, 0.5 * D * (1.0 + g));
  outer.speed = 0.5 * b.cage_ratio * w * (dm + D * std::cos(b.outer_angle));
  outer.rolling = b.outer_rolling * w;
  const Powers i = powers(inner, oil), o = powers(outer, oil);
  const double share = 1e3 * m.balls / w;  // W to N mm, of all balls
  return {.rolling = share * (i.rolling + o.rolling),
          .sliding = share * (i.sliding + o.sliding),
          .hysteresis = share * (i.hysteresis + o.hysteresis)};
}

}  // namespace hidden_effect
