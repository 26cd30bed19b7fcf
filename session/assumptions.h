#pragma once

#include <atomic>

#include "files/model_file.h"
#include "results/spindle_results.h"

/// The assumed numbers of a spindle that matter most for its steady state.
namespace raceway::session {

/// Varies every number that the file leaves to its default by its usual spread, one at a time, as
/// sensitivity() does, and returns the five that move the nose most. Nothing for a network, and
/// where there is no steady state.
///
/// Source:   the spreads are judgements: films and contacts are known to a factor of 1.5 to 2, fits
///           to 3 um, properties of steel and iron to 3 to 10 % (session/assumptions.cpp).
[[nodiscard]] results::Assumptions influential_assumptions(
    const files::ModelFile& file, const spindle::Inputs& inputs,
    const std::atomic<bool>* cancelled = nullptr);

}  // namespace raceway::session
