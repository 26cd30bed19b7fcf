#pragma once

#include <string>

#include "model/model.h"
#include "results/spindle_results.h"

namespace raceway::cli {

/// Prints one steady state of a spindle in full: temperatures, joints, stresses, heat and forces.
void print_steady_state(const model::Model& model, const results::SteadyState& state);

/// Returns a friction power [W] as text, with the band of the friction table if the table has a
/// band.
[[nodiscard]] std::string friction_words(double power, double band);

}  // namespace raceway::cli
