#pragma once

#include <string>

#include "record/record.h"

namespace raceway::results {

/// A record as CSV, as the program has understood it: our columns in our units, one header line.
/// Of a coast-down these are the torques that were made of it, with their standard deviations.
/// read_record() reads it back. A cell that was not read is empty. Accuracy: 12 digits.
[[nodiscard]] std::string record_text(const record::Record& record);

}  // namespace raceway::results
