#pragma once

#include <Eigen/Core>

#include "record/units.h"

namespace raceway::correction {

/// Multiple linear regression: a displacement as a linear combination of temperatures, without
/// memory. Many controls use this model. In raceway, regression is a baseline for comparison.
struct Regression {
  Eigen::VectorXd coefficients{};  ///< one for each column
  double rms = unset;              ///< rms residual, in the unit of the readings
  /// Condition number: ratio of the largest to the smallest singular value of the columns. At 1e8,
  /// the coefficients have lost half of their digits.
  double condition = unset;
};

/// Solves the least-squares problem by QR decomposition with column pivoting. Normal equations
/// would square the condition number. Throws std::invalid_argument for fewer rows than columns and
/// for linearly dependent columns.
[[nodiscard]] Regression regress(const Eigen::MatrixXd& columns, const Eigen::VectorXd& readings);

/// Returns the gain of another spindle of the same type, <y - rest, s>/<s, s>. This gain is the
/// factor on the simulated contribution s of the spindle [Transfer2022, eq. 6]. `rest`, the
/// remainder of the model, is assumed correct.
[[nodiscard]] double sister_scale(const Eigen::VectorXd& measured, const Eigen::VectorXd& rest,
                                  const Eigen::VectorXd& spindle);

}  // namespace raceway::correction
