#pragma once

#include <cmath>

#include "bearing/ball_equilibrium.h"
#include "bearing/bearing_equilibrium.h"

namespace raceway::bearing {

/// The report of a ball in balance at X within a groove centred at A; the azimuth is left open.
[[nodiscard]] inline BallEquilibrium ball_report(const BallForces& f, Plane a, Plane x,
                                                 bool at_rest, double ball_diameter) {
  BallEquilibrium ball;
  const bool touches = f.inner_load > 0.0;
  if (at_rest) {
    if (touches)
      ball.inner_contact_angle = ball.outer_contact_angle = std::atan2(a.axial, a.radial);
  } else {
    ball.outer_contact_angle = std::atan2(x.axial, x.radial);
    if (touches) ball.inner_contact_angle = std::atan2(a.axial - x.axial, a.radial - x.radial);
  }
  ball.inner_load = f.inner_load;
  ball.outer_load = f.outer_load;
  ball.inner_friction = f.inner_friction;
  ball.outer_friction = f.outer_friction;
  ball.centrifugal_force = f.centrifugal;
  // λo is 1 where the inner race shares the couple, else 2.
  const double share = f.inner_friction != 0.0 ? 1.0 : 0.5;
  ball.gyroscopic_moment = share * f.outer_friction * ball_diameter;
  return ball;
}

}  // namespace raceway::bearing
