#pragma once

#include <string>

#include "shaft/fit_kinematic_law.h"

namespace raceway::session {

/// Describes the quality of a fitted law in one or two sentences. `table` tells the user how to get
/// the monotone table of displacement over speed, which the text recommends if the fit is poor.
[[nodiscard]] std::string law_statement(const shaft::KinematicLawFit& fit,
                                        const std::string& table);

}  // namespace raceway::session
