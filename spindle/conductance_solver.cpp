#include "spindle/conductance_solver.h"

#include <Eigen/OrderingMethods>
#include <algorithm>

namespace raceway::spindle {

ConductanceSolver::ConductanceSolver(const HeatPaths& paths) : matrix_(paths.size(), paths.size()) {
  std::vector<Eigen::Triplet<double>> entries;
  for (int k = 0; k < paths.size(); ++k) entries.emplace_back(k, k, 1.0);
  for (const HeatPaths::Link& way : paths.links) entries.emplace_back(way.first, way.second, 1.0);
  matrix_.setFromTriplets(entries.begin(), entries.end());
  Eigen::PermutationMatrix<Eigen::Dynamic> by_place;
  Eigen::AMDOrdering<int>()(matrix_, by_place);
  order_ = by_place.inverse();
  const auto at = [&](int body) { return order_.indices()[body]; };
  entries.clear();
  for (int k = 0; k < paths.size(); ++k) entries.emplace_back(k, k, 1.0);
  for (const HeatPaths::Link& way : paths.links) {
    const auto [low, high] = std::minmax({at(way.first), at(way.second)});
    entries.emplace_back(low, high, 0.0);
  }
  matrix_.setFromTriplets(entries.begin(), entries.end());
  const auto place = [&](int row, int column) -> Eigen::Index {
    return &matrix_.coeffRef(row, column) - matrix_.valuePtr();
  };
  for (int k = 0; k < paths.size(); ++k) diagonal_.push_back(place(at(k), at(k)));
  for (const HeatPaths::Link& way : paths.links) {
    const auto [low, high] = std::minmax({at(way.first), at(way.second)});
    links_.push_back({diagonal_[static_cast<std::size_t>(way.first)],
                      diagonal_[static_cast<std::size_t>(way.second)], place(low, high)});
  }
  ldlt_.analyzePattern(matrix_);
}

bool ConductanceSolver::factorise(const HeatPaths& paths, double capacity_factor) {
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
  ldlt_.factorize(matrix_);
  if (ldlt_.info() != Eigen::Success) return false;
  inverse_ = ldlt_.vectorD();
  if (!(inverse_.array() > 0.0).all()) return false;
  inverse_ = inverse_.cwiseInverse();
  return true;
}

}  // namespace raceway::spindle
