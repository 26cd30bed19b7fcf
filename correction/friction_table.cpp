#include "correction/friction_table.h"

#include <algorithm>
#include <array>
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

double amount_on(const std::vector<double>& axis, double load) {
  return axis.front() < 0.0 ? load : std::abs(load);
}

}  // namespace

double FrictionTable::operator()(const Point& at) const {
  const double all = at.speed + at.axial_load + at.radial_load + at.temperature;
  if (!std::isfinite(all)) return all;
  // From the slowest axis to the fastest.
  const std::array places{place_on(temperature, at.temperature),
                          place_on(radial_load, amount_on(radial_load, at.radial_load)),
                          place_on(axial_load, amount_on(axial_load, at.axial_load)),
                          place_on(speed, at.speed)};
  const std::array sizes{temperature.size(), radial_load.size(), axial_load.size(), speed.size()};
  double sum = 0.0;
  for (std::size_t corner = 0; corner < std::size_t{1} << places.size(); ++corner) {
    double weight = 1.0;
    std::size_t index = 0;
    for (std::size_t k = 0; k < places.size(); ++k) {
      const std::size_t next = corner >> k & 1U;
      weight *= next ? places[k].share : 1.0 - places[k].share;
      index = index * sizes[k] + places[k].at + next;
    }
    if (weight != 0.0) sum += weight * torque[index];
  }
  return sum;
}

bool FrictionTable::holds(const Point& at) const {
  return within(speed, at.speed) && within(axial_load, amount_on(axial_load, at.axial_load)) &&
         within(radial_load, amount_on(radial_load, at.radial_load)) &&
         within(temperature, at.temperature);
}

}  // namespace raceway::correction
