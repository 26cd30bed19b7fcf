#pragma once

#include <Eigen/Core>

#include "record/units.h"

namespace raceway::correction {

/// Multiple linear regression: a displacement as a constant combination of temperatures, without
/// any memory. The common model of a control, here as the one that others have to beat.
struct Regression {
  Eigen::VectorXd coefficients{};  ///< one for each column
  double rms = unset;              ///< of what it leaves, in the unit of the readings
  /// Largest over least singular value of the columns: from 1e8 on, digits of the coefficients are
  /// lost.
  double condition = unset;
};

/// Least squares by a QR decomposition with column pivoting; the normal equations would square the
/// condition. Throws std::invalid_argument: less rows than columns, columns that depend on each
/// other.
[[nodiscard]] Regression regress(const Eigen::MatrixXd& columns, const Eigen::VectorXd& readings);

/// The gain of a sister spindle: by how much the simulated share of the spindle has to be scaled
/// where the rest of the model is right, <y - rest, s>/<s, s> [Transfer2022, eq. 6].
[[nodiscard]] double sister_scale(const Eigen::VectorXd& measured, const Eigen::VectorXd& rest,
                                  const Eigen::VectorXd& spindle);

}  // namespace raceway::correction
