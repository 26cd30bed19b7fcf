#pragma once

#include <Eigen/Core>
#include <vector>

namespace raceway::fit {

/// Linear least-squares problem min |r - A d|², reduced to as many rows as columns.
class LeastSquares {
 public:
  LeastSquares(const Eigen::MatrixXd& a, const Eigen::VectorXd& r);

  /// Returns |r|² minus the misfit that remains with `d`.
  [[nodiscard]] double fall(const Eigen::VectorXd& d) const;

  /// Finds the minimum of |r - A d|² + damping Σ |A_k|² d_k² for d within [lower, upper] by an
  /// active-set method. Returns true if the method converged. `side` gives the bound at which each
  /// parameter is held.
  bool solve(const Eigen::VectorXd& lower, const Eigen::VectorXd& upper, double damping,
             Eigen::VectorXd& d, std::vector<int>& side) const;

 private:
  Eigen::MatrixXd a_;
  Eigen::VectorXd r_;
};

}  // namespace raceway::fit
