#include "bearing/rigid_preload.h"

#include <boost/math/tools/roots.hpp>
#include <cmath>
#include <cstdint>

#include "bearing/ring_balance.h"
#include "bearing/thrust_start.h"

namespace raceway::bearing {

double relieved_thrust(const Bearing& bearing, double preload, double load, double speed) {
  constexpr double least = 1e-6;  // of the preload
  constexpr int bits = 30, most_doublings = 30;
  const EquilibriumOptions options{.race_control = RaceControl::outer};
  const Plane free = unloaded_point(bearing, options).free;
  const auto balls = static_cast<double>(bearing.geometry().ball_count);
  const auto displacement = [&](double thrust, double at) {
    ThrustStart<double> start;
    const BallConstants constants = ball_constants(bearing, at, RaceControl::outer, true);
    return thrust_start(RaceControl::outer, constants, free, thrust / balls, start)
               ? start.axial_displacement
               : unset;
  };
  const double apart = 2.0 * displacement(preload, 0.0);
  // A displacement goes with the thrust to the power of 2/3.
  const auto excess = [&](double root) {
    const double thrust = std::pow(root, 1.5);
    return displacement(thrust, speed) + displacement(thrust + load, speed) - apart;
  };
  const double one = std::cbrt(preload * preload);
  double low = std::pow(least, 2.0 / 3.0) * one, at_low = excess(low);
  if (at_low >= 0.0) return 0.0;
  double high = one, at_high = excess(high);
  for (int k = 0; k < most_doublings && at_high < 0.0; ++k) {
    low = high, at_low = at_high;
    high *= 2.0;
    at_high = excess(high);
  }
  if (!(at_low < 0.0 && at_high >= 0.0)) return unset;
  std::uintmax_t steps = 40;
  const auto [a, b] = boost::math::tools::toms748_solve(
      excess, low, high, at_low, at_high, boost::math::tools::eps_tolerance<double>(bits), steps);
  return std::pow(0.5 * (a + b), 1.5);
}

}  // namespace raceway::bearing
