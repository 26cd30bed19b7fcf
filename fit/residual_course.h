#pragma once

#include <Eigen/Core>

#include "fit/diagnosis.h"
#include "fit/separable.h"

namespace raceway::fit {

/// When a model fails that nothing in its catalogue mends: where it errs most, whether that comes
/// back after a time, and how long it lasts. `left`: reading minus prediction of every mean.
[[nodiscard]] Course course_of(const Means& means, const Eigen::VectorXd& left);

}  // namespace raceway::fit
