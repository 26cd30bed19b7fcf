#pragma once

#include <string>

#include "shaft/conformity.h"

/// Returns a JSON document with the fitted groove conformity of a catalogue bearing.
namespace raceway::results {

[[nodiscard]] std::string conformity_json(const std::string& bearing,
                                          const shaft::ConformityFit& fit);

}  // namespace raceway::results
