#include "model/row.h"

#include <gtest/gtest.h>

#include <cmath>

namespace raceway::model {
namespace {

record::Record two_rows() {
  record::Record record;
  record.set(record::speed, {100.0, 200.0});
  record.set(record::axial_load, {10.0, 20.0});
  record.set(record::radial_load, {1.0, 2.0});
  return record;
}

TEST(Row, LooksIntoItsRecord) {
  record::Record record = two_rows();
  record.set(record::preload, {300.0, 900.0});
  record.set(record::time, {5.0, 6.0});
  record.set(record::run, {0.0, 1.0});
  record.set(record::temperature, {kelvin(30), unset});
  const Row row = rows_of(record)[1];
  EXPECT_EQ(row.point.speed, 200.0);
  EXPECT_EQ(row.point.axial_load, 20.0);
  EXPECT_EQ(row.point.radial_load, 2.0);
  EXPECT_EQ(row.point.radial_load_z, 0.0);
  EXPECT_EQ(row.preload, 900.0);
  EXPECT_EQ(row.record.value(record::time), 6.0);
  EXPECT_EQ(row.record.run, 1);
  EXPECT_EQ(row.record.value(record::preload), 900.0);
  EXPECT_TRUE(std::isnan(row.record.value(record::inner_ring_temperature)));
  EXPECT_EQ(rows_of(record)[0].point.temperature, kelvin(30));
  EXPECT_TRUE(std::isnan(row.point.temperature)) << "not read is not 40 C";
}

TEST(Row, OfARecordWithoutAColumnHasNoNumberButTheUsualTemperature) {
  record::Record record;
  record.set(record::speed, {100.0});
  const Row row = rows_of(record)[0];
  EXPECT_TRUE(std::isnan(row.point.axial_load));
  EXPECT_TRUE(std::isnan(row.point.radial_load));
  EXPECT_TRUE(std::isnan(row.preload));
  EXPECT_EQ(row.record.run, -1);
  EXPECT_EQ(rows_of(two_rows())[0].point.temperature, kelvin(40));
}

}  // namespace
}  // namespace raceway::model
