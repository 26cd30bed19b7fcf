#include "model/row.h"

#include <cstddef>
#include <span>

#include "model/course.h"

namespace raceway::model {

std::vector<Row> rows_of(const record::Record& record) {
  std::vector<Row> rows(record.rows());
  const auto fill = [&](const record::Channel& channel, auto&& number) {
    const std::span<const double> values = record.values(channel);
    for (std::size_t i = 0; i < rows.size(); ++i)
      number(rows[i]) = values.empty() ? unset : values[i];
  };
  fill(record::speed, [](Row& r) -> double& { return r.point.speed; });
  fill(record::axial_load, [](Row& r) -> double& { return r.point.axial_load; });
  fill(record::radial_load, [](Row& r) -> double& { return r.point.radial_load; });
  if (record.has(record::temperature))
    fill(record::temperature, [](Row& r) -> double& { return r.point.temperature; });
  fill(record::time, [](Row& r) -> double& { return r.record.time; });
  fill(record::inner_ring_temperature,
       [](Row& r) -> double& { return r.record.inner_ring_temperature; });
  fill(record::outer_ring_temperature,
       [](Row& r) -> double& { return r.record.outer_ring_temperature; });
  fill(record::preload, [](Row& r) -> double& { return r.preload; });
  const std::vector<Course> course = course_of(record);
  for (std::size_t i = 0; i < rows.size(); ++i) {
    rows[i].record.run = record.run_of(i);
    rows[i].record.since_start = course[i].since_start;
    rows[i].record.direction = course[i].direction;
    rows[i].record.rows = &record;
    rows[i].record.row = i;
  }
  return rows;
}

}  // namespace raceway::model
