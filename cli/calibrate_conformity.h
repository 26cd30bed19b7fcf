#pragma once

#include <string>

#include "cli/output_flags.h"

namespace raceway::cli {

/// Runs `raceway calibrate` without measurements: fits the groove conformity to the axial
/// rigidities in the catalogue of the manufacturer. `model` is a model file with the key
/// `catalogue` under [bearing], or the designation of a bearing in raceway's catalogue. Returns the
/// exit status.
int calibrate_conformity(const std::string& model, const OutputFlags& flags, bool json);

}  // namespace raceway::cli
