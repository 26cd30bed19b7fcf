#pragma once

#include <Eigen/Core>
#include <vector>

namespace raceway::fit {

/// A basis of the first block, then of what later ones add to it, each column by its largest
/// remainder: a remainder below `tolerance` of the column is not counted. At most `most` columns;
/// later blocks get what earlier ones left.
[[nodiscard]] Eigen::MatrixXd independent_columns(const std::vector<Eigen::MatrixXd>& blocks,
                                                  const std::vector<double>& tolerance,
                                                  Eigen::Index most);

/// Columns without their part along `tangent`, which has any rank.
[[nodiscard]] Eigen::MatrixXd project_off(const Eigen::MatrixXd& tangent,
                                          const Eigen::MatrixXd& columns);

/// A basis of the columns.
[[nodiscard]] Eigen::MatrixXd orthonormal(const Eigen::MatrixXd& columns);

}  // namespace raceway::fit
