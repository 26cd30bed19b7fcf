#pragma once

#include <Eigen/Core>

#include "fit/separable.h"
#include "verdict/diagnosis.h"

namespace raceway::tolerance {

/// Finds the pattern of residuals over time that no effect of the catalogue explains: times of the
/// largest residuals, period and correlation time. `left` is the reading minus the prediction of
/// every mean.
[[nodiscard]] verdict::Course course_of(const fit::Means& means, const Eigen::VectorXd& left);

}  // namespace raceway::tolerance
