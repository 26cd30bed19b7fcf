#pragma once

#include <Eigen/Core>
#include <functional>
#include <string>

#include "verdict/calibrate.h"

namespace raceway::verdict {

/// Fixes parameters whose influence on the readings the data cannot separate from the influence of
/// other parameters. A parameter is fixed if it changes no reading, or if its influence equals a
/// combination of the influences of parameters that precede it in `response.parameters`. The test
/// must give this result both at the start values of the fit and at a second set of parameter
/// values. The function marks the fixed parameter and all parameters of the combination as not
/// identifiable, and adds a message. `lacks` returns a text that describes the data that are
/// missing for a parameter.
void hold_dependent(const fit::Response& response, const fit::Whitening& whitening,
                    const std::function<std::string(const std::string& parameter)>& lacks,
                    Calibration& result);

/// Returns the message about a parameter that is fixed because the record does not contain the data
/// `needed`.
[[nodiscard]] std::string not_identifiable(const record::Parameter& held,
                                           const std::string& needed);

/// Estimates standard errors and correlation of the free parameters at the solution. `jacobian` is
/// whitened and has one column for each free parameter. The standard errors are multiplied by
/// `factor`; they are NaN if `factor` is NaN.
void estimate_errors(const Eigen::MatrixXd& jacobian, double factor, Calibration& result);

}  // namespace raceway::verdict
