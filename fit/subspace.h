#pragma once

#include <Eigen/Core>
#include <vector>

namespace raceway::fit {

/// Returns an orthonormal basis of the columns of all blocks, built block by block. In a block, the
/// column with the largest part that is independent of the basis comes first. A column is left out
/// if this part is smaller than the share `tolerance` of the column; each block has its own
/// tolerance. The basis has at most `most` columns, so earlier blocks have priority.
[[nodiscard]] Eigen::MatrixXd independent_columns(const std::vector<Eigen::MatrixXd>& blocks,
                                                  const std::vector<double>& tolerance,
                                                  Eigen::Index most);

/// Removes from each column its projection on `tangent`, which may have any rank.
[[nodiscard]] Eigen::MatrixXd project_off(const Eigen::MatrixXd& tangent,
                                          const Eigen::MatrixXd& columns);

/// Returns an orthonormal basis of the columns.
[[nodiscard]] Eigen::MatrixXd orthonormal(const Eigen::MatrixXd& columns);

}  // namespace raceway::fit
