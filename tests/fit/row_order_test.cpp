#include "fit/row_order.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>
#include <random>

namespace raceway::fit {
namespace {

/// At each load the speed is stepped up; the temperature follows the speed and jitters.
Record stepped(const std::vector<double>& at_loads) {
  std::mt19937 random(1);
  std::normal_distribution<double> gauss;
  std::vector<double> speeds, forces, temperatures;
  for (const double F : at_loads)
    for (const double n :
         {600.0, 900.0, 1360.0, 2060.0, 3100.0, 4670.0, 7040.0, 10600.0, 16000.0}) {
      speeds.push_back(n * rpm);
      forces.push_back(F);
      temperatures.push_back(kelvin(23.5 + 1.8e-3 * n + 1.2 * gauss(random)));
    }
  Record record;
  record.set(record::speed, speeds);
  record.set(record::axial_load, forces);
  record.set(record::temperature, temperatures);
  return record;
}

std::vector<std::size_t> in_file(const Record& record) {
  std::vector<std::size_t> rows(record.rows());
  std::iota(rows.begin(), rows.end(), std::size_t{0});
  return rows;
}

std::vector<std::size_t> begins(const RowOrder& order) {
  std::vector<std::size_t> list;
  for (std::size_t i = 0; i < order.new_block.size(); ++i)
    if (order.new_block[i]) list.push_back(i);
  return list;
}

TEST(RowOrder, BlocksAreToldBySpeedAndNotByATemperatureThatFollowsIt) {
  const Record record = stepped({250, 600, 1400, 3000, 250, 600, 1400, 3000});
  const RowOrder order = row_order(record, in_file(record));
  EXPECT_EQ(begins(order), (std::vector<std::size_t>{0, 9, 18, 27, 36, 45, 54, 63}));
  EXPECT_FALSE(order.own_levels) << "each load stands in two blocks";
}

TEST(RowOrder, ABlockMayHaveALevelOfItsOwn) {
  const Record record = stepped({250, 600, 1400, 3000});
  EXPECT_TRUE(row_order(record, in_file(record)).own_levels);
}

TEST(RowOrder, ATemperatureSeparatesBlocksWhereNothingElseDoes) {
  Record record = stepped({250, 600, 1400});
  std::vector<double> one(record.rows(), 100.0), temperatures;
  for (std::size_t i = 0; i < one.size(); ++i)
    temperatures.push_back(kelvin(20.0 + 5.0 * static_cast<double>(i % 9)));
  record.set(record::speed, one);
  record.set(record::axial_load, one);
  record.set(record::temperature, temperatures);
  const RowOrder order = row_order(record, in_file(record));
  EXPECT_EQ(begins(order), (std::vector<std::size_t>{0, 9, 18}));
  EXPECT_FALSE(order.own_levels);
}

TEST(RowOrder, WithoutAClockTheFileTellsHowTheRigWasDriven) {
  const Record record = stepped({3000, 250, 1400, 600});
  EXPECT_EQ(order_of_rows(record), in_file(record));
  // A table that is sorted by speed, or shuffled, tells nothing.
  std::vector<std::size_t> rows = in_file(record);
  std::stable_sort(rows.begin(), rows.end(), [&](std::size_t a, std::size_t b) {
    return record.value(record::speed, a) < record.value(record::speed, b);
  });
  const Record sorted = record.picked(rows);
  std::shuffle(rows.begin(), rows.end(), std::mt19937(2));
  const Record shuffled = record.picked(rows);
  const auto first_speed = [](const Record& r) {
    return r.value(record::speed, order_of_rows(r)[1]);
  };
  EXPECT_NE(order_of_rows(shuffled), in_file(shuffled));
  EXPECT_EQ(first_speed(shuffled), first_speed(sorted));
}

}  // namespace
}  // namespace raceway::fit
