#pragma once

#include <string>
#include <vector>

#include "correction/model.h"

// Last: see text/detail/toml_text.h.
#include "files/detail/model_section.h"

/// Trust section of a correction file; shared by the reader and the writer of corrections.
namespace raceway::files {

[[nodiscard]] std::vector<KeyTable> trust_tables();

/// Reads [correction.together], [correction.covariance], [correction.residual] and
/// [correction.trust] into a model whose numbers were read. If the covariance belongs to other
/// numbers, only [correction.together] is kept, and a note names the number that differs.
void read_trust(const Section& correction, correction::Model& model,
                std::vector<std::string>& notes);

/// Returns the tables [correction.range], .still_s, .together, .covariance, .residual and .trust of
/// the model, with a blank line between them. Tables that the model does not have are omitted.
[[nodiscard]] std::string trust_text(const correction::Model& model);

}  // namespace raceway::files
