#pragma once

#include <Eigen/Core>
#include <string>
#include <vector>

namespace raceway::fit {

/// Covariance matrix of parameters that were fitted together. The parameters have the units of the
/// model files.
struct Covariance {
  std::vector<std::string> names;
  Eigen::VectorXd values;  ///< fitted values of the parameters
  Eigen::MatrixXd matrix;  ///< symmetric, positive semidefinite

  /// Returns the standard deviation of one parameter.
  [[nodiscard]] double std(std::size_t parameter) const;
  /// Returns the correlation of two parameters [1]; 0 if a parameter has no variance.
  [[nodiscard]] double correlation(std::size_t first, std::size_t second) const;
};

}  // namespace raceway::fit
