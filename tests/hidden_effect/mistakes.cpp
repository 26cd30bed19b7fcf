#include "tests/hidden_effect/mistakes.h"

#include <algorithm>
#include <array>
#include <boost/math/tools/roots.hpp>
#include <cmath>

namespace hidden_effect {
namespace {

constexpr double hours_of_a_day = 6.0;  // of measuring: half of a plan of 72 rows

/// Load on the bearing that the preload presses against the external load [N]: both inner rings
/// move by the same way, so that their displacements have the sum that the standing pair has.
double opposed_load(const Bearing& bearing, const Mistake& mistake, const Point& point) {
  constexpr double standing = 1.0, least = 1e-3;
  const double speed = mistake.preload_grows ? point.speed : standing;
  const double apart = 2.0 * bearing.balance(standing, mistake.pair_preload).displacement;
  const auto excess = [&](double load) {
    return bearing.balance(speed, load).displacement +
           bearing.balance(speed, load + point.load).displacement - apart;
  };
  if (excess(least) >= 0.0) return 0.0;  // the external load has lifted it off
  std::uintmax_t steps = 60;
  const auto [a, b] =
      boost::math::tools::toms748_solve(excess, least, 4.0 * mistake.pair_preload + point.load,
                                        boost::math::tools::eps_tolerance<double>(30), steps);
  return 0.5 * (a + b);
}

}  // namespace

double torque_of_rig(const Bearing& bearing, const BaseLaw& law, const Mistake& mistake,
                     const Point& point, std::span<const Hidden> hidden) {
  Point real = point;
  real.load *= 1.0 + mistake.cell_drift * (point.temperature - 22.0);
  if (mistake.pair_preload <= 0.0) return torque(bearing, law, real, hidden);
  Point pressed = real;
  pressed.load = opposed_load(bearing, mistake, real);
  real.load += pressed.load;
  // A bearing without load still drags its oil.
  pressed.load = std::max(pressed.load, 1.0);
  return torque(bearing, law, real, hidden) + torque(bearing, law, pressed, hidden);
}

double rms_torque(std::span<const Reading> rows) {
  double square = 0.0;
  for (const Reading& r : rows) square += r.torque * r.torque;
  return std::sqrt(square / static_cast<double>(rows.size()));
}

double share_of_day(double time) {
  return std::fmod(time / 3600.0, hours_of_a_day) / hours_of_a_day;
}

void misread_torques(const Mistake& m, std::uint64_t seed, std::vector<Reading>& rows) {
  if (m.support_constant == 0.0 && m.support_viscous == 0.0 && m.creep == 0.0 && m.reset == 0.0 &&
      m.hysteresis == 0.0)
    return;
  Random random(0x51ed270b0a1f39c1ULL * (seed + 3));
  const double size = rms_torque(rows);
  double highest = 0.0;
  for (const Reading& r : rows) highest = std::max(highest, r.point.speed);
  double zero = m.reset * normal(random), side = 1.0;
  for (std::size_t i = 0; i < rows.size(); ++i) {
    Reading& r = rows[i];
    const bool first = i == 0 || rows[i - 1].run != r.run;
    if (i > 0 && first) zero = m.reset * normal(random);
    if (first || r.point.speed > rows[i - 1].point.speed)
      side = 1.0;
    else if (r.point.speed < rows[i - 1].point.speed)
      side = -1.0;
    r.torque +=
        size * (m.support_constant + m.support_viscous * std::sqrt(r.point.speed / highest) +
                m.creep * share_of_day(r.point.time) + zero + 0.5 * m.hysteresis * side);
  }
}

void read_temperatures(const Mistake& mistake, bool logger, Random& random,
                       std::vector<Reading>& rows) {
  constexpr double room = 24.0;
  for (Reading& r : rows) {
    r.seen = r.point.temperature;
    if (logger) r.seen += 0.05 * normal(random);
    if (mistake.rise_seen != 1.0) r.seen = room + mistake.rise_seen * (r.seen - room);
    r.seen += mistake.sensor_offset;
    if (mistake.sensor_scatter > 0.0) r.seen += mistake.sensor_scatter * normal(random);
    if (mistake.in_fahrenheit) r.seen = 1.8 * r.seen + 32.0;
  }
}

}  // namespace hidden_effect
