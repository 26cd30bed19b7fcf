#pragma once

#include <Eigen/Core>
#include <vector>

namespace raceway::fit {

/// Returns an orthonormal basis for the columns of several matrices (`blocks`), one matrix after
/// the other. Within a matrix, the next column is always the one with the largest component
/// orthogonal to the basis. A column is left out if the length of this component is below the share
/// `tolerance` of the length of the column; each matrix has its own tolerance. The basis has at
/// most `most` columns, so earlier matrices have priority.
[[nodiscard]] Eigen::MatrixXd independent_columns(const std::vector<Eigen::MatrixXd>& blocks,
                                                  const std::vector<double>& tolerance,
                                                  Eigen::Index most);

/// Returns the columns minus their projection on the columns of `tangent`, which may have any rank.
[[nodiscard]] Eigen::MatrixXd project_off(const Eigen::MatrixXd& tangent,
                                          const Eigen::MatrixXd& columns);

/// Returns an orthonormal basis of the columns.
[[nodiscard]] Eigen::MatrixXd orthonormal(const Eigen::MatrixXd& columns);

}  // namespace raceway::fit
