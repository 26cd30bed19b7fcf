#pragma once

#include <string>
#include <vector>

#include "correction/model.h"

// Last: see text/detail/toml_text.h.
#include "files/detail/model_section.h"

/// Trust section of a correction file; shared by its reader and its writer.
namespace raceway::files {

[[nodiscard]] std::vector<KeyTable> trust_tables();

/// Reads [correction.together], [correction.covariance], [correction.residual] and
/// [correction.trust] into a model whose numbers were read. If the covariance belongs to other
/// numbers, only the first table is kept, and a note says which number differs.
void read_trust(const Section& correction, correction::Model& model,
                std::vector<std::string>& notes);

/// Returns those of the tables [correction.range], .still_s, .together, .covariance, .residual and
/// .trust that the model has, with a blank line between them.
[[nodiscard]] std::string trust_text(const correction::Model& model);

}  // namespace raceway::files
