#include "friction/contact/contact_law.h"

#include <algorithm>
#include <cmath>

#include "friction/contact/balanced_equilibrium.h"
#include "friction/contact/detail/contact_sums.h"
#include "friction/friction_law.h"
#include "friction/lubricant.h"

namespace raceway::friction::contact {
namespace {

constexpr double drag_coefficient = 0.45;  // of a sphere at high Reynolds number [1]

}  // namespace

ContactLaw contact_law(const ContactData& data, std::span<const double> values) {
  return {.supply = data.supply,
          .replenishment = values[4],
          .inlet_over_b = data.inlet_over_b,
          .boundary_friction = values[2],
          .limiting_traction = values[3],
          .eyring_stress = data.eyring_stress,
          .composite_roughness = std::hypot(data.race_roughness, data.ball_roughness),
          .asperities = data.asperities,
          .rolling_factor = values[0],
          .hysteresis_factor = values[1]};
}

OilState oil_of(const BearingState<double>& s) {
  OilState oil = oil_state(*s.lubricant, s.contact->oil, s.temperature);
  if (oil.kinematic_viscosity == s.kinematic_viscosity) return oil;
  oil.kinematic_viscosity = s.kinematic_viscosity;
  oil.viscosity = oil.density * s.kinematic_viscosity;
  if (std::isnan(s.contact->oil.pressure_viscosity))
    oil.pressure_viscosity = pressure_viscosity(s.contact->oil.type, s.kinematic_viscosity);
  return oil;
}

double ball_drag(const BearingState<double>& s, double density, double oil_fraction) {
  if (!(oil_fraction > 0.0) || !(s.speed > 0.0)) return 0.0;
  const bearing::BearingGeometry& g = s.bearing->geometry();
  const bearing::Balls& balls = s.equilibrium->balls;
  const double area = 0.25 * pi * g.ball_diameter * g.ball_diameter;
  double cubes = 0.0;
  for (std::size_t k = 0; k < balls.distinct().size(); ++k) {
    const double cage = s.equilibrium->speeds(k, *s.bearing, s.speed, s.race_control).cage_speed;
    const double orbit = 0.5 * cage * g.pitch_diameter;
    cubes += balls.weight(k) * orbit * orbit * orbit;
  }
  return 0.5 * drag_coefficient * density * oil_fraction * area * cubes / s.speed;
}

HeatSplit ring_heat(const ContactResult& r, double speed) {
  return {.inner = power_loss(r.friction.inner.sum() + 0.5 * r.drag, speed),
          .outer = power_loss(r.friction.outer.sum() + 0.5 * r.drag, speed)};
}

bool ContactResult::rescales(std::span<const double> from, std::span<const double> to) {
  for (const std::size_t factor : {0, 1})
    if (from[factor] != to[factor] && !(from[factor] > 0.0)) return false;
  return std::equal(from.begin() + 2, from.end(), to.begin() + 2, to.end());
}

void ContactResult::rescale(std::span<const double> from, std::span<const double> to) {
  if (from[0] != to[0]) thin(to[0] / from[0]);
  if (from[1] == to[1]) return;
  friction.inner.hysteresis *= to[1] / from[1];
  friction.outer.hysteresis *= to[1] / from[1];
}

ContactResult contact_result(const BearingState<double>& s, std::span<const double> values,
                             std::vector<BallFriction>* balls_out) {
  ContactResult r;
  if (balls_out) balls_out->clear();
  if (s.equilibrium == nullptr || !s.equilibrium->report.converged()) {
    r.friction.inner = r.friction.outer = {unset, unset, unset};
    return r;
  }
  const OilState oil = oil_of(s);
  ContactSums sums;
  const ContactLaw law = contact_law(*s.contact, values);
  const auto look = [&](std::size_t ball, bearing::Race race, const ContactFriction& c,
                        double weight) {
    const bearing::BallEquilibrium& b = s.equilibrium->balls.distinct()[ball];
    const bool inner = race == bearing::Race::inner;
    sums.add(c.mean_slip, c.mean_friction, inner ? b.inner_load : b.outer_load,
             inner ? b.inner_friction : b.outer_friction, weight);
    if (!balls_out) return;
    balls_out->resize(std::max(balls_out->size(), ball + 1));
    (inner ? (*balls_out)[ball].inner : (*balls_out)[ball].outer) = c;
  };
  r.friction =
      s.equilibrium->rotations.empty()
          ? bearing_friction(*s.bearing, *s.equilibrium, s.race_control, s.speed, oil, law, look)
          : balanced_friction(*s.bearing, *s.equilibrium, s.speed, oil, law, look);
  r.drag = ball_drag(s, oil.density, values[5]);
  sums.give(r);
  return r;
}

BaseMoments<double> contact_moments(const BearingState<double>& state,
                                    std::span<const double> values) {
  return contact_result(state, values).moments();
}

}  // namespace raceway::friction::contact
