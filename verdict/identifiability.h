#pragma once

#include <Eigen/Core>
#include <functional>
#include <string>

#include "verdict/calibrate.h"

namespace raceway::verdict {

/// Marks what the data tell apart neither at the start of a fit nor away from it, holds all but the
/// first of a group, and says so; `lacks` is Subject::lacks() on these data.
void hold_dependent(const fit::Response& response, const fit::Whitening& whitening,
                    const std::function<std::string(const std::string& parameter)>& lacks,
                    Calibration& result);

/// Message on a parameter that is held because the data lack `needed`.
[[nodiscard]] std::string not_identifiable(const record::Parameter& held,
                                           const std::string& needed);

/// Standard errors and correlation of the parameters that are free to move at the solution.
/// `jacobian`: whitened, a column for each parameter that is not held. `factor`: by which errors
/// are widened, NaN where there are none.
void estimate_errors(const Eigen::MatrixXd& jacobian, double factor, Calibration& result);

}  // namespace raceway::verdict
