#include "correction/friction_table.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace raceway::correction {
namespace {

/// The point of an axis below a value, and how far it is to the next one.
struct Place {
  std::size_t at;
  double share;
};

Place place_on(const std::vector<double>& axis, double value) {
  if (axis.size() < 2 || value <= axis.front()) return {0, 0.0};
  if (value >= axis.back()) return {axis.size() - 2, 1.0};
  const auto above = std::upper_bound(axis.begin(), axis.end(), value);
  const auto at = static_cast<std::size_t>(above - axis.begin()) - 1;
  return {at, (value - axis[at]) / (axis[at + 1] - axis[at])};
}

bool within(const std::vector<double>& axis, double value) {
  return axis.size() < 2 || (value >= axis.front() && value <= axis.back());
}

}  // namespace

double FrictionTable::operator()(double of_speed, double load, double of_temperature) const {
  if (!std::isfinite(of_speed + load + of_temperature)) return of_speed + load + of_temperature;
  const Place s = place_on(speed, of_speed), l = place_on(axial_load, load),
              t = place_on(temperature, of_temperature);
  double sum = 0.0;
  for (std::size_t corner = 0; corner < 8; ++corner) {
    const bool i = corner & 1U, j = corner & 2U, k = corner & 4U;
    const double weight = (i ? s.share : 1.0 - s.share) * (j ? l.share : 1.0 - l.share) *
                          (k ? t.share : 1.0 - t.share);
    if (weight == 0.0) continue;
    sum += weight * torque[((t.at + k) * axial_load.size() + l.at + j) * speed.size() + s.at + i];
  }
  return sum;
}

bool FrictionTable::holds(double of_speed, double load, double of_temperature) const {
  return within(speed, of_speed) && within(axial_load, load) && within(temperature, of_temperature);
}

}  // namespace raceway::correction
