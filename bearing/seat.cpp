#include "bearing/seat.h"

#include <cmath>

namespace raceway::bearing {

std::string_view name(Seat seat) {
  switch (seat) {
    case Seat::shoulder:
      return "shoulder";
    case Seat::groove_bottom:
      return "groove_bottom";
    case Seat::far_side:
      return "far_side";
  }
  return "shoulder";
}

Seat seat(double least_inner_angle, double largest_inner_angle, double contact_angle) {
  const double none = 0.1 * contact_angle;
  if (!(contact_angle > 0.0)) return Seat::shoulder;
  if (least_inner_angle < -none) return Seat::far_side;
  return largest_inner_angle < none ? Seat::groove_bottom : Seat::shoulder;
}

Seat seat(const BearingEquilibrium& equilibrium, const BearingGeometry& geometry) {
  double least = unset, largest = unset;
  for (const BallEquilibrium& b : equilibrium.balls.distinct()) {
    least = std::fmin(least, b.inner_contact_angle);
    largest = std::fmax(largest, b.inner_contact_angle);
  }
  return seat(least, largest, geometry.contact_angle);
}

double seating_load(double radial_load, double contact_angle) {
  return 0.2782 / 0.2288 * radial_load * std::tan(contact_angle);
}

}  // namespace raceway::bearing
