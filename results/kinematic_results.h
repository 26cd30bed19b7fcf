#pragma once

#include <optional>
#include <string>

#include "shaft/fit_kinematic_law.h"

/// Writes the fitted law of the kinematic displacement, a displacement that follows the speed
/// without delay, as a JSON document (docs/files.md).
namespace raceway::results {

/// Displacement that the fitted law gives at one speed.
struct LawAtSpeed {
  double speed;  ///< [rad/s]
  shaft::KinematicDisplacement value;
};

[[nodiscard]] std::string kinematic_law_json(const shaft::KinematicLawFit& fit,
                                             const std::string& statement,
                                             const std::optional<LawAtSpeed>& at);

}  // namespace raceway::results
