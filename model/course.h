#pragma once

#include <vector>

#include "record/record.h"

namespace raceway::model {

/// Time of a row since the start of its day or axial load sweep, and direction of the last speed
/// change. If any row of the record has no time, all members are NaN in every row.
struct Course {
  double since_start = unset;  ///< [s]
  /// 1 after a rise of the speed, -1 after a fall. The first row of a run, and a row in which the
  /// axial load changes, count as a start from rest: 1.
  double direction = unset;
};

/// Returns one Course for every row, in the order of the record.
///
/// A new day begins after a pause that is longer than three hours and longer than three times the
/// 90 % quantile of the time between rows. If a record has no such pause, the time starts from zero
/// with every sweep of the axial load. A new sweep begins if a rising axial load begins to fall, or
/// if a falling one begins to rise. If several records were joined, each record is treated
/// separately.
[[nodiscard]] std::vector<Course> course_of(const record::Record& record);

}  // namespace raceway::model
