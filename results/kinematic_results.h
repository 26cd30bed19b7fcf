#pragma once

#include <optional>
#include <string>

#include "shaft/fit_kinematic_law.h"

/// The fit of the kinematic law as a JSON document (docs/files.md); see results.h.
namespace raceway::results {

/// The law at one speed that was asked for.
struct LawAtSpeed {
  double speed;  ///< [rad/s]
  shaft::KinematicDisplacement value;
};

[[nodiscard]] std::string kinematic_law_json(const shaft::KinematicLawFit& fit,
                                             const std::string& statement,
                                             const std::optional<LawAtSpeed>& at);

}  // namespace raceway::results
