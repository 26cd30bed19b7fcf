#pragma once

#include <string>
#include <vector>

#include "report/report.h"
#include "results/beam_results.h"
#include "spindle/beam.h"

/// The pages of `raceway modes` and `raceway deflection`.
namespace raceway::report {

/// Modes against speed. `warm`: as it runs steadily.
[[nodiscard]] std::string modes_report(const ModelOfPage& model,
                                       const bearing::Arrangement& arrangement,
                                       const spindle::Beam& beam, const std::vector<double>& places,
                                       bool warm, const std::vector<results::ModesAtSpeed>& speeds,
                                       const model::Findings& findings = {});

/// The shaft under a force. `tangent`: its line by the stiffness that the bearings have without the
/// force, `stiff` that on bearings that do not give way at all [m]; (v, θ) of all nodes, empty
/// where there is none.
[[nodiscard]] std::string deflection_report(
    const ModelOfPage& model, const bearing::Arrangement& arrangement, const spindle::Beam& beam,
    const std::vector<double>& places, bool warm, const results::DeflectionResult& result,
    const Eigen::VectorXd& tangent, const Eigen::VectorXd& stiff,
    const model::Findings& findings = {});

}  // namespace raceway::report
