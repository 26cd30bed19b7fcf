#pragma once

#include <vector>

#include "bearing/operating_point.h"
#include "effects/effect.h"
#include "record/record.h"

namespace raceway::model {

/// One row of a record as predictions look at it.
struct Row {
  bearing::OperatingPoint
      point;               ///< radial load along y; of a shaft: axial load is the external one
  effects::Record record;  ///< looks into the record, which must outlive it
  double preload = unset;  ///< of the sets at standstill [N]
};

/// All rows. NaN where the record has no such column, but a temperature of 40 °C.
[[nodiscard]] std::vector<Row> rows_of(const record::Record& record);

}  // namespace raceway::model
