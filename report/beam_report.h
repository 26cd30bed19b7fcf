#pragma once

#include <string>
#include <vector>

#include "report/report.h"
#include "results/beam_results.h"
#include "spindle/beam.h"

/// Pages of `raceway modes` and `raceway deflection`.
namespace raceway::report {

/// Returns the page of modes over speed. `warm` is true if the bearings have their steady
/// temperatures.
[[nodiscard]] std::string modes_report(const ModelOfPage& model,
                                       const bearing::Arrangement& arrangement,
                                       const spindle::Beam& beam, const std::vector<double>& places,
                                       bool warm, const std::vector<results::ModesAtSpeed>& speeds,
                                       const model::Findings& findings = {});

/// Returns the page of the shaft under a force. `tangent` is the bending line with the stiffness
/// that the bearings have without the force. `stiff` is the bending line with rigid bearings. Both
/// bending lines have (v, θ) of all nodes [m, rad], or are empty.
[[nodiscard]] std::string deflection_report(
    const ModelOfPage& model, const bearing::Arrangement& arrangement, const spindle::Beam& beam,
    const std::vector<double>& places, bool warm, const results::DeflectionResult& result,
    const Eigen::VectorXd& tangent, const Eigen::VectorXd& stiff,
    const model::Findings& findings = {});

}  // namespace raceway::report
