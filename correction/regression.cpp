#include "correction/regression.h"

#include <cmath>
#include <stdexcept>

#include "algebra/detail/decompositions.h"

namespace raceway::correction {

Regression regress(const Eigen::MatrixXd& columns, const Eigen::VectorXd& readings) {
  if (columns.rows() < columns.cols())
    throw std::invalid_argument("a regression needs at least as many rows as columns");
  const algebra::PivotedQr qr(columns);
  if (qr.rank() < columns.cols())
    throw std::invalid_argument("columns of the regression are linearly dependent");
  Regression result;
  result.coefficients = qr.solve(readings);
  result.rms = (readings - columns * result.coefficients).norm() /
               std::sqrt(static_cast<double>(readings.size()));
  // Of R rather than of the columns: the same singular values of a small matrix.
  const Eigen::VectorXd singular = algebra::singular_values(qr.R());
  result.condition = singular(0) / singular(singular.size() - 1);
  return result;
}

double sister_scale(const Eigen::VectorXd& measured, const Eigen::VectorXd& rest,
                    const Eigen::VectorXd& spindle) {
  return (measured - rest).dot(spindle) / spindle.squaredNorm();
}

}  // namespace raceway::correction
