#pragma once

#include <Eigen/Core>
#include <functional>
#include <string>

#include "verdict/calibrate.h"

namespace raceway::verdict {

/// Finds parameters that the data cannot separate from others, neither at the start values of a fit
/// nor at other values. A parameter is fixed if it changes no reading, or if its influence equals a
/// combination of the influences of parameters that precede it in `response.parameters`. The
/// function marks this parameter and the preceding ones in the combination as not identifiable, and
/// adds a message. `lacks` returns the missing data that a parameter needs, as Judged::lacks() does
/// for an effect.
void hold_dependent(const fit::Response& response, const fit::Whitening& whitening,
                    const std::function<std::string(const std::string& parameter)>& lacks,
                    Calibration& result);

/// Returns the message about a parameter that is fixed because the data lack `needed`.
[[nodiscard]] std::string not_identifiable(const record::Parameter& held,
                                           const std::string& needed);

/// Estimates standard errors and correlation of the free parameters at the solution. `jacobian` is
/// whitened and has one column for each free parameter. The standard errors are multiplied by
/// `factor`; they are NaN if `factor` is NaN.
void estimate_errors(const Eigen::MatrixXd& jacobian, double factor, Calibration& result);

}  // namespace raceway::verdict
