#pragma once

#include <Eigen/Core>
#include <vector>

namespace raceway::fit {

/// Returns an orthonormal basis for the columns of the matrices `blocks`. The columns of the first
/// matrix are added first, then the columns of the second, and so on. The columns are scaled to
/// length 1. Within a matrix, the function next adds the column with the longest component
/// orthogonal to the basis. Columns whose orthogonal component is not longer than the tolerance of
/// the matrix are left out. `tolerance` contains one number for each matrix. `most` is the largest
/// number of columns of the basis.
[[nodiscard]] Eigen::MatrixXd independent_columns(const std::vector<Eigen::MatrixXd>& blocks,
                                                  const std::vector<double>& tolerance,
                                                  Eigen::Index most);

/// Returns `columns` minus their projection on the columns of `tangent`. `tangent` may have any
/// rank.
[[nodiscard]] Eigen::MatrixXd project_off(const Eigen::MatrixXd& tangent,
                                          const Eigen::MatrixXd& columns);

/// Returns an orthonormal basis of the space that the columns span.
[[nodiscard]] Eigen::MatrixXd orthonormal(const Eigen::MatrixXd& columns);

}  // namespace raceway::fit
