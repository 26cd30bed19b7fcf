#pragma once

#include <string>

#include "model/model.h"
#include "results/spindle_results.h"

namespace raceway::cli {

/// Prints one steady state of a spindle in full: temperatures, joints, stresses, heat and forces.
void print_steady_state(const model::Model& model, const results::SteadyState& state);

/// Returns a friction power [W] as text. If `band` is above 0, the text also contains `band`, the
/// half width of the 95 % confidence band [W].
[[nodiscard]] std::string friction_words(double power, double band);

}  // namespace raceway::cli
