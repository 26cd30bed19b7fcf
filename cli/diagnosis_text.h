#pragma once

#include "verdict/diagnosis.h"

namespace raceway::cli {

/// A verdict in a terminal: headline, errors against the noise, effects, what to measure next.
void print_diagnosis(const verdict::Diagnosis& diagnosis);

}  // namespace raceway::cli
