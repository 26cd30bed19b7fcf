#pragma once

#include <string>

#include "shaft/fit_kinematic_law.h"

namespace raceway::session {

/// Describes the quality of a fitted law in one or two sentences. `table` is the place of the
/// monotone table that replaces a law with a poor fit.
[[nodiscard]] std::string law_statement(const shaft::KinematicLawFit& fit,
                                        const std::string& table);

}  // namespace raceway::session
