#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "record/record.h"

namespace raceway::correction {

/// Returns the times at which a displacement jumps [s], each halfway between two readings. Causes
/// of a jump are, for example, a collet, a probe or a cable.
///
/// For each pair of successive readings, one straight line is fitted to the readings of about ten
/// minutes that end with the first one. Another line is fitted to the readings of about ten minutes
/// that begin with the second one. Each line uses 3 to 20 readings. The gap is the distance between
/// the two lines at the time halfway between the two readings. Without a jump, the gap shows only
/// noise and curvature. A jump is a gap of more than five times the usual gap (robust standard
/// deviation from the median). Gaps within ten minutes of a speed change are ignored, because the
/// instant parts of the displacement step at a speed change. Slow changes of any size are not
/// jumps.
[[nodiscard]] std::vector<double> leaps(const record::Record& record,
                                        const record::Channel& displacement);

/// Smallest visible jump of a temperature [K]; smaller jumps cannot be distinguished from steps of
/// the last digit.
inline constexpr double seen_leap_of_a_sensor = 0.5;

/// Returns the rows before which a temperature jumps: it changes faster than a body with heat
/// capacity can. The jump exceeds 0.5 K. The jump is more than four times the change just before it
/// and the change just after it. The rows before and after the jump must belong to one run. The
/// time step of the jump must be at most 1.5 times the step before it. The speed must be the same
/// in this row and the three rows before it.
[[nodiscard]] std::vector<std::size_t> leaping_rows(const record::Record& record,
                                                    const record::Channel& column);

}  // namespace raceway::correction
