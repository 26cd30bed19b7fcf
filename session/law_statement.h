#pragma once

#include <string>

#include "shaft/fit_kinematic_law.h"

namespace raceway::session {

/// Quality of a fitted law in a sentence or two; `table` is the place of the monotone table that
/// replaces a law which does not follow its curve.
[[nodiscard]] std::string law_statement(const shaft::KinematicLawFit& fit,
                                        const std::string& table);

}  // namespace raceway::session
