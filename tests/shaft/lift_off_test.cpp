#include "shaft/lift_off.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "tests/support/shafts.h"

namespace raceway::fit {

using namespace shaft;

namespace {

using testing::ElementsAre;
using testing::IsEmpty;

std::vector<UnloadedRange> ranges(const Model& model, const std::vector<double>& speeds_rpm,
                                  double external_load = 0.0) {
  std::vector<ShaftPoint> points;
  for (const double n : speeds_rpm)
    points.push_back({.speed = n * rpm, .external_load = external_load});
  return unloaded_ranges(model, points, predict_shaft(model, points));
}

/// Z F_c tan(25 deg) grows with the speed squared; 300 N near 6800 rpm, 600 N near 9600 rpm.
TEST(UnloadedRanges, BeginWhereTheMinimumLoadIsMissed) {
  const auto found = ranges(two_against_one_on_springs(), {0, 4000, 8000, 12000});
  ASSERT_EQ(found.size(), 2U);
  EXPECT_EQ(found[0].what, Unloaded::below_minimum);
  EXPECT_THAT(found[0].bearings, ElementsAre(0, 1));
  EXPECT_NEAR(found[0].first.speed, 6800 * rpm, 300 * rpm);
  EXPECT_TRUE(std::isnan(found[0].end)) << "to the last point";
  EXPECT_NEAR(found[0].load, 300.0, 1e-6);
  EXPECT_NEAR(found[0].minimum_load, 300.0, 0.1);
  EXPECT_THAT(found[1].bearings, ElementsAre(2));
  EXPECT_NEAR(found[1].load, 600.0, 1e-6);
  // To half an rpm: there it is missed, one rpm before it is not.
  ShaftPoint before = found[0].first;
  before.speed -= 1.0 * rpm;
  EXPECT_FALSE(predict_shaft(two_against_one_on_springs(), {&before, 1})[0]
                   .equilibrium.bearings[0]
                   .below_minimum());
  EXPECT_THAT(ranges(two_against_one(), {0, 4000, 8000, 12000}), IsEmpty()) << "rigid sets";
}

TEST(UnloadedRanges, TellLostContactAndWhereItComesBack) {
  // Pulled off its seats at rest; whatever turns throws its balls outwards until they meet the
  // inner ring again.
  const auto found = ranges(two_against_one(), {0, 4000, 8000, 12000}, 2000.0);
  ASSERT_FALSE(found.empty());
  EXPECT_EQ(found[0].what, Unloaded::no_contact);
  EXPECT_THAT(found[0].bearings, ElementsAre(0, 1));
  EXPECT_EQ(found[0].first.speed, 0.0);
  EXPECT_EQ(found[0].load, 0.0);
  ASSERT_FALSE(std::isnan(found[0].end));
  const auto lost = [](double speed) {
    const ShaftPoint point{.speed = speed, .external_load = 2000.0};
    return predict_shaft(two_against_one(), {&point, 1})[0].equilibrium.bearings[0].lost();
  };
  EXPECT_TRUE(lost(0.0));
  EXPECT_FALSE(lost(found[0].end));
  EXPECT_LE(found[0].end, 0.5 * rpm) << "found to half an rpm";
}

TEST(UnloadedRanges, OfPointsWithoutBalanceEndAtTheLastOneThatHasOne) {
  // A spring that holds less than the load: no balance anywhere.
  EXPECT_THAT(ranges(two_against_one_on_springs(), {0, 8000}, 900.0), IsEmpty());
}

}  // namespace
}  // namespace raceway::fit
