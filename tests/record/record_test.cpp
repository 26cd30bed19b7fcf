#include "record/record.h"

#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>

#include "record/levels.h"
#include "record/repeats.h"

namespace raceway::record {
namespace {

Record three_rows() {
  Record record{.source = "three.csv"};
  record.set(speed, {100.0, 200.0, 300.0});
  record.set(friction_torque, {1.0, unset, 3.0});
  record.set(run, {0.0, 0.0, 1.0});
  record.runs = {"a", "b"};
  return record;
}

TEST(Record, KnowsItsRowsByTheirPlace) {
  Record record = three_rows();
  EXPECT_EQ(record.rows(), 3U);
  EXPECT_EQ(record.value(speed, 1), 200.0);
  EXPECT_TRUE(std::isnan(record.value(axial_load, 1)));
  EXPECT_TRUE(record.values(axial_load).empty());
  EXPECT_EQ(record.run_of(2), 1);
  EXPECT_EQ(record.place(2), "row 3");
  record.lines = {2, 5, 9};
  EXPECT_EQ(record.place(2), "line 9");
}

TEST(Record, PicksRowsWithAllTheirColumns) {
  Record record = three_rows();
  record.lines = {2, 5, 9};
  const std::size_t wanted[] = {2, 0};
  const Record picked = record.picked(wanted);
  EXPECT_EQ(picked.rows(), 2U);
  EXPECT_EQ(picked.value(speed, 0), 300.0);
  EXPECT_EQ(picked.run_of(0), 1);
  EXPECT_EQ(picked.lines, (std::vector{9, 2}));
  EXPECT_EQ(picked.source, "three.csv");
}

TEST(Record, TellsWhetherAColumnIsCompleteAndVaries) {
  Record record = three_rows();
  EXPECT_TRUE(record.complete(speed));
  EXPECT_FALSE(record.complete(friction_torque));
  EXPECT_FALSE(record.complete(time));
  EXPECT_TRUE(record.varies(speed));
  record.set(speed, {300.0, 300.5, 301.0});  // less than half a per cent
  EXPECT_FALSE(record.varies(speed));
}

TEST(Record, RefusesAColumnOfAnotherLength) {
  Record record = three_rows();
  EXPECT_THROW(record.set(axial_load, {1.0}), std::invalid_argument);
}

TEST(Record, FindsTheDeviationOfAMeasuredChannel) {
  Record record = three_rows();
  EXPECT_EQ(record.deviation_of(friction_torque), nullptr);
  record.set(torque_deviation, {0.1, 0.1, 0.1});
  ASSERT_NE(record.deviation_of(friction_torque), nullptr);
  EXPECT_EQ(record.deviation_of(axial_displacement), nullptr);
}

TEST(Levels, BeginWhereValuesStepByMoreThanTheWidth) {
  const double values[] = {3.0, 1.0, 1.05, unset, 2.0, 3.04};
  const std::vector<double> starts = level_starts(values, 0.1);
  EXPECT_EQ(starts, (std::vector{1.0, 2.0, 3.0}));
  EXPECT_EQ(level_of(1.05, starts), 0U);
  EXPECT_EQ(level_of(3.04, starts), 2U);
}

TEST(Repeats, CompareLoadsWithTheLargestOfThem) {
  Record record;
  record.set(speed, {100.0, 100.0, 100.0});
  record.set(axial_load, {1000.0, 1000.0, 1000.0});
  record.set(radial_load, {0.0, 0.5, 5.0});  // 0.5 N beside 1000 N is none
  const std::vector<RepeatGroup> groups = find_repeats(record);
  ASSERT_EQ(groups.size(), 1U);
  EXPECT_EQ(groups[0], (RepeatGroup{0, 1}));
}

}  // namespace
}  // namespace raceway::record
