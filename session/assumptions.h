#pragma once

#include <atomic>

#include "files/model_file.h"
#include "results/spindle_results.h"

/// Ranks the assumed numbers of a spindle by their influence on its steady state.
namespace raceway::session {

/// Returns the five assumed numbers that move the nose most. Assumed numbers are defaults, and
/// numbers that the file marks as a guess, except dimensions. The function changes one number at a
/// time by its usual spread, like sensitivity(). The result is empty for a network and for a
/// spindle without a steady state.
///
/// Source:   the spreads are judgements: films and contacts are known to a factor of 1.5 to 2, fits
///           to 3 um, and properties of steel and iron to 3 to 10 % (session/assumptions.cpp).
[[nodiscard]] results::Assumptions influential_assumptions(
    const files::ModelFile& file, const spindle::Inputs& inputs,
    const std::atomic<bool>* cancelled = nullptr);

}  // namespace raceway::session
