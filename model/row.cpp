#include "model/row.h"

namespace raceway::model {

Row row_of(const record::Record& record, std::size_t row) {
  const auto value = [&](const record::Channel& channel) { return record.value(channel, row); };
  Row result;
  result.point.speed = value(record::speed);
  result.point.axial_load = value(record::axial_load);
  result.point.radial_load = value(record::radial_load);
  if (record.has(record::temperature)) result.point.temperature = value(record::temperature);
  result.record = {.time = value(record::time),
                   .inner_ring_temperature = value(record::inner_ring_temperature),
                   .outer_ring_temperature = value(record::outer_ring_temperature),
                   .run = record.run_of(row),
                   .rows = &record,
                   .row = row};
  result.preload = value(record::preload);
  return result;
}

}  // namespace raceway::model
