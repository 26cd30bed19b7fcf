#pragma once

#include "verdict/diagnosis.h"

namespace raceway::cli {

/// Prints a verdict with its headline in the last line. By default at most 20 lines of 80 columns:
/// errors against the noise, the best effects and the sentence; `verbose` prints all details.
void print_diagnosis(const verdict::Diagnosis& diagnosis, bool verbose);

}  // namespace raceway::cli
