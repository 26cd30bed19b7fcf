#include "spindle/heat_paths.h"

namespace raceway::spindle {

std::array<double, reservoirs> HeatPaths::outflow(const Vector& temperatures) const {
  std::array<double, reservoirs> sum{};
  for (const Outlet& way : outlets)
    sum[static_cast<std::size_t>(way.reservoir)] +=
        way.conductance * (temperatures[way.node] - way.outside(temperature));
  return sum;
}

Vector HeatPaths::constant_inflow() const {
  Vector sum = source;
  for (const Outlet& way : outlets) sum[way.node] += way.conductance * way.outside(temperature);
  return sum;
}

Vector HeatPaths::inflow(const Vector& temperatures) const {
  Vector sum = source;
  for (const Link& way : links) {
    const double flow = way.conductance * (temperatures[way.second] - temperatures[way.first]);
    sum[way.first] += flow;
    sum[way.second] -= flow;
  }
  for (const Outlet& way : outlets)
    sum[way.node] += way.conductance * (way.outside(temperature) - temperatures[way.node]);
  return sum;
}

}  // namespace raceway::spindle
