#pragma once

#include <atomic>

#include "files/model_file.h"
#include "results/spindle_results.h"

/// Ranks the assumed values of a spindle model by their influence on the steady state.
namespace raceway::session {

/// Returns at most five assumed values: the values with the largest influence on the displacement
/// of the nose. An assumed value is a default value, or a value (except a dimension in mm) whose
/// comment in the model file contains `assumed` or `estimated`. Like sensitivity(), the function
/// changes one value at a time, by its usual spread. The result is empty for a thermal network and
/// for a spindle without a steady state.
///
/// Source:   the spreads are estimates: conductances of films and contacts are known to a factor of
///           1.5 to 2, the interferences and clearances of seats to 3 um, and properties of steel
///           and iron to 3 to 15 %.
[[nodiscard]] results::Assumptions influential_assumptions(
    const files::ModelFile& file, const spindle::Inputs& inputs,
    const std::atomic<bool>* cancelled = nullptr);

}  // namespace raceway::session
