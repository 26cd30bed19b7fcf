#include "verdict/misfit_map.h"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/support/loop.h"
#include "tests/support/synthetic.h"

namespace raceway::fit {
namespace {

const std::vector<double> four_speeds{1000, 2000, 4000, 8000}, loads{100, 300, 900};

/// A map of errors that `error` gives by speed [rpm] and axial load [N], noise of 1 N mm.
template <typename Error>
verdict::MisfitMap map_of(DataSet data, Error error, double std = 1.0 * N_mm) {
  std::vector<double> predicted;
  for (Row& row : data.rows) {
    row.measured = 1.0;
    predicted.push_back(1.0 + error(row.point.speed / rpm, row.point.axial_load));
  }
  return verdict::misfit_map(compare(predicted, data), data,
                             std::vector<double>(data.rows.size(), std));
}

TEST(MisfitMap, HasTheMeanErrorOfEveryPartOfThePlan) {
  const verdict::MisfitMap map =
      map_of(factorial_plan(four_speeds, loads, {40}, 3),
             [](double n, double load) { return (n / 1000.0 + load) * N_mm; });
  EXPECT_TRUE(*map.up_channel == record::axial_load);
  ASSERT_EQ(map.across.size(), 4U);
  ASSERT_EQ(map.up.size(), 3U);
  ASSERT_EQ(map.cells.size(), 12U);
  for (const verdict::MisfitCell& c : map.cells) {
    EXPECT_EQ(c.rows, 3);
    EXPECT_NEAR(c.bias, (four_speeds[c.across] / 1000.0 + loads[c.up]) * N_mm, 1e-12);
    EXPECT_NEAR(c.sigmas, c.bias / (N_mm / std::sqrt(3.0)), 1e-9);
  }
}

TEST(MisfitMap, OfADisplacementLiesOverItsPreloads) {
  DataSet data = factorial_plan(four_speeds, {0}, {40}, 3);
  data.quantity = Quantity::axial_displacement;
  for (std::size_t i = 0; i < data.rows.size(); ++i)
    data.rows[i].preload = i < four_speeds.size() ? 300.0 : 600.0;
  const verdict::MisfitMap map = map_of(data, [](double n, double) { return n * 1e-9; });
  EXPECT_TRUE(*map.up_channel == record::preload);
  ASSERT_EQ(map.up.size(), 2U);
  EXPECT_EQ(map.up[0].from, 300.0);
  EXPECT_EQ(map.cells[0].rows, 1);
  EXPECT_EQ(map.cells.back().rows, 2);
  EXPECT_NEAR(map.cells.back().bias, 8e-6, 1e-12);
}

TEST(MisfitMap, CallsOnlyTheCellsThatStandOutOfTheNoiseSignificant) {
  const verdict::MisfitMap map =
      map_of(factorial_plan(four_speeds, loads, {40}, 4),
             [](double n, double load) { return (n > 7000 && load > 800 ? -3.0 : 0.2) * N_mm; });
  for (const verdict::MisfitCell& c : map.cells)
    EXPECT_EQ(c.significant, c.across == 3 && c.up == 2) << c.across << " " << c.up;
}

TEST(MisfitMap, RaisesAFalseAlarmInOneOfTwentyMapsOfPureNoise) {
  std::mt19937 random(7);
  std::normal_distribution<double> gauss;
  int alarms = 0;
  constexpr int maps = 1000;
  for (int k = 0; k < maps; ++k) {
    const verdict::MisfitMap map = map_of(factorial_plan(four_speeds, loads, {40}, 3),
                                          [&](double, double) { return gauss(random) * N_mm; });
    alarms += std::any_of(map.cells.begin(), map.cells.end(),
                          [](const verdict::MisfitCell& c) { return c.significant; });
  }
  // Binomial: 50 +- 6.9; three of those.
  EXPECT_NEAR(alarms, 0.05 * maps, 21);
}

TEST(MisfitMap, TakesAnotherInputWhereTheLoadDoesNotVary) {
  const auto none = [](double, double) { return 1.0 * N_mm; };
  EXPECT_TRUE(*map_of(factorial_plan(four_speeds, {300}, {30, 60}), none).up_channel ==
              record::temperature);
  const verdict::MisfitMap line = map_of(factorial_plan(four_speeds, {300}, {40}), none);
  EXPECT_EQ(line.up.size(), 1U);
  EXPECT_EQ(line.cells.size(), 4U);
  const verdict::MisfitMap point = map_of(factorial_plan({1000}, {300}, {40}, 5), none);
  ASSERT_EQ(point.cells.size(), 1U);
  EXPECT_EQ(point.cells[0].rows, 5);
}

TEST(MisfitMap, WithoutNoiseNothingIsSignificant) {
  const verdict::MisfitMap map = map_of(
      factorial_plan(four_speeds, loads, {40}), [](double, double) { return 50.0 * N_mm; }, unset);
  for (const verdict::MisfitCell& c : map.cells) {
    EXPECT_TRUE(std::isnan(c.sigmas));
    EXPECT_FALSE(c.significant);
  }
}

}  // namespace
}  // namespace raceway::fit
