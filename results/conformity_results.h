#pragma once

#include <string>

#include "shaft/conformity.h"

/// Writes the fitted groove conformity of a catalogue bearing as a JSON document; see results.h.
namespace raceway::results {

[[nodiscard]] std::string conformity_json(const std::string& bearing,
                                          const shaft::ConformityFit& fit);

}  // namespace raceway::results
