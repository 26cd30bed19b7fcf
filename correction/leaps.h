#pragma once

#include <cstddef>
#include <span>
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

/// A smaller one of a temperature is lost in its last digits [K].
inline constexpr double seen_leap_of_a_sensor = 0.5;

/// Rows before which a temperature leaps, as no body with a capacity does: by more than half a
/// kelvin, and by more than four times its change in the neighbouring rows, in one run at equal
/// time steps and at a speed that is constant for three rows.
[[nodiscard]] std::vector<std::size_t> leaping_rows(const record::Record& record,
                                                    const record::Channel& column);

}  // namespace raceway::correction
