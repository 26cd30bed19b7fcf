#include "shaft/displacement_table.h"

#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>
#include <vector>

namespace raceway::shaft {
namespace {

std::vector<DisplacementPoint> saturating(int points) {
  std::vector<DisplacementPoint> curve;
  for (int i = 0; i < points; ++i) {
    const double x = static_cast<double>(i) / (points - 1);
    curve.push_back({x * 1000.0, um * x * x / (0.05 + x * x)});
  }
  return curve;
}

TEST(DisplacementTable, RisesWhereItsPointsRiseAndMeetsThem) {
  const auto curve = saturating(9);
  const DisplacementTable table = make_displacement_table(curve);
  EXPECT_TRUE(table.monotone);
  for (const DisplacementPoint& p : curve)
    EXPECT_NEAR(evaluate(table, p.speed).displacement, p.displacement, 1e-15 * um);
  double last = -1.0;
  for (double speed = 0.0; speed <= 1000.0; speed += 1.0) {
    const KinematicDisplacement at = evaluate(table, speed);
    EXPECT_TRUE(at.inside);
    EXPECT_GE(at.displacement, last);
    EXPECT_GE(at.slope, -1e-24);
    last = at.displacement;
  }
}

TEST(DisplacementTable, SlopeIsThatOfTheDisplacement) {
  const DisplacementTable table = make_displacement_table(saturating(9));
  for (const double speed : {10.0, 130.0, 333.0, 900.0}) {
    const double difference =
        (evaluate(table, speed + 1e-3).displacement - evaluate(table, speed - 1e-3).displacement) /
        2e-3;
    EXPECT_NEAR(evaluate(table, speed).slope / difference, 1.0, 1e-6);
  }
}

TEST(DisplacementTable, ErrorFallsFasterThanTheSquareOfTheSpacing) {
  const auto error = [](int points) {
    const DisplacementTable table = make_displacement_table(saturating(points));
    double worst = 0.0;
    for (double x = 0.0; x <= 1.0; x += 1e-3)
      worst = std::max(
          worst, std::abs(evaluate(table, 1000.0 * x).displacement - um * x * x / (0.05 + x * x)));
    return worst;
  };
  EXPECT_LT(error(41), error(21) / 4.0);
  EXPECT_LT(error(81), error(41) / 4.0);
  EXPECT_LT(error(41), 1e-3 * um);
}

TEST(DisplacementTable, AveragesRowsOfOneSpeed) {
  auto curve = saturating(5);
  curve.push_back({curve[2].speed, curve[2].displacement + 0.1 * um});
  const DisplacementTable table = make_displacement_table(curve);
  ASSERT_EQ(table.speed.size(), 5U);
  EXPECT_NEAR(table.displacement[2], curve[2].displacement + 0.05 * um, 1e-15 * um);
}

TEST(DisplacementTable, HoldsItsEndsAndSaysSo) {
  const DisplacementTable table = make_displacement_table(saturating(5));
  EXPECT_FALSE(evaluate(table, 1001.0).inside);
  EXPECT_EQ(evaluate(table, 1001.0).displacement, table.displacement.back());
  EXPECT_FALSE(evaluate(table, -1.0).inside);
  EXPECT_FALSE(evaluate(table, std::nan("")).inside);
}

TEST(DisplacementTable, TellsThatItTurnsWhereItsPointsTurn) {
  auto curve = saturating(5);
  curve[3].displacement = 0.0;
  EXPECT_FALSE(make_displacement_table(curve).monotone);
}

TEST(DisplacementTable, RefusesTooFewSpeeds) {
  EXPECT_THROW((void)make_displacement_table(saturating(3)), std::invalid_argument);
}

}  // namespace
}  // namespace raceway::shaft
