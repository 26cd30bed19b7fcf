#pragma once

#include "verdict/diagnosis.h"

namespace raceway::cli {

/// Prints the result of a diagnosis. The last line is the headline: the verdict in one sentence. By
/// default, the function prints at most 20 lines at a width of 80 columns: the errors compared with
/// the noise, the best effects, advice on further measurements, and the headline. If `verbose` is
/// true, it prints all details.
void print_diagnosis(const verdict::Diagnosis& diagnosis, bool verbose);

}  // namespace raceway::cli
