#pragma once

#include <string>
#include <vector>

#include "io/spindle_results.h"

/// Parts of `raceway spindle`; not for other code.
namespace raceway::cli {

/// The steady state under each of these, in their order.
[[nodiscard]] std::vector<io::SteadyState> steady_states(spindle::Simulator& simulator,
                                                         const std::vector<spindle::Inputs>& asked);

/// The steady state under these inputs with the cells of the model, held against the next finer
/// ones (of the finest, the next coarser). Not known of a network, and where either has none.
[[nodiscard]] io::MeshEstimate mesh_estimate(const model::Model& model,
                                             const spindle::Inputs& inputs);
/// In words, a line.
[[nodiscard]] std::string words(const io::MeshEstimate& mesh);

/// One of them in full, several as a table of speeds.
void print_steady(const model::Model& model, const std::vector<io::SteadyState>& states,
                  const io::MeshEstimate& mesh);

}  // namespace raceway::cli
