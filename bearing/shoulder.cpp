#include "bearing/shoulder.h"

#include <algorithm>
#include <limits>

namespace raceway::bearing {
namespace {

constexpr double largest_axial_load = 1e8;  // [N], that of an operating point

double groove_radius(const BearingGeometry& g, Race race) {
  return (race == Race::inner ? g.inner_conformity : g.outer_conformity) * g.ball_diameter;
}

/// Half of the ellipse as an angle in the groove [rad].
double half_ellipse(const Bearing& bearing, Race race, double load) {
  const double a = bearing.contact(race).semi_major_axis(load);
  return std::asin(std::min(a / groove_radius(bearing.geometry(), race), 1.0));
}

struct Margin {
  double angle = unset, cut = 0.0;
};

Margin margin(const Bearing& bearing, const BearingEquilibrium& equilibrium, Race race) {
  Margin least;
  const double edge = shoulder_angle(bearing.geometry(), race);
  if (std::isnan(edge) || !equilibrium.report.converged()) return least;
  for (const BallEquilibrium& ball : equilibrium.balls.distinct()) {
    const bool inner = race == Race::inner;
    const double load = inner ? ball.inner_load : ball.outer_load;
    if (!(load > 0.0)) continue;
    const double alpha = inner ? ball.inner_contact_angle : ball.outer_contact_angle;
    const double half = half_ellipse(bearing, race, load);
    const bool two_shoulders = bearing.geometry().contact_angle == 0.0;
    const double left = edge - (two_shoulders ? std::abs(alpha) : alpha) - half;
    if (left >= least.angle) continue;
    least = {left, std::clamp(-left / (2.0 * half), 0.0, 1.0)};
  }
  return least;
}

double permissible(const Bearing& bearing, Race race) {
  const double edge = shoulder_angle(bearing.geometry(), race);
  if (std::isnan(edge)) return unset;
  const auto reaches = [&](double load) {
    const BearingEquilibrium e = solve_bearing_equilibrium(bearing, {.axial_load = load});
    // A load that no balance carries is beyond the shoulders.
    return !e.report.converged() || margin(bearing, e, race).angle <= 0.0;
  };
  if (edge <= bearing.geometry().contact_angle) return 0.0;
  double low = 0.0, high = 1.0;
  while (!reaches(high)) {
    low = high;
    if (high >= largest_axial_load) return std::numeric_limits<double>::infinity();
    high = std::min(4.0 * high, largest_axial_load);
  }
  while (high - low > 1e-9 * high) {
    const double middle = 0.5 * (low + high);
    if (!(middle > low && middle < high)) break;
    (reaches(middle) ? high : low) = middle;
  }
  return 0.5 * (low + high);
}

}  // namespace

double shoulder_angle(const BearingGeometry& g, Race race) {
  const bool inner = race == Race::inner;
  const double d = inner ? g.inner_shoulder_diameter : g.outer_shoulder_diameter;
  if (std::isnan(d)) return unset;
  const double r = groove_radius(g, race);
  const double centre = inner ? g.inner_groove_centre_radius() : g.outer_groove_centre_radius();
  return std::acos(std::clamp((inner ? centre - 0.5 * d : 0.5 * d - centre) / r, -1.0, 1.0));
}

ShoulderMargins shoulder_margins(const Bearing& bearing, const BearingEquilibrium& equilibrium) {
  const Margin inner = margin(bearing, equilibrium, Race::inner),
               outer = margin(bearing, equilibrium, Race::outer);
  return {
      .inner = inner.angle, .outer = outer.angle, .inner_cut = inner.cut, .outer_cut = outer.cut};
}

PermissibleLoads permissible_axial_loads(const Bearing& bearing) {
  return {.inner = permissible(bearing, Race::inner), .outer = permissible(bearing, Race::outer)};
}

}  // namespace raceway::bearing
