#include "bearing/ball_equilibrium.h"

#include <cmath>

namespace raceway::bearing {

double full_centrifugal(const Bearing& bearing, double speed) {
  return 0.5 * bearing.ball_mass() * bearing.geometry().pitch_diameter * speed * speed;
}

BallConstants ball_constants(const Bearing& bearing, double speed, RaceControl race_control,
                             bool gyroscopic_moment) {
  const BearingGeometry& g = bearing.geometry();
  return {{.inner_radius = (g.inner_conformity - 0.5) * g.ball_diameter,
           .outer_radius = (g.outer_conformity - 0.5) * g.ball_diameter,
           .inner_stiffness = bearing.contact(Race::inner).contact_stiffness,
           .outer_stiffness = bearing.contact(Race::outer).contact_stiffness,
           .diameter_ratio = g.diameter_ratio(),
           .full_centrifugal = full_centrifugal(bearing, speed),
           .gyroscopic = gyroscopic_moment ? 1.0 : 0.0},
          race_control};
}

SpringPairOf<double> spring_pair(const BallConstants& c) {
  const double inner_share = std::cbrt(1.0 / (c.inner_stiffness * c.inner_stiffness));
  const double outer_share = std::cbrt(1.0 / (c.outer_stiffness * c.outer_stiffness));
  const double compliance = inner_share + outer_share;
  return {.stiffness = 1.0 / (compliance * std::sqrt(compliance)),
          .outer_share = outer_share / compliance};
}

}  // namespace raceway::bearing
