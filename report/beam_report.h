#pragma once

#include <string>
#include <vector>

#include "report/report.h"
#include "results/beam_results.h"
#include "spindle/beam.h"

/// Pages of `raceway modes` and `raceway deflection`.
namespace raceway::report {

/// Page of modes against speed. `warm`: at steady temperatures.
[[nodiscard]] std::string modes_report(const ModelOfPage& model,
                                       const bearing::Arrangement& arrangement,
                                       const spindle::Beam& beam, const std::vector<double>& places,
                                       bool warm, const std::vector<results::ModesAtSpeed>& speeds,
                                       const model::Findings& findings = {});

/// Page of the shaft under a force. `tangent`: its line by the stiffness that the bearings have
/// without the force, `stiff` that on bearings that do not give way at all [m]; (v, θ) of all
/// nodes, or empty.
[[nodiscard]] std::string deflection_report(
    const ModelOfPage& model, const bearing::Arrangement& arrangement, const spindle::Beam& beam,
    const std::vector<double>& places, bool warm, const results::DeflectionResult& result,
    const Eigen::VectorXd& tangent, const Eigen::VectorXd& stiff,
    const model::Findings& findings = {});

}  // namespace raceway::report
