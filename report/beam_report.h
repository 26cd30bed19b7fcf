#pragma once

#include <string>
#include <vector>

#include "report/report.h"
#include "results/beam_results.h"
#include "spindle/beam.h"

/// Writes the report pages of `raceway modes` and `raceway deflection` as HTML.
namespace raceway::report {

/// Returns the HTML page with the vibration modes of the shaft over speed. `places` contains the
/// bearing positions on the shaft [m]. `warm` is true if the bearings have their steady-state
/// temperatures.
[[nodiscard]] std::string modes_report(const ModelOfPage& model,
                                       const bearing::Arrangement& arrangement,
                                       const spindle::Beam& beam, const std::vector<double>& places,
                                       bool warm, const std::vector<results::ModesAtSpeed>& speeds,
                                       const model::Findings& findings = {});

/// Returns the HTML page with the bending line of the shaft under a force. `tangent` is the bending
/// line with the bearing stiffness of the unloaded shaft. `stiff` is the bending line with rigid
/// bearings. Each of the two vectors contains deflection and slope of all nodes [m, rad], or is
/// empty.
[[nodiscard]] std::string deflection_report(
    const ModelOfPage& model, const bearing::Arrangement& arrangement, const spindle::Beam& beam,
    const std::vector<double>& places, bool warm, const results::DeflectionResult& result,
    const Eigen::VectorXd& tangent, const Eigen::VectorXd& stiff,
    const model::Findings& findings = {});

}  // namespace raceway::report
