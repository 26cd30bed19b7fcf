#pragma once

#include <string>

#include "shaft/conformity.h"

/// The conformity of a catalogue bearing as a JSON document; see results.h.
namespace raceway::io {

[[nodiscard]] std::string conformity_json(const std::string& bearing,
                                          const shaft::ConformityFit& fit);

}  // namespace raceway::io
