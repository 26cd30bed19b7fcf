#pragma once

#include <vector>

#include "record/record.h"

namespace raceway::correction {

/// Times between two readings at which a displacement leaps [s]: a collet, a probe, a cable.
///
/// Straight lines through some ten minutes of readings before and after, 3 to 20 of them, meet in
/// the middle with a gap; where nothing leaps that gap is noise and the bend of the curve. Taken
/// are gaps of five times what they usually are (median, as a standard deviation), away from
/// changes of the speed by ten minutes: there instant parts of the machine step. Slow structure,
/// however large, is no leap.
[[nodiscard]] std::vector<double> leaps(const record::Record& record,
                                        const record::Channel& displacement);

}  // namespace raceway::correction
