#pragma once

#include <string>

#include "record/record.h"

namespace raceway::results {

/// Returns a record as CSV as the program has read it: with its column names and units and one
/// header line. For a coast-down, it contains the computed torques with their standard deviations.
/// read_record() can read the text. Cells without a reading are empty. Accuracy: 12 digits.
[[nodiscard]] std::string record_text(const record::Record& record);

}  // namespace raceway::results
