#include "bearing/ball_equilibrium.h"

#include <cmath>

namespace raceway::bearing {

BallConstants ball_constants(const Bearing& bearing, double speed, RaceControl race_control,
                             bool gyroscopic_moment) {
  const BearingGeometry& g = bearing.geometry();
  return {.inner_radius = (g.inner_conformity - 0.5) * g.ball_diameter,
          .outer_radius = (g.outer_conformity - 0.5) * g.ball_diameter,
          .inner_stiffness = bearing.contact(Race::inner).contact_stiffness,
          .outer_stiffness = bearing.contact(Race::outer).contact_stiffness,
          .diameter_ratio = g.diameter_ratio(),
          .full_centrifugal = 0.5 * bearing.ball_mass() * g.pitch_diameter * speed * speed,
          .gyroscopic = gyroscopic_moment ? 1.0 : 0.0,
          .race_control = race_control};
}

StaticBall static_ball(const BallConstants& c, Plane a) {
  const double length = std::sqrt(a.axial * a.axial + a.radial * a.radial);
  const double s = length > 0.0 ? a.axial / length : 0.0;
  const double co = length > 0.0 ? a.radial / length : 1.0;
  const double inner_share = std::cbrt(1.0 / (c.inner_stiffness * c.inner_stiffness));
  const double outer_share = std::cbrt(1.0 / (c.outer_stiffness * c.outer_stiffness));
  const double compliance = inner_share + outer_share;
  const double stiffness = 1.0 / (compliance * std::sqrt(compliance));
  const double free_length = c.inner_radius + c.outer_radius;
  const double delta = length - free_length;

  StaticBall b{};
  // Without contact the ball lies where it likes; this keeps it between the grooves.
  const double outer_length = delta > 0.0 ? c.outer_radius + delta * outer_share / compliance
                                          : length * c.outer_radius / free_length;
  b.ball_centre = {outer_length * s, outer_length * co};
  if (delta <= 0.0) return b;
  const double root = std::sqrt(delta);
  const double along = 1.5 * stiffness * root;
  b.load = stiffness * delta * root;
  b.force = {b.load * s, b.load * co};
  const double across = b.load / length;
  b.f_a[0] = along * s * s + across * co * co;
  b.f_a[1] = b.f_a[2] = (along - across) * s * co;
  b.f_a[3] = along * co * co + across * s * s;
  return b;
}

}  // namespace raceway::bearing
