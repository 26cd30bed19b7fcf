#pragma once

#include <vector>

#include "bearing/operating_point.h"
#include "effects/effect.h"
#include "record/record.h"

namespace raceway::model {

/// One row of a record, as input for a prediction.
struct Row {
  /// Operating point. The radial load acts along y. For a shaft, the axial load is the external
  /// axial force on the shaft.
  bearing::OperatingPoint point;
  effects::Record record;  ///< view of the record; the record must outlive this view
  double preload = unset;  ///< preload force of the sets at standstill [N]
};

/// Returns all rows of a record. If the record has no temperature column, the temperature is 40 °C.
/// Any other value that the record does not contain is NaN.
[[nodiscard]] std::vector<Row> rows_of(const record::Record& record);

}  // namespace raceway::model
