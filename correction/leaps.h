#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "record/record.h"

namespace raceway::correction {

/// Returns the times at which a displacement jumps [s], each halfway between two readings. A
/// collet, a probe or a cable can cause a jump.
///
/// For each pair of successive readings, one straight line is fitted to the readings of about ten
/// minutes up to the earlier reading, and another line to the readings of about ten minutes from
/// the later reading on. Each line uses 3 to 20 readings. The gap is the distance between the two
/// lines at the time halfway between the two readings. Without a jump, the gap is due only to noise
/// and curvature. Gaps within ten minutes of a speed change are ignored, because the kinematic
/// displacement changes with the speed. A gap is a jump if it exceeds five times the robust
/// standard deviation of the remaining gaps (1.48 times their median). Slow changes of any size are
/// not jumps.
[[nodiscard]] std::vector<double> leaps(const record::Record& record,
                                        const record::Channel& displacement);

/// Smallest jump of a temperature that is detected [K]. Smaller jumps may be steps of the last
/// digit.
inline constexpr double seen_leap_of_a_sensor = 0.5;

/// Returns the indices of rows at which a temperature jumps, faster than a body with heat capacity
/// can. The change from the previous row exceeds 0.5 K, and is more than four times the previous
/// change and the next change. The rows before and after the jump must belong to one run. The time
/// step of the jump must be at most 1.5 times the time step before it. The speed must be the same
/// in the row of the jump and the three rows before it.
[[nodiscard]] std::vector<std::size_t> leaping_rows(const record::Record& record,
                                                    const record::Channel& column);

}  // namespace raceway::correction
