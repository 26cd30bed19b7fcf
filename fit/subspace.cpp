#include "fit/subspace.h"

#include "algebra/detail/decompositions.h"

namespace raceway::fit {

namespace {

constexpr double rank_tolerance = 1e-7;

}  // namespace

Eigen::MatrixXd orthonormal(const Eigen::MatrixXd& columns) {
  if (columns.cols() == 0) return Eigen::MatrixXd(columns.rows(), 0);
  Eigen::MatrixXd scaled = columns;
  for (Eigen::Index k = 0; k < scaled.cols(); ++k) {
    const double norm = scaled.col(k).norm();
    if (norm > 0.0) scaled.col(k) /= norm;
  }
  return algebra::PivotedQr(scaled, rank_tolerance).column_space();
}

Eigen::MatrixXd independent_columns(const std::vector<Eigen::MatrixXd>& blocks,
                                    const std::vector<double>& tolerance, Eigen::Index most) {
  const Eigen::Index rows = blocks.front().rows();
  Eigen::MatrixXd basis(rows, most);
  Eigen::Index count = 0;
  for (std::size_t b = 0; b < blocks.size(); ++b) {
    Eigen::MatrixXd rest = blocks[b];
    for (Eigen::Index k = 0; k < rest.cols(); ++k) {
      const double norm = rest.col(k).norm();
      if (norm > 0.0) rest.col(k) /= norm;
    }
    for (int pass = 0; pass < 2 && count > 0; ++pass)
      rest -= basis.leftCols(count) * (basis.leftCols(count).transpose() * rest);
    while (count < most && rest.cols() > 0) {
      Eigen::Index largest = 0;
      const double norm = rest.colwise().norm().maxCoeff(&largest);
      if (!(norm > tolerance[b])) break;
      basis.col(count) = rest.col(largest) / norm;
      for (int pass = 0; pass < 2; ++pass)
        basis.col(count) -=
            basis.leftCols(count) * (basis.leftCols(count).transpose() * basis.col(count)).eval();
      basis.col(count).normalize();
      rest -= basis.col(count) * (basis.col(count).transpose() * rest);
      ++count;
    }
  }
  return basis.leftCols(count);
}

Eigen::MatrixXd project_off(const Eigen::MatrixXd& tangent, const Eigen::MatrixXd& columns) {
  const Eigen::MatrixXd q = orthonormal(tangent);
  Eigen::MatrixXd result = columns - q * (q.transpose() * columns);
  result -= q * (q.transpose() * result);  // again, for orthogonality to rounding
  return result;
}

}  // namespace raceway::fit
