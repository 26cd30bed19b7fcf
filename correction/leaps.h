#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "record/record.h"

namespace raceway::correction {

/// Returns times between two readings at which a displacement jumps [s], for example because of a
/// collet, a probe or a cable.
///
/// Straight lines are fitted to about ten minutes of readings before and after (3 to 20 readings
/// each). In the middle between them, the two lines have a gap. Without a jump, the gap shows only
/// noise and the curvature. A jump is a gap of at least five times the usual gap (standard
/// deviation from the median). Gaps within ten minutes of a speed change are ignored, because the
/// instant parts of the displacement step at a speed change. Slow changes of any size are not
/// jumps.
[[nodiscard]] std::vector<double> leaps(const record::Record& record,
                                        const record::Channel& displacement);

/// Smallest visible jump of a temperature [K]; smaller jumps cannot be separated from the last
/// digits.
inline constexpr double seen_leap_of_a_sensor = 0.5;

/// Returns the rows before which a temperature jumps faster than any body with heat capacity can.
/// The jump exceeds 0.5 K and is more than four times the change in the neighbouring rows. All
/// these rows must belong to one run with equal time steps, and the speed must be constant for
/// three rows.
[[nodiscard]] std::vector<std::size_t> leaping_rows(const record::Record& record,
                                                    const record::Channel& column);

}  // namespace raceway::correction
