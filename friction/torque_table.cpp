#include "friction/torque_table.h"

#include <cmath>
#include <sstream>
#include <vector>

#include "record/units.h"

namespace raceway::friction {

TablePosition TorqueTable::position(const BearingState<>& s) const {
  const TableAxes& axes = grid.axes;
  return {.speed = s.speed,
          .axial_load = has_axial_load ? std::abs(s.axial_load) : axes.axial_load.front(),
          .radial_load = has_radial_load ? s.radial_load : axes.radial_load.front(),
          .temperature = has_temperature ? s.temperature : axes.temperature.front()};
}

double TorqueTable::value(const StribeckTable& of, const BearingState<>& s) const {
  const TablePosition at = position(s);
  if (!std::isfinite(at.speed + at.axial_load + at.radial_load + at.temperature)) return unset;
  return interpolate(of, at, Outside::clamp).friction_moment;
}

bool TorqueTable::holds(const BearingState<>& s) const {
  return !interpolate(grid, position(s), Outside::clamp).clamped;
}

std::string TorqueTable::range() const {
  std::ostringstream text;
  const auto add = [&](const std::vector<double>& axis, const char* unit, double scale,
                       double offset) {
    if (text.tellp() > 0) text << ", ";
    if (axis.size() > 1) text << (axis.front() - offset) / scale << " to ";
    text << (axis.back() - offset) / scale << ' ' << unit;
  };
  add(grid.axes.speed, "rpm", rpm, 0.0);
  if (has_axial_load) add(grid.axes.axial_load, "N axial", 1.0, 0.0);
  if (has_radial_load) add(grid.axes.radial_load, "N radial", 1.0, 0.0);
  if (has_temperature) add(grid.axes.temperature, "C", 1.0, celsius_zero);
  return text.str();
}

}  // namespace raceway::friction
