#pragma once

#include <cmath>

#include "bearing/bearing_equilibrium.h"
#include "bearing/kinematics.h"
#include "bearing/roller_bearing.h"

namespace raceway::bearing {

/// Damage frequencies of a bearing per shaft revolution [1]. Multiply by the revolutions of the
/// shaft per second to get Hz. ω is the shaft speed, ω_m the orbital speed of the Z balls or
/// rollers, and ω_R the speed of a ball or roller about its own axis.
struct BearingFrequencies {
  double cage = unset;        ///< FTF, cage frequency with a stationary outer ring: ω_m/ω
  double outer_race = unset;  ///< BPFO, ball passes at a point of the outer race: Z ω_m/ω
  double inner_race = unset;  ///< BPFI, ball passes at a point of the inner race: Z (1 - ω_m/ω)
  /// BSF, revolutions of a ball about its own axis, seen from the cage: ω_R/ω. A defect of the ball
  /// strikes the races at twice this frequency.
  double ball_spin = unset;
  [[nodiscard]] bool operator==(const BearingFrequencies&) const = default;
};

/// Damage frequencies for the same contact angle α at both races, as in catalogues.
///
///   FTF = (1 - g cos α)/2,   BSF = (1 - g² cos² α)/(2 g),   g = D/d_m
///
/// Source: rolling without slip. ball_speeds() gives the same FTF at αi = αo. The BSF of this
///         function is the rolling component ω_R cos(α - β) of the ball speed ω_R, divided by ω. β
///         is the pitch angle of the ball axis. running_frequencies() uses ω_R/ω instead.
/// Domain: g cos α < 1.
[[nodiscard]] inline BearingFrequencies nominal_frequencies(int count, double diameter_ratio,
                                                            double contact_angle) {
  const double ratio = diameter_ratio, x = ratio * std::cos(contact_angle);
  const double cage = 0.5 * (1.0 - x);
  return {.cage = cage,
          .outer_race = count * cage,
          .inner_race = count * (1.0 - cage),
          .ball_spin = 0.5 * (1.0 - x * x) / ratio};
}
[[nodiscard]] inline BearingFrequencies nominal_frequencies(const BearingGeometry& g,
                                                            double contact_angle) {
  return nominal_frequencies(g.ball_count, g.diameter_ratio(), contact_angle);
}

/// Damage frequencies of cylindrical rollers that roll without slip: nominal_frequencies() at
/// α = 0.
[[nodiscard]] inline BearingFrequencies rolling_frequencies(const RollerGeometry& g) {
  return nominal_frequencies(g.roller_count, g.diameter_ratio(), 0.0);
}

/// Damage frequencies from the contact angles of the balls in operation. The results are means over
/// the balls with a load at the outer race: under radial load, the orbital speeds of the balls
/// differ, and the cage averages these speeds.
///
/// Domain: converged equilibrium with at least one loaded ball; otherwise the results are NaN. For
///         an equilibrium at standstill, the results are the limit for slow rotation.
[[nodiscard]] inline BearingFrequencies running_frequencies(const Bearing& bearing,
                                                            const BearingEquilibrium& equilibrium,
                                                            RaceControl control) {
  if (!equilibrium.report.converged()) return {};
  double cage = 0.0, spin = 0.0, count = 0.0;
  const Balls& balls = equilibrium.balls;
  for (std::size_t k = 0; k < balls.distinct().size(); ++k) {
    if (!(balls.distinct()[k].outer_load > 0.0)) continue;
    const BallSpeeds v = equilibrium.speeds(k, bearing, 1.0, control);
    cage += balls.weight(k) * v.cage_speed;
    spin += balls.weight(k) * v.ball_speed;
    count += balls.weight(k);
  }
  cage /= count;
  const double Z = bearing.geometry().ball_count;
  return {.cage = cage,
          .outer_race = Z * cage,
          .inner_race = Z * (1.0 - cage),
          .ball_spin = spin / count};
}

}  // namespace raceway::bearing
