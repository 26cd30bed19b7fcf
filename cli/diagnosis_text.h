#pragma once

#include "verdict/diagnosis.h"

namespace raceway::cli {

/// Prints a verdict with the headline in the last line. By default, the function prints at most 20
/// lines at a width of 80 columns: the errors compared with the noise, the best effects and the
/// headline. `verbose` prints all details.
void print_diagnosis(const verdict::Diagnosis& diagnosis, bool verbose);

}  // namespace raceway::cli
