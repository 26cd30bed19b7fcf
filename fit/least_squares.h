#pragma once

#include <Eigen/Core>
#include <vector>

namespace raceway::fit {

/// Linear least-squares problem: find the unknowns d that minimise |r - A d|².
class LeastSquares {
 public:
  LeastSquares(const Eigen::MatrixXd& a, const Eigen::VectorXd& r);

  /// Returns the decrease of the sum of squares at `d` relative to d = 0: |r|² - |r - A d|².
  [[nodiscard]] double fall(const Eigen::VectorXd& d) const;

  /// Finds the d that minimises |r - A d|² + damping Σ |A_k|² d_k² within the bounds `lower` <= d
  /// <= `upper`. A_k is column k of A. Returns true if the method converged. An entry of `side` is
  /// -1 for an unknown at its lower bound, 1 at its upper bound, and 0 otherwise.
  bool solve(const Eigen::VectorXd& lower, const Eigen::VectorXd& upper, double damping,
             Eigen::VectorXd& d, std::vector<int>& side) const;

 private:
  Eigen::MatrixXd a_;
  Eigen::VectorXd r_;
};

}  // namespace raceway::fit
