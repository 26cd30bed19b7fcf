#pragma once

#include <vector>

#include "correction/model.h"

// Last: see text/detail/toml_text.h.
#include "files/detail/model_section.h"

namespace raceway::files {

[[nodiscard]] std::vector<KeyTable> prior_tables();

/// Reads [correction.prior] into a model. The numbers of the model must be read before.
void read_priors(const Section& correction, correction::Model& model);

}  // namespace raceway::files
