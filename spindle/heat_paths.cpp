#include "spindle/heat_paths.h"

#include <algorithm>

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

ConductanceMatrix::ConductanceMatrix(const HeatPaths& paths) : matrix_(paths.size(), paths.size()) {
  std::vector<Eigen::Triplet<double>> pattern;
  for (int k = 0; k < paths.size(); ++k) pattern.emplace_back(k, k, 1.0);
  for (const HeatPaths::Link& way : paths.links)
    pattern.emplace_back(std::max(way.first, way.second), std::min(way.first, way.second), 1.0);
  matrix_.setFromTriplets(pattern.begin(), pattern.end());
  matrix_.makeCompressed();
  const auto place = [&](int row, int column) -> Eigen::Index {
    return &matrix_.coeffRef(row, column) - matrix_.valuePtr();
  };
  for (int k = 0; k < paths.size(); ++k) diagonal_.push_back(place(k, k));
  for (const HeatPaths::Link& way : paths.links)
    links_.push_back({diagonal_[static_cast<std::size_t>(way.first)],
                      diagonal_[static_cast<std::size_t>(way.second)],
                      place(std::max(way.first, way.second), std::min(way.first, way.second))});
}

const SparseMatrix& ConductanceMatrix::fill(const HeatPaths& paths, double capacity_factor) {
  double* const values = matrix_.valuePtr();
  std::fill(values, values + matrix_.nonZeros(), 0.0);
  for (std::size_t k = 0; k < diagonal_.size(); ++k)
    values[diagonal_[k]] = capacity_factor * paths.capacity[static_cast<Eigen::Index>(k)];
  for (std::size_t k = 0; k < links_.size(); ++k) {
    const double g = paths.links[k].conductance;
    values[links_[k].first] += g;
    values[links_[k].second] += g;
    values[links_[k].off] -= g;
  }
  for (const HeatPaths::Outlet& way : paths.outlets)
    values[diagonal_[static_cast<std::size_t>(way.node)]] += way.conductance;
  return matrix_;
}

}  // namespace raceway::spindle
