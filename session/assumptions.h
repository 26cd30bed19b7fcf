#pragma once

#include <atomic>

#include "files/model_file.h"
#include "results/spindle_results.h"

/// Ranks the assumed values of a spindle model by their influence on the steady state.
namespace raceway::session {

/// Returns the assumed values with the largest influence on the axial displacement of the spindle
/// nose, at most five. An assumed value is a default value, or a value whose comment in the model
/// file contains `assumed` or `estimated`. For a dimension in mm, such a comment has no effect. The
/// function changes one value at a time, by its usual uncertainty, and calculates the steady state
/// again. The result is empty for a thermal network ([network]) and for a spindle without a steady
/// state.
///
/// Source:   estimates. Conductances of films and contacts are known to a factor of 1.5 to 2,
///           interferences and clearances of seats to 3 um, and properties of steel and iron to 3
///           to 15 %.
[[nodiscard]] results::Assumptions influential_assumptions(
    const files::ModelFile& file, const spindle::Inputs& inputs,
    const std::atomic<bool>* cancelled = nullptr);

}  // namespace raceway::session
