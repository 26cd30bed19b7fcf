#pragma once

#include <Eigen/Core>

#include "fit/separable.h"
#include "verdict/diagnosis.h"

namespace raceway::tolerance {

/// When a model fails that nothing in its catalogue mends: where it errs most, whether that comes
/// back after a time, and how long it lasts. `left`: reading minus prediction of every mean.
[[nodiscard]] verdict::Course course_of(const fit::Means& means, const Eigen::VectorXd& left);

}  // namespace raceway::tolerance
