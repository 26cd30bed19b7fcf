#pragma once

#include <Eigen/Core>

#include "record/units.h"

namespace raceway::correction {

/// Multiple linear regression: a displacement as a linear combination of present temperatures. Many
/// controls use this model. In raceway, the regression is a baseline for comparison.
struct Regression {
  Eigen::VectorXd coefficients{};  ///< one coefficient for each column
  double rms = unset;              ///< rms residual, in the unit of the readings
  /// Condition number [1]: ratio of the largest to the smallest singular value of the columns. At a
  /// condition number of 1e8, about half of the 16 digits of the coefficients are wrong.
  double condition = unset;
};

/// Solves the least-squares problem by QR decomposition with column pivoting. Throws
/// std::invalid_argument if there are fewer rows than columns, or if columns are linearly
/// dependent.
[[nodiscard]] Regression regress(const Eigen::MatrixXd& columns, const Eigen::VectorXd& readings);

/// Returns the factor that adapts a spindle model to another spindle of the same type [1]:
///
///   <y - rest, s>/<s, s>,   <a, b>: scalar product
///
/// y is the measured displacement (`measured`), and s the simulated contribution of the spindle
/// (`spindle`). `rest` is the simulated displacement without s; this part is assumed to be correct.
/// Source:   [Transfer2022, eq. 6].
[[nodiscard]] double sister_scale(const Eigen::VectorXd& measured, const Eigen::VectorXd& rest,
                                  const Eigen::VectorXd& spindle);

}  // namespace raceway::correction
