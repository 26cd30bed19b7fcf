#pragma once

#include <string>

#include "shaft/fit_kinematic_law.h"

namespace raceway::session {

/// How well a fitted law follows its curve, in a sentence or two; `table` says where the monotone
/// table is that replaces a law which does not.
[[nodiscard]] std::string law_statement(const shaft::KinematicLawFit& fit,
                                        const std::string& table);

}  // namespace raceway::session
