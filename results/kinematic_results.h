#pragma once

#include <optional>
#include <string>

#include "shaft/fit_kinematic_law.h"

/// Writes the fit of the kinematic law as a JSON document (docs/files.md); see results.h.
namespace raceway::results {

/// Value of the law at one requested speed.
struct LawAtSpeed {
  double speed;  ///< [rad/s]
  shaft::KinematicDisplacement value;
};

[[nodiscard]] std::string kinematic_law_json(const shaft::KinematicLawFit& fit,
                                             const std::string& statement,
                                             const std::optional<LawAtSpeed>& at);

}  // namespace raceway::results
