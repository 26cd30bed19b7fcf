#pragma once

#include <Eigen/Core>

#include "fit/separable.h"
#include "verdict/diagnosis.h"

namespace raceway::tolerance {

/// Finds the pattern of the residuals over time: times of the largest residuals, period and
/// correlation time. `left` contains the residuals of the means [SI], reading minus prediction. The
/// result is empty for fewer than 8 means.
[[nodiscard]] verdict::Course course_of(const fit::Means& means, const Eigen::VectorXd& left);

}  // namespace raceway::tolerance
