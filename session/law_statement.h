#pragma once

#include <string>

#include "shaft/fit_kinematic_law.h"

namespace raceway::session {

/// Describes the quality of a fitted law of the kinematic displacement in one or two sentences. If
/// the law does not follow the curve, the text recommends a monotone table of displacement over
/// speed instead. `table` is a text that tells the user how to get this table.
[[nodiscard]] std::string law_statement(const shaft::KinematicLawFit& fit,
                                        const std::string& table);

}  // namespace raceway::session
