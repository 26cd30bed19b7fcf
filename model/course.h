#pragma once

#include <vector>

#include "record/record.h"

namespace raceway::model {

/// Place of a row in the course of the measurement; NaN of a record without the time of every row.
struct Course {
  double since_start =
      unset;                 ///< time since the start of the day or of the sweep over the loads [s]
  double direction = unset;  ///< 1 where the speed was reached from below, -1 from above
};

/// Course of every row, in the order of the record.
///
/// A day begins after a pause of three hours that is also three times as long as the longest usual
/// step. A record without such a pause is one day, or several passages through the loads: one
/// begins where a load that had only risen falls, or the other way round. Each joined record has
/// its own.
[[nodiscard]] std::vector<Course> course_of(const record::Record& record);

}  // namespace raceway::model
