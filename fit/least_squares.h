#pragma once

#include <Eigen/Core>
#include <vector>

namespace raceway::fit {

/// The problem min |r - A d|², reduced to as many rows as it has columns.
class LeastSquares {
 public:
  LeastSquares(const Eigen::MatrixXd& a, const Eigen::VectorXd& r);

  /// |r|² less what `d` leaves of it.
  [[nodiscard]] double fall(const Eigen::VectorXd& d) const;

  /// The minimum for d within [lower, upper], or of |r - A d|² + damping Σ |A_k|² d_k², by an
  /// active set; returns whether it settled. `side` says which are held at which bound.
  bool solve(const Eigen::VectorXd& lower, const Eigen::VectorXd& upper, double damping,
             Eigen::VectorXd& d, std::vector<int>& side) const;

 private:
  Eigen::MatrixXd a_;
  Eigen::VectorXd r_;
};

}  // namespace raceway::fit
