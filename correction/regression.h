#pragma once

#include <Eigen/Core>

#include "record/units.h"

namespace raceway::correction {

/// Multiple linear regression: a displacement as a linear combination of present temperatures. Many
/// controls use this model. In raceway, it is a baseline for comparison.
struct Regression {
  Eigen::VectorXd coefficients{};  ///< one coefficient for each column
  double rms = unset;              ///< rms residual, in the unit of the readings
  /// Condition number [1]: ratio of the largest to the smallest singular value of the columns. At
  /// 1e8, the coefficients have lost half of their digits.
  double condition = unset;
};

/// Solves the least-squares problem by QR decomposition with column pivoting. Throws
/// std::invalid_argument if there are fewer rows than columns, or if columns are linearly
/// dependent.
[[nodiscard]] Regression regress(const Eigen::MatrixXd& columns, const Eigen::VectorXd& readings);

/// Returns the factor [1] that adapts a spindle model to another spindle of the same type: <y -
/// rest, s>/<s, s> [Transfer2022, eq. 6]. y is the measured displacement, and s is the simulated
/// contribution of the spindle. `rest`, the simulated displacement without s, is assumed correct.
[[nodiscard]] double sister_scale(const Eigen::VectorXd& measured, const Eigen::VectorXd& rest,
                                  const Eigen::VectorXd& spindle);

}  // namespace raceway::correction
