#pragma once

#include <string>
#include <vector>

#include "correction/model.h"

// This include must be the last one: see text/detail/toml_text.h.
#include "files/detail/model_section.h"

/// Reads and writes the results of a fit in a correction file: ranges of the inputs, statistics of
/// all inputs together, covariance, residual and trust.
namespace raceway::files {

[[nodiscard]] std::vector<KeyTable> trust_tables();

/// Reads [correction.together], [correction.covariance], [correction.residual] and
/// [correction.trust] into a model, which must already have its parameters. If the values in
/// [correction.covariance] differ from these parameters, only [correction.together] is kept, and a
/// note names the parameter that differs.
void read_trust(const Section& correction, correction::Model& model,
                std::vector<std::string>& notes);

/// Returns the text of the tables [correction.range], [correction.still_s], [correction.together],
/// [correction.covariance], [correction.residual] and [correction.trust] of the model, with a blank
/// line between them. Tables without contents are omitted.
[[nodiscard]] std::string trust_text(const correction::Model& model);

}  // namespace raceway::files
