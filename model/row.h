#pragma once

#include <vector>

#include "bearing/operating_point.h"
#include "effects/effect.h"
#include "record/record.h"

namespace raceway::model {

/// One row of a record, as input of predictions.
struct Row {
  bearing::OperatingPoint point;  ///< radial load along y; for a shaft the axial load is external
  effects::Record record;         ///< refers to the record, which must live longer
  double preload = unset;         ///< preload force of the sets at standstill [N]
};

/// Returns all rows of a record. Values without a column are NaN, but the default temperature is 40
/// °C.
[[nodiscard]] std::vector<Row> rows_of(const record::Record& record);

}  // namespace raceway::model
