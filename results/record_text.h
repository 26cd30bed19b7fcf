#pragma once

#include <string>

#include "record/record.h"

namespace raceway::results {

/// Returns a record as CSV with one header line. docs/files.md lists the column names and units.
/// For a coast-down, the text contains the computed friction torques with their standard
/// deviations. Cells without a value are empty.
///
/// Accuracy: 12 significant digits.
[[nodiscard]] std::string record_text(const record::Record& record);

}  // namespace raceway::results
