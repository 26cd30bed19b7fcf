#pragma once

#include "fit/diagnosis.h"

namespace raceway::cli {

/// A verdict in a terminal: headline, errors against the noise, effects, what to measure next.
void print_diagnosis(const fit::Diagnosis& diagnosis);

}  // namespace raceway::cli
