#pragma once

#include <Eigen/Core>
#include <vector>

namespace raceway::fit {

/// Returns a basis of the first block, extended by the parts of later blocks that are independent
/// of it. Columns with the largest remainder come first. A remainder is left out if it is smaller
/// than the share `tolerance` of its column. The basis has at most `most` columns, and earlier
/// blocks have priority.
[[nodiscard]] Eigen::MatrixXd independent_columns(const std::vector<Eigen::MatrixXd>& blocks,
                                                  const std::vector<double>& tolerance,
                                                  Eigen::Index most);

/// Removes from each column its projection on `tangent`, which may have any rank.
[[nodiscard]] Eigen::MatrixXd project_off(const Eigen::MatrixXd& tangent,
                                          const Eigen::MatrixXd& columns);

/// Returns an orthonormal basis of the columns.
[[nodiscard]] Eigen::MatrixXd orthonormal(const Eigen::MatrixXd& columns);

}  // namespace raceway::fit
