#pragma once

#include <Eigen/Core>
#include <string>
#include <vector>

namespace raceway::fit {

/// Covariance of parameters fitted together, in the units of the files.
struct Covariance {
  std::vector<std::string> names;
  Eigen::VectorXd values;  ///< to which it belongs
  Eigen::MatrixXd matrix;  ///< symmetric, positive semidefinite

  /// Standard deviation of one of them.
  [[nodiscard]] double std(std::size_t parameter) const;
  /// Correlation of two parameters [1]; 0 where one has no variance.
  [[nodiscard]] double correlation(std::size_t first, std::size_t second) const;
};

}  // namespace raceway::fit
