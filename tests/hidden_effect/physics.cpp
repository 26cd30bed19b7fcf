#include "tests/hidden_effect/physics.h"

#include <algorithm>
#include <array>
#include <boost/math/tools/roots.hpp>
#include <cmath>
#include <cstdint>
#include <functional>
#include <numbers>
#include <stdexcept>
#include <string>
#include <vector>

#include "tests/hidden_effect/contact_truth.h"

namespace hidden_effect {
namespace {

using std::numbers::pi;

double root(const std::function<double(double)>& f, double lower, double upper) {
  std::uintmax_t steps = 200;
  const auto bracket = boost::math::tools::toms748_solve(
      f, lower, upper, boost::math::tools::eps_tolerance<double>(50), steps);
  return 0.5 * (bracket.first + bracket.second);
}

constexpr double steel_compliance = (1.0 - 0.09) / 208e3;  // (1 - nu^2)/E [mm2/N]

/// Contact from half the curvature across (A) and along (B) the rolling direction [1/mm] and the
/// contact modulus [N/mm2].
Contact contact(double A, double B, double modulus, double conformity) {
  const auto excess = [&](double log_ratio) {
    const double r = std::exp(log_ratio), e = std::sqrt(1.0 - 1.0 / (r * r));
    const double K = std::comp_ellint_1(e), E = std::comp_ellint_2(e);
    return (r * r * E - K) / (K - E) - B / A;
  };
  const double r = std::exp(root(excess, 1e-3, 6.0));
  const double e2 = 1.0 - 1.0 / (r * r), e = std::sqrt(e2);
  const double K = std::comp_ellint_1(e), E = std::comp_ellint_2(e);
  const double shape = std::sqrt(A * B) * e2 / std::sqrt((r * r * E - K) * (K - E));
  // p0 = modulus shape a r, Q = 2/3 pi p0 a^2/r, approach = (p0/modulus) (a/r) K
  const double load_per_cube = 2.0 / 3.0 * pi * modulus * shape;
  const double a = std::cbrt(1.0 / load_per_cube);
  return {.stiffness = 1.0 / std::pow(shape * a * a * K, 1.5),
          .major_axis = a,
          .second_ellipse = E,
          .ellipse_ratio = r,
          .conformity = conformity,
          .radius_ratio = B / A,
          .softer_by = 0.5 / (steel_compliance * modulus)};
}

double viscosity_sum(double v) { return std::log10(std::log10(v + 0.7)); }

double omega(double speed) { return speed * pi / 30.0; }

double load_moment(const Bearing& bearing, const BaseLaw& law, double load, double radial) {
  const Machine& m = bearing.machine();
  const double counted =
      std::max(0.9 * load / std::tan(m.contact_angle * pi / 180.0) - 0.1 * radial, radial);
  if (counted <= 0.0) return 0.0;
  return law.z * std::pow(counted / m.load_rating, law.y) * counted * m.pitch_diameter;
}

double viscous_moment(const Bearing& bearing, const BaseLaw& law, double speed, double viscosity) {
  const double x = viscosity * speed;
  // Another exponent bends the law above the knee and scales what is constant below it.
  const double drag = x < 2000.0 ? 160.0 * std::pow(2000.0, law.viscous_exponent - 2.0 / 3.0)
                                 : std::pow(x, law.viscous_exponent);
  return 1e-7 * law.f0 * drag * std::pow(bearing.machine().pitch_diameter, 3);
}

/// SKF's catalogue, rolling bearings 10000 EN, friction: single row angular contact, oil-air and a
/// mineral oil, pure thrust. G_rr = R1 dm^1.97 (Fg + R2 Fa)^0.54, M_rr = phi_ish phi_rs G_rr
/// (nu n)^0.6; G_sl = S1 dm^0.26 (Fg^(4/3) + S2 Fa^(4/3)), M_sl = mu G_sl.
Bearing::Moments skf_moments(const Machine& m, double speed, double load, double viscosity) {
  const double dm = m.pitch_diameter, d = m.bore(), D = m.outer_diameter();
  const double balls = m.ceramic_balls ? 0.41 : 1.0, n = speed, fourth = std::pow(dm, 4);
  const double rolling_load = 1.90e-12 * balls * fourth * n * n + 1.97 * load;
  const double sliding_load = 1.91e-12 * balls * fourth * n * n;
  const double shear = 1.0 / (1.0 + 1.84e-9 * std::pow(n * dm, 1.28) * std::pow(viscosity, 0.64));
  const double return_flow =
      std::exp(-6e-8 * viscosity * n * (d + D) * std::sqrt(4.4 / (2.0 * (D - d))));
  const double boundary = std::exp(-2.6e-8 * std::pow(n * viscosity, 1.4) * dm);
  const double mu = boundary * 0.12 + (1.0 - boundary) * 0.04;
  return {.rolling = shear * return_flow * 5.03e-7 * std::pow(dm, 1.97) *
                     std::pow(rolling_load, 0.54) * std::pow(viscosity * n, 0.6),
          .other = mu * 1.30e-2 * std::pow(dm, 0.26) *
                   (std::pow(sliding_load, 4.0 / 3.0) + 0.68 * std::pow(load, 4.0 / 3.0))};
}

/// Houpert's hydrodynamic rolling force goes with U^0.656 W^0.466; sliding with the size of the
/// ellipse times the load. At 90 mm, 5000 rpm, 1000 N and 30 mm2/s they are 80 and 40 N mm.
Bearing::Moments houpert_moments(const Machine& m, const BaseLaw& law, double speed, double load,
                                 double viscosity) {
  const double size = std::pow(m.pitch_diameter / 90.0, 2);
  return {.rolling = 80.0 * size * std::pow(speed * viscosity / 1.5e5, law.powers[0]) *
                     std::pow(load / 1000.0, law.powers[1]),
          .other = 40.0 * size * std::pow(load / 1000.0, law.powers[2])};
}

/// Mean of Houpert's law over the inner and the outer contact. A contact with the load Q counts as
/// the thrust Z Q sin a0.
Bearing::Moments mean_over_contacts(const Bearing& bearing, const BaseLaw& law, double speed,
                                    double load, double viscosity) {
  const Machine& m = bearing.machine();
  const Balance& ball = bearing.balance(speed, load);
  const double thrust = m.balls * std::sin(m.contact_angle * pi / 180.0);
  const auto at = [&](double Q) { return houpert_moments(m, law, speed, thrust * Q, viscosity); };
  const Bearing::Moments inner = at(ball.inner_load), outer = at(ball.outer_load);
  return {.rolling = 0.5 * (inner.rolling + outer.rolling),
          .other = 0.5 * (inner.other + outer.other)};
}

/// The base moment of a bearing at a film temperature: what the oil resists, and the rest.
Bearing::Moments base_moments(const Bearing& bearing, const BaseLaw& law, const Point& point,
                              double load, double temperature) {
  if (law.contacts) {
    Bearing::Moments moments = bearing.contact_moments(point.speed, load, temperature);
    moments.rolling *= law.rolling_factor;
    return moments;
  }
  const double viscosity = bearing.viscosity(temperature);
  if (law.formula != Formula::palmgren) {
    const Machine& m = bearing.machine();
    const Bearing::Moments moments =
        law.formula == Formula::skf ? skf_moments(m, point.speed, load, viscosity)
        : law.by_ball_loads         ? mean_over_contacts(bearing, law, point.speed, load, viscosity)
                                    : houpert_moments(m, law, point.speed, load, viscosity);
    return {.rolling = law.rolling_factor * moments.rolling,
            .other = law.sliding_factor * moments.other};
  }
  return {.rolling = viscous_moment(bearing, law, point.speed, viscosity),
          .other = load_moment(bearing, law, load, point.radial)};
}

/// Power of a moment [W].
double power(double moment, double speed) { return 1e-3 * moment * omega(speed); }

// What several effects read of a scene.
double nu(const Scene& s) { return s.bearing.viscosity(s.point.temperature); }
double base_power(const Scene& s) {
  const Bearing::Moments base =
      base_moments(s.bearing, s.law, s.point, s.point.load, s.point.temperature);
  return power(base.rolling + base.other, s.point.speed);
}
double k_rpm(const Scene& s) { return s.point.speed / 1e4; }

/// exp(-x) of the SKF replenishment factor, x per unit of K.
double starvation(const Scene& s) {
  const Machine& m = s.bearing.machine();
  const double d = m.bore(), D = m.outer_diameter();
  return nu(s) * s.point.speed * (d + D) * std::sqrt(4.4 / (2.0 * (D - d)));
}

double boundary_share(const Scene& s) {
  return std::exp(-2.6e-8 * std::pow(nu(s) * s.point.speed, 1.4) *
                  s.bearing.machine().pitch_diameter);
}

/// Film temperature T + R P(T_film), P falling with T_film: bracketed, so it always converges.
double film_temperature(const Scene& s, double resistance) {
  // Of the contacts all that is lost warms the film, at the load that effects have made so far.
  const auto heat = [&](double rise) {
    const Bearing::Moments base =
        base_moments(s.bearing, s.law, s.point, s.load, s.point.temperature + rise);
    return resistance * power(base.rolling + (s.law.contacts ? base.other : 0.0), s.point.speed);
  };
  const auto gap = [&](double rise) { return rise - heat(rise); };
  double most = heat(0.0);
  if (!(most > 0.0)) return s.point.temperature;
  // Hotter than that no oil is; what asks for it is no size of an effect.
  constexpr double hottest = 150.0;
  // Where asperities carry more as the oil thins, the power grows with temperature.
  while (s.law.contacts && most < hottest && gap(most) < 0.0) most *= 1.5;
  if (s.law.contacts && most >= hottest) {
    most = hottest;
    if (gap(most) < 0.0) return s.point.temperature + hottest;
  }
  return s.point.temperature + root(gap, 0.0, most * (1.0 + 1e-12));
}

/// Elastic hysteresis of one contact after Houpert, SI in the formula [N mm]. The formula takes the
/// ratio of the radii of curvature, 26 or so at a conformity of 0.52, not that of the ellipse. What
/// is lost is a share of the elastic work per length rolled, Q times the half width, and that one
/// goes with the cube root of the compliance.
double hysteresis(double ball_diameter, const Contact& contact, double load) {
  const double openness = std::exp(0.8063 * std::log(contact.radius_ratio - 1.0));
  const double steel = 7.48e-7 * std::pow(0.5e-3 * ball_diameter, 0.33) * std::pow(load, 1.33) *
                       (1.0 - 3.519e-3 * openness);
  return 1e3 * steel * std::cbrt(contact.softer_by);
}

// Shared between the table of effects and their other forms.
template <double exponent>
void speed_power(Scene& s, const Values& v) {
  s.moment += v.size * std::pow(k_rpm(s), exponent);
}

constexpr std::array<std::string_view, 1> as_drag{"lubricant-drag"};
constexpr std::array<std::string_view, 1> as_windage{"windage"};
constexpr std::array<std::string_view, 1> as_offset{"torque-offset"};
constexpr std::array<std::string_view, 1> as_seal{"seal-friction"};
constexpr std::span<const std::string_view> alone{};

Effect added(std::string_view id, Kind kind, void (*moment)(Scene&, const Values&),
             std::span<const std::string_view> aliases = {}, bool negative = false) {
  return {.id = id,
          .family = kind == Kind::outside ? std::string_view{} : id,
          .kind = kind,
          .aliases = aliases,
          .negative = negative,
          .shape = 0.0,
          .shape_lower = 0.0,
          .shape_upper = 0.0,
          .largest = 1e6,
          .condition = nullptr,
          .moment = moment};
}

Effect changed(std::string_view id, Kind kind, double largest,
               void (*condition)(Scene&, const Values&), bool negative = false) {
  Effect e = added(id, kind, nullptr, alone, negative);
  e.condition = condition;
  e.largest = largest;
  return e;
}

Effect shaped(Effect e, double shape, double lower, double upper) {
  e.shape = shape;
  e.shape_lower = lower;
  e.shape_upper = upper;
  return e;
}

Effect limited(Effect e, double largest) {
  e.largest = largest;
  return e;
}

Effect form_of(std::string_view family, Effect e) {
  e.family = family;
  return e;
}

std::vector<Effect> make_catalogue() {
  constexpr Kind in = Kind::catalogue;
  return {
      changed(
          "viscous-exponent", in, 0.15,
          [](Scene& s, const Values& v) {
            s.factor *= std::pow(std::max(nu(s) * s.point.speed, 2000.0) / 1e5, v.size);
          },
          true),
      limited(added(
                  "load-exponent", in,
                  [](Scene& s, const Values& v) {
                    BaseLaw other = s.law;
                    other.y += v.size;
                    // Both laws agree at a load in the middle: only the slope is hidden.
                    const double scale = load_moment(s.bearing, s.law, 800.0, 0.0) /
                                         load_moment(s.bearing, other, 800.0, 0.0);
                    s.moment += scale * load_moment(s.bearing, other, s.load, s.point.radial) -
                                load_moment(s.bearing, s.law, s.load, s.point.radial);
                  },
                  alone, true),
              0.5),
      added("spin-friction", in,
            [](Scene& s, const Values& v) {
              const Balance& b = s.bearing.balance(s.point.speed, s.load);
              const Contact& c = s.bearing.inner();
              s.moment += s.bearing.machine().balls * 0.375 * v.size * b.inner_load * c.major_axis *
                          std::cbrt(b.inner_load) * c.second_ellipse * b.spin_ratio;
            }),
      added("differential-slip", in,
            [](Scene& s, const Values& v) {
              const Machine& m = s.bearing.machine();
              const Balance& b = s.bearing.balance(s.point.speed, s.load);
              const auto contact_moment = [&](const Contact& c, double load) {
                const double R = 2.0 * c.conformity * m.ball_diameter / (2.0 * c.conformity + 1.0);
                const double a = c.major_axis * std::cbrt(load);
                return 0.1 * v.size * load * a * a / R;
              };
              s.moment +=
                  m.balls * (b.inner_rolling * contact_moment(s.bearing.inner(), b.inner_load) +
                             b.outer_rolling * contact_moment(s.bearing.outer(), b.outer_load));
            }),
      added("elastic-hysteresis", in,
            [](Scene& s, const Values& v) {
              const Machine& m = s.bearing.machine();
              const Balance& b = s.bearing.balance(s.point.speed, s.load);
              s.moment +=
                  v.size * m.balls *
                  (b.inner_rolling * hysteresis(m.ball_diameter, s.bearing.inner(), b.inner_load) +
                   b.outer_rolling * hysteresis(m.ball_diameter, s.bearing.outer(), b.outer_load));
            }),
      added("gyroscopic-slip", in,
            [](Scene& s, const Values& v) {
              s.moment += v.size * s.bearing.machine().balls *
                          s.bearing.balance(s.point.speed, s.load).gyroscopic_moment;
            }),
      changed("inlet-shear-heating", in, 50.0,
              [](Scene& s, const Values& v) {
                const double x =
                    std::pow(s.point.speed * s.bearing.machine().pitch_diameter, 1.28) *
                    std::pow(nu(s), 0.64);
                s.factor /= 1.0 + v.size * 1.84e-9 * x;
              }),
      changed("replenishment-starvation", in, 1e-4,
              [](Scene& s, const Values& v) { s.factor *= std::exp(-v.size * starvation(s)); }),
      shaped(changed("shear-thinning", in, 0.3,
                     [](Scene& s, const Values& v) {
                       const double r = s.point.speed / v.shape;
                       s.factor *= std::pow(1.0 + r * r, -v.size);
                     }),
             4000.0, 1000.0, 20000.0),
      changed("film-self-heating", in, 5.0,
              [](Scene& s, const Values& v) { s.temperature = film_temperature(s, v.size); }),
      limited(added("mixed-lubrication", in,
                    [](Scene& s, const Values& v) {
                      s.moment += v.size * boundary_share(s) * 1.30e-2 *
                                  std::pow(s.bearing.machine().pitch_diameter, 0.26) * 0.68 *
                                  std::pow(s.load, 4.0 / 3.0);
                    }),
              0.45),
      shaped(added(
                 "seal-friction", in,
                 [](Scene& s, const Values& v) {
                   s.moment += v.size * (1.0 - v.shape * (s.point.temperature - 45.0));
                 },
                 as_offset),
             0.0075, 0.0, 0.015),
      changed(
          "load-offset", in, 5000.0, [](Scene& s, const Values& v) { s.load += v.size; }, true),
      added("lubricant-drag", in, speed_power<2.0>, as_windage),
      added("churning", in,
            [](Scene& s, const Values& v) {
              const double n = s.point.speed;
              const double dm = s.bearing.machine().pitch_diameter;
              s.moment += v.size * 1.093e-7 * n * n * std::pow(dm, 3) *
                          std::pow(n * dm * dm / nu(s), -1.379);
            }),
      added("windage", in, speed_power<1.8>, as_drag),
      added("cage-friction", in,
            [](Scene& s, const Values& v) { s.moment += v.size * nu(s) * s.point.speed / 1e5; }),
      changed("thermal-preload", in, 50.0,
              [](Scene& s, const Values& v) { s.load += v.size * base_power(s); }),
      changed("centrifugal-ring-growth", in, 2e4,
              [](Scene& s, const Values& v) { s.load += v.size * k_rpm(s) * k_rpm(s); }),
      added(
          "torque-offset", in, [](Scene& s, const Values& v) { s.moment += v.size; }, as_seal,
          true),
      added(
          "torque-temperature-drift", in,
          [](Scene& s, const Values& v) { s.moment += v.size * (s.point.temperature - 40.0) / 10; },
          alone, true),
      added(
          "torque-time-drift", in,
          [](Scene& s, const Values& v) { s.moment += v.size * s.point.time / 3600.0; }, alone,
          true),
      added("rig-viscous-drag", in, speed_power<1.0>),
      shaped(added("grease-churning", in,
                   [](Scene& s, const Values& v) {
                     s.moment +=
                         v.size * std::exp(-s.point.time / (3600.0 * v.shape)) *
                         base_moments(s.bearing, s.law, s.point, s.load, s.temperature).rolling;
                   }),
             4.0, 1.0, 20.0),
  };
}

std::vector<Effect> make_other_forms() {
  constexpr Kind other = Kind::other_form;
  return {
      form_of("spin-friction",
              added("spin-at-nominal-angle", other,
                    [](Scene& s, const Values& v) {
                      // Simple form: contact angle as drawn, line of balls, mu falls with speed.
                      const Machine& m = s.bearing.machine();
                      const double Q = s.load / (m.balls * std::sin(m.contact_angle * pi / 180.0));
                      const Balance& b = s.bearing.balance(s.point.speed, s.load);
                      s.moment += v.size * m.balls * std::pow(Q, 4.0 / 3.0) * b.spin_ratio *
                                  std::pow(1.0 + s.point.speed / 5000.0, -0.1);
                    })),
      form_of("differential-slip", added("slip-simple", other,
                                         [](Scene& s, const Values& v) {
                                           // A power of each ball load, without the ellipse.
                                           const Balance& b =
                                               s.bearing.balance(s.point.speed, s.load);
                                           s.moment += v.size * (std::pow(b.inner_load, 1.75) +
                                                                 std::pow(b.outer_load, 1.75));
                                         })),
      form_of("gyroscopic-slip", added("gyroscopic-creep", other,
                                       [](Scene& s, const Values& v) {
                                         const Balance& b =
                                             s.bearing.balance(s.point.speed, s.load);
                                         s.moment += v.size * s.bearing.machine().balls *
                                                     std::pow(b.gyroscopic_moment, 0.95) *
                                                     std::pow(b.inner_load, -0.05);
                                       })),
      form_of("inlet-shear-heating", changed("inlet-heating-other-powers", other, 1e3,
                                             [](Scene& s, const Values& v) {
                                               s.factor /= 1.0 + v.size * std::pow(k_rpm(s), 1.4) *
                                                                     std::pow(nu(s) / 30.0, 0.7);
                                             })),
      form_of("replenishment-starvation", changed("starvation-rational", other, 1e-4,
                                                  [](Scene& s, const Values& v) {
                                                    const double x = v.size * starvation(s);
                                                    s.factor /= 1.0 + x + 0.3 * x * x;
                                                  })),
      form_of("shear-thinning", changed("carreau", other, 100.0,
                                        [](Scene& s, const Values& v) {
                                          // Carreau with m = 0.75; size is the shear rate over its
                                          // limit at 10 krpm.
                                          const double g = v.size * k_rpm(s);
                                          s.factor *= std::pow(1.0 + g * g, 0.5 * (0.75 - 1.0));
                                        })),
      form_of("film-self-heating", changed("film-heated-by-all", other, 5.0,
                                           [](Scene& s, const Values& v) {
                                             s.temperature += v.size * std::pow(base_power(s), 0.9);
                                           })),
      form_of("mixed-lubrication", added("stribeck-rational", other,
                                         [](Scene& s, const Values& v) {
                                           // Half of it is gone where half of SKF's share is.
                                           const double d_m = s.bearing.machine().pitch_diameter;
                                           const double half =
                                               std::pow(std::log(2.0) / (2.6e-8 * d_m), 1.0 / 1.4);
                                           const double x = nu(s) * s.point.speed / half;
                                           s.moment += v.size / (1.0 + std::pow(x, 1.8)) *
                                                       std::pow(s.load / 1000.0, 1.25);
                                         })),
      form_of("seal-friction", added(
                                   "seal-lip-viscous", other,
                                   [](Scene& s, const Values& v) {
                                     s.moment += v.size * std::pow(nu(s) / 26.0, 0.15) *
                                                 std::pow(s.point.speed / 5000.0, 0.03);
                                   },
                                   as_offset)),
      form_of("load-offset", changed("load-offset-friction", other, 5000.0,
                                     [](Scene& s, const Values& v) {
                                       s.load += v.size * (1.0 + 0.1 * s.point.load / 1000.0);
                                     })),
      form_of("lubricant-drag", added("drag-lower-power", other, speed_power<1.9>, as_windage)),
      form_of("churning", added("churning-other-powers", other,
                                [](Scene& s, const Values& v) {
                                  s.moment += v.size * std::pow(k_rpm(s), 0.7) *
                                              std::pow(nu(s) / 30.0, 1.25);
                                })),
      form_of("windage", added(
                             "windage-turbulent", other,
                             [](Scene& s, const Values& v) {
                               // C_f of Bilgen and Boulos: Re^-0.5 below, Re^-0.2 above 1e4.
                               const double Re = 2.0 * s.point.speed;
                               const double cf =
                                   Re < 1e4 ? std::pow(Re / 1e4, -0.5) : std::pow(Re / 1e4, -0.2);
                               s.moment += v.size * cf * k_rpm(s) * k_rpm(s);
                             },
                             as_drag)),
      form_of("cage-friction", added("cage-lower-power", other,
                                     [](Scene& s, const Values& v) {
                                       s.moment +=
                                           v.size * std::pow(nu(s) * s.point.speed / 1e5, 1.06);
                                     })),
      form_of("thermal-preload", changed("thermal-preload-cooled", other, 100.0,
                                         [](Scene& s, const Values& v) {
                                           s.load += v.size * std::pow(base_power(s), 0.9) *
                                                     std::pow(s.point.load / 1000.0, 0.1);
                                         })),
      form_of("centrifugal-ring-growth", changed("ring-growth-stiffening", other, 2e4,
                                                 [](Scene& s, const Values& v) {
                                                   s.load += v.size * k_rpm(s) * k_rpm(s) *
                                                             std::pow(s.point.load / 1000.0, 0.15);
                                                 })),
      form_of("torque-temperature-drift", added(
                                              "drift-curved", other,
                                              [](Scene& s, const Values& v) {
                                                const double x = (s.point.temperature - 40.0) / 10;
                                                s.moment += v.size * x * (1.0 + 0.05 * x);
                                              },
                                              alone, true)),
  };
}

std::vector<Effect> make_outside() {
  constexpr Kind out = Kind::outside;
  return {
      added("cage-resonance", out,
            [](Scene& s, const Values& v) {
              const double x = (s.point.speed - 7000.0) / 1500.0;
              s.moment += v.size * std::exp(-0.5 * x * x);
            }),
      added("speed-ripple", out,
            [](Scene& s, const Values& v) {
              s.moment += v.size * std::cos(2.0 * pi * std::log(s.point.speed / 600.0) / 1.8);
            }),
      added("kink-above-speed", out,
            [](Scene& s, const Values& v) { s.moment += v.size * std::max(0.0, k_rpm(s) - 0.9); }),
      added(
          "power-law-product", out,
          [](Scene& s, const Values& v) { s.moment += v.size * k_rpm(s) * s.point.load / 1000.0; }),
      added("saturating-with-speed", out,
            [](Scene& s, const Values& v) {
              s.moment += v.size * (1.0 - std::exp(-s.point.speed / 2500.0));
            }),
      added("kink-above-load", out,
            [](Scene& s, const Values& v) {
              s.moment += v.size * std::max(0.0, s.point.load / 1000.0 - 1.2);
            }),
      added("wax-when-cold", out,
            [](Scene& s, const Values& v) {
              s.moment += v.size / (1.0 + std::exp((s.point.temperature - 38.0) / 2.0));
            }),
      added("cold-slow-stick", out,
            [](Scene& s, const Values& v) {
              s.moment += v.size * std::pow(nu(s) / 30.0, 1.5) * std::exp(-s.point.speed / 3000.0);
            }),
      added("power-law-slow", out,
            [](Scene& s, const Values& v) {
              s.moment += v.size * std::sqrt(k_rpm(s) * s.point.load / 1000.0);
            }),
      added("power-law-cold", out,
            [](Scene& s, const Values& v) {
              s.moment += v.size * std::pow(k_rpm(s) * nu(s) / 30.0, 0.8) *
                          std::pow(s.point.load / 1000.0, 0.7);
            }),
  };
}

const std::vector<Effect> catalogue = make_catalogue();
const std::vector<Effect> forms = make_other_forms();
const std::vector<Effect> outside = make_outside();
// Outside as well, but only felt on a plan with radial load.
const std::vector<Effect> radial = {
    added("radial-drag", Kind::outside,
          [](Scene& s, const Values& v) { s.moment += v.size * s.point.radial / 1000.0; })};

}  // namespace

Bearing::Bearing(const Machine& machine) : machine_(machine) {
  const double D = machine.ball_diameter;
  const double g = D * std::cos(machine.contact_angle * pi / 180.0) / machine.pitch_diameter;
  // 1/modulus of two bodies: that of the ring and that of the ball
  const double ball = machine.ceramic_balls ? (1.0 - 0.26 * 0.26) / 310e3 : steel_compliance;
  const double modulus = 1.0 / (steel_compliance + ball);
  const auto race = [&](double conformity, double along) {
    return contact((2.0 - 1.0 / conformity) / (2.0 * D), along / D, modulus, conformity);
  };
  inner_ = race(machine.inner_conformity, 1.0 / (1.0 - g));
  outer_ = race(machine.outer_conformity, 1.0 / (1.0 + g));
  const double density = machine.ceramic_balls ? 3200.0 : 7800.0;
  ball_mass_ = density * pi / 6.0 * std::pow(1e-3 * D, 3);
  const double x1 = std::log10(313.15), x2 = std::log10(373.15);
  astm_slope_ =
      (viscosity_sum(machine.viscosity_40) - viscosity_sum(machine.viscosity_100)) / (x2 - x1);
  astm_offset_ = viscosity_sum(machine.viscosity_40) + astm_slope_ * x1;
}

double Bearing::viscosity(double temperature) const {
  return std::pow(10.0,
                  std::pow(10.0, astm_offset_ - astm_slope_ * std::log10(temperature + 273.15))) -
         0.7;
}

const Balance& Bearing::balance(double speed, double load) const {
  const auto [entry, is_new] = found_.try_emplace({speed, load});
  if (is_new) entry->second = solve(speed, load);
  return entry->second;
}

const Bearing::Moments& Bearing::contact_moments(double speed, double load,
                                                 double temperature) const {
  const auto [entry, is_new] = moments_.try_emplace({speed, load, temperature});
  if (is_new) {
    const ContactMoments m = hidden_effect::contact_moments(*this, speed, load, temperature);
    entry->second = {.rolling = m.rolling, .other = m.sliding + m.hysteresis};
  }
  return entry->second;
}

Balance Bearing::solve(double speed, double load) const {
  const Machine& m = machine_;
  const double D = m.ball_diameter, dm = m.pitch_diameter, a0 = m.contact_angle * pi / 180.0;
  const double distance = (m.inner_conformity + m.outer_conformity - 1.0) * D;
  const double w = omega(speed), ratio = dm / D, share = load / m.balls;
  Balance b{};
  const auto at_inner_angle = [&](double ai) {
    double ao = ai;
    for (int i = 0; i < 200; ++i) {
      // The ball in the frame of the cage: along the tangent it rolls on the outer race, about the
      // normal it turns with it. Rolling at the inner race then gives the cage speed.
      const double turn = ratio + std::cos(ao);  // per cage speed, about the outer tangent
      const double rolling = turn * std::cos(ai - ao) - std::sin(ao) * std::sin(ai - ao);
      const double free_speed = ratio - std::cos(ai);
      const double cage = free_speed / (free_speed + rolling);
      const double radial_turn = turn * std::sin(ao) - std::sin(ao) * std::cos(ao);
      const double axial_turn = turn * std::cos(ao) + std::sin(ao) * std::sin(ao);
      const double wm = cage * w;
      const double centrifugal = ball_mass_ * 0.5e-3 * dm * wm * wm;
      const double couple = 0.1 * ball_mass_ * 1e-3 * D * D * wm * wm * radial_turn;  // [N mm]
      const double force = centrifugal + (ao > 0.0 ? 2.0 * couple / D / std::sin(ao) : 0.0);
      const double next = std::atan2(1.0, 1.0 / std::tan(ai) + force / share);
      const bool done = std::abs(next - ao) < 1e-15;
      ao = next;
      b.cage_ratio = cage;
      b.gyroscopic_moment = couple;
      // Relative turning about the inner normal, ball against ring.
      b.spin_ratio = cage * (axial_turn * std::sin(ai) - radial_turn * std::cos(ai)) +
                     (1.0 - cage) * std::sin(ai);
      b.inner_rolling = cage * rolling + (1.0 - cage) * std::cos(ai);
      b.outer_rolling = cage * ratio;
      if (done) break;
    }
    b.inner_angle = ai;
    b.outer_angle = ao;
    b.inner_load = share / std::sin(ai);
    b.outer_load = (share - 2.0 * b.gyroscopic_moment / D * std::cos(ao)) / std::sin(ao);
    const double li =
        (m.inner_conformity - 0.5) * D + std::pow(b.inner_load / inner_.stiffness, 2.0 / 3.0);
    const double lo = (m.outer_conformity - 0.5) * D +
                      std::pow(std::max(b.outer_load, 0.0) / outer_.stiffness, 2.0 / 3.0);
    b.displacement = lo * std::sin(ao) + li * std::sin(ai) - distance * std::sin(a0);
    return lo * std::cos(ao) + li * std::cos(ai) - distance * std::cos(a0);
  };
  at_inner_angle(root(at_inner_angle, 0.98 * a0, 1.55));
  return b;
}

std::span<const Effect> catalogue_effects() { return catalogue; }
std::span<const Effect> other_forms() { return forms; }
std::span<const Effect> outside_effects() { return outside; }

bool within_contacts(std::string_view id) {
  constexpr std::array<std::string_view, 9> ids{
      "viscous-exponent",   "load-exponent",   "spin-friction",       "differential-slip",
      "elastic-hysteresis", "gyroscopic-slip", "inlet-shear-heating", "replenishment-starvation",
      "mixed-lubrication"};
  return std::find(ids.begin(), ids.end(), id) != ids.end();
}

const Effect& effect(std::string_view id) {
  for (const std::vector<Effect>* list : {&catalogue, &forms, &outside, &radial})
    for (const Effect& e : *list)
      if (e.id == id) return e;
  throw std::out_of_range("no effect " + std::string(id));
}

double torque(const Bearing& bearing, const BaseLaw& law, const Point& point,
              std::span<const Hidden> hidden) {
  Scene s{.bearing = bearing,
          .law = law,
          .point = point,
          .load = point.load,
          .temperature = point.temperature,
          .factor = 1.0,
          .moment = 0.0};
  for (const Hidden& h : hidden)
    if (h.effect->condition != nullptr) h.effect->condition(s, h.values);
  s.load = std::max(s.load, 1.0);
  for (const Hidden& h : hidden)
    if (h.effect->moment != nullptr) h.effect->moment(s, h.values);
  const Bearing::Moments base = base_moments(bearing, law, point, s.load, s.temperature);
  return s.factor * base.rolling + base.other + s.moment;
}

}  // namespace hidden_effect
