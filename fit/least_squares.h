#pragma once

#include <Eigen/Core>
#include <vector>

namespace raceway::fit {

/// Linear least-squares problem min |r - A d|². A and r are stored in an equivalent form with at
/// most as many rows as unknowns.
class LeastSquares {
 public:
  LeastSquares(const Eigen::MatrixXd& a, const Eigen::VectorXd& r);

  /// Returns the fall of the sum of squares by the step `d`: |r|² - |r - A d|².
  [[nodiscard]] double fall(const Eigen::VectorXd& d) const;

  /// Finds the minimum of |r - A d|² + damping Σ |A_k|² d_k² for d within [lower, upper] by an
  /// active-set method; A_k is column k of A. Returns true if the method converged. `side` is -1
  /// for an unknown at its lower bound, 1 at its upper bound, and 0 otherwise.
  bool solve(const Eigen::VectorXd& lower, const Eigen::VectorXd& upper, double damping,
             Eigen::VectorXd& d, std::vector<int>& side) const;

 private:
  Eigen::MatrixXd a_;
  Eigen::VectorXd r_;
};

}  // namespace raceway::fit
