#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "record/record.h"

namespace raceway::correction {

/// Returns the times at which a displacement jumps [s]. Each time is halfway between two readings.
/// A loose collet, probe or cable can cause a jump.
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

/// Smallest temperature jump that is detected [K]. A smaller jump may be a change of the last digit
/// of the reading.
inline constexpr double seen_leap_of_a_sensor = 0.5;

/// Limits above which a change of temperature between two rows is a jump.
struct Leap {
  double size = seen_leap_of_a_sensor;  ///< change [K]
  /// Change divided by the change that the usual rate would cause in the same time step [1]. The
  /// usual rate is the higher of the rates before and after the jump.
  double of_beside = 4.0;
};

/// Returns the indices of rows at which a temperature jumps. At such a row, the change from the
/// previous row exceeds both limits in `least` (see Leap). A body with heat capacity cannot change
/// its temperature so fast. The two rows before the jump and the two rows after it must belong to
/// one run. The time step of the jump must be at most twice the longer of the time steps before and
/// after it. The speed must be the same in the row of the jump and the three rows before it.
[[nodiscard]] std::vector<std::size_t> leaping_rows(const record::Record& record,
                                                    const record::Channel& column, Leap least = {});

}  // namespace raceway::correction
