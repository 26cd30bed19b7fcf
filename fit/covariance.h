#pragma once

#include <Eigen/Core>
#include <string>
#include <vector>

namespace raceway::fit {

/// How sure parameters that were fitted together are, in the units of the files.
struct Covariance {
  std::vector<std::string> names;
  Eigen::VectorXd values;  ///< to which it belongs
  Eigen::MatrixXd matrix;  ///< symmetric, positive semidefinite

  /// Standard deviation of one of them.
  [[nodiscard]] double std(std::size_t parameter) const;
  /// Of two of them [1]; 0 where one does not scatter.
  [[nodiscard]] double correlation(std::size_t first, std::size_t second) const;
};

}  // namespace raceway::fit
