#pragma once

#include <vector>

#include "correction/model.h"

// This include must be the last one: see text/detail/toml_text.h.
#include "files/detail/model_section.h"

namespace raceway::files {

[[nodiscard]] std::vector<KeyTable> prior_tables();

/// Reads the priors in [correction.prior] into a model, which must already have its parameters.
void read_priors(const Section& correction, correction::Model& model);

}  // namespace raceway::files
