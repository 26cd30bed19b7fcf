#include "bearing/bearing.h"

#include <cmath>

#include "bearing/balls.h"

namespace raceway::bearing {

Bearing::Bearing(const BearingGeometry& geometry, const Material& balls, const Material& rings)
    : geometry_(validated(geometry)), balls_(balls), rings_(rings) {
  const auto contact = [&](Race race) {
    return hertz_contact(groove_curvature(geometry_, race, geometry_.contact_angle), balls_,
                         rings_);
  };
  inner_ = contact(Race::inner);
  outer_ = contact(Race::outer);
  const double d = geometry_.ball_diameter;
  ball_mass_ = balls_.density * pi / 6.0 * d * d * d;
  for (int k = 0; k < geometry_.ball_count; ++k) {
    const double azimuth = azimuth_of_ball(k, geometry_.ball_count);
    azimuth_.push_back(azimuth);
    cos_azimuth_.push_back(std::cos(azimuth));
    sin_azimuth_.push_back(std::sin(azimuth));
  }
}

double Bearing::ball_inertia() const {
  return ball_mass_ * geometry_.ball_diameter * geometry_.ball_diameter / 10.0;
}

}  // namespace raceway::bearing
