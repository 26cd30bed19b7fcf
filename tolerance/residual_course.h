#pragma once

#include <Eigen/Core>

#include "fit/separable.h"
#include "verdict/diagnosis.h"

namespace raceway::tolerance {

/// Course of residuals over time that no effect of the catalogue explains: where they are largest,
/// their period and their correlation time. `left`: reading minus prediction of every mean.
[[nodiscard]] verdict::Course course_of(const fit::Means& means, const Eigen::VectorXd& left);

}  // namespace raceway::tolerance
