#pragma once

#include <string>

#include "record/record.h"

namespace raceway::results {

/// Returns the record that the program has read, as CSV with one header line, with the column names
/// and units of raceway. For a coast-down, the text contains the computed torques with their
/// standard deviations. read_record() can read the text. Cells without a reading are empty.
/// Accuracy: 12 digits.
[[nodiscard]] std::string record_text(const record::Record& record);

}  // namespace raceway::results
