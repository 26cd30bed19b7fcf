#include "bearing/hertz.h"

#include <boost/math/special_functions/ellint_1.hpp>
#include <boost/math/special_functions/ellint_2.hpp>
#include <boost/math/tools/toms748_solve.hpp>
#include <cmath>
#include <sstream>
#include <stdexcept>

namespace raceway::bearing {
namespace {

/// Curvature difference of an ellipse of axis ratio κ.
double curvature_difference(double kappa) {
  // Both numerator and denominator vanish as (κ - 1) at the circle; this is the limit's slope.
  if (kappa - 1.0 < 1e-6) return 0.75 * (kappa - 1.0);
  const double k2 = 1.0 - 1.0 / (kappa * kappa);
  const double k = std::sqrt(k2);
  const double f = boost::math::ellint_1(k);
  const double e = boost::math::ellint_2(k);
  return ((kappa * kappa + 1.0) * e - 2.0 * f) / ((kappa * kappa - 1.0) * e);
}

double solve_ellipse_ratio(double difference) {
  if (difference < 1e-12) return 1.0;
  double upper = 2.0;
  while (curvature_difference(upper) < difference) upper *= 2.0;
  std::uintmax_t steps = 100;
  const auto bracket = boost::math::tools::toms748_solve(
      [difference](double kappa) { return curvature_difference(kappa) - difference; }, 1.0, upper,
      [](double a, double b) { return std::abs(a - b) <= 1e-15 * std::abs(a); }, steps);
  return 0.5 * (bracket.first + bracket.second);
}

/// s = (3 Q η / (2 Σρ))^(1/3)
double size(const HertzContact& c, double load) {
  return std::cbrt(1.5 * load / (c.contact_modulus * c.curvature_sum));
}

}  // namespace

Curvature groove_curvature(const BearingGeometry& g, Race race, double contact_angle) {
  const double gamma = g.diameter_ratio() * std::cos(contact_angle);
  const bool inner = race == Race::inner;
  const double groove = 1.0 / (inner ? g.inner_conformity : g.outer_conformity);
  const double ring = inner ? 2.0 * gamma / (1.0 - gamma) : -2.0 * gamma / (1.0 + gamma);
  return {.sum = (4.0 - groove + ring) / g.ball_diameter,
          .difference = (groove + ring) / (4.0 - groove + ring)};
}

double HertzContact::approach(double load) const {
  const double s = size(*this, load);
  const double a_star3 = 2.0 * ellipse_ratio * ellipse_ratio * second_integral / pi;
  return first_integral / pi / std::cbrt(a_star3) * s * s * curvature_sum;
}

double HertzContact::load(double approach) const {
  return approach > 0.0 ? contact_stiffness * approach * std::sqrt(approach) : 0.0;
}

double HertzContact::semi_major_axis(double load) const {
  return std::cbrt(2.0 * ellipse_ratio * ellipse_ratio * second_integral / pi) * size(*this, load);
}

double HertzContact::semi_minor_axis(double load) const {
  return semi_major_axis(load) / ellipse_ratio;
}

double HertzContact::peak_pressure(double load) const {
  if (load <= 0.0) return 0.0;
  const double a = semi_major_axis(load);
  return 1.5 * load * ellipse_ratio / (pi * a * a);
}

HertzContact hertz_contact(const Curvature& curvature, const Material& first,
                           const Material& second) {
  validate(first);
  validate(second);
  if (!(curvature.sum > 0.0 && curvature.difference >= 0.0 && curvature.difference < 1.0)) {
    std::ostringstream text;
    text << "curvature sum " << curvature.sum << " 1/m and difference " << curvature.difference
         << ": the sum must be above 0, and the difference must be at least 0 and below 1";
    throw std::invalid_argument(text.str());
  }
  HertzContact c;
  c.curvature_sum = curvature.sum;
  c.ellipse_ratio = solve_ellipse_ratio(curvature.difference);
  const double k = std::sqrt(1.0 - 1.0 / (c.ellipse_ratio * c.ellipse_ratio));
  c.first_integral = boost::math::ellint_1(k);
  c.second_integral = boost::math::ellint_2(k);
  const auto compliance = [](const Material& m) {
    return (1.0 - m.poisson_ratio * m.poisson_ratio) / m.elastic_modulus;
  };
  c.contact_modulus = 1.0 / (compliance(first) + compliance(second));
  c.contact_stiffness = 1.0 / std::pow(c.approach(1.0), 1.5);
  return c;
}

}  // namespace raceway::bearing
