#pragma once

#include <vector>

#include "record/record.h"

namespace raceway::model {

/// Position of a row in the course of a measurement. All members are NaN if a row of the record has
/// no time.
struct Course {
  double since_start = unset;  ///< time since the start of the day or of the load sweep [s]
  double direction = unset;    ///< 1 if the speed rose to its value, also from rest; -1 if it fell
};

/// Returns the course of every row, in the order of the record.
///
/// A day begins after a pause of more than three hours. The pause must also be more than three
/// times as long as the 90 % quantile of the time between rows. In a record without such a pause,
/// the time since the start begins again with every load sweep. A new sweep begins if a rising load
/// begins to fall, or if a falling load begins to rise. If several records were joined, each record
/// has its own course.
[[nodiscard]] std::vector<Course> course_of(const record::Record& record);

}  // namespace raceway::model
