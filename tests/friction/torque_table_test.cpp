#include "friction/torque_table.h"

#include <gmock/gmock.h>

#include <cmath>

#include "friction/friction_law.h"

namespace raceway::friction {
namespace {

constexpr double torque(double speed, double load, double temperature) {
  return 0.05 + 1e-4 * speed + 2e-4 * load + 1e-4 * (temperature - 300.0);
}

/// A grid whose torque is straight in every axis.
TorqueTable straight_table() {
  TorqueTable table{.file = "t.csv", .has_radial_load = false};
  table.grid.axes = {{0, 100, 250, 500, 900}, {50, 400}, {0}, {290, 310, 340}};
  for (const double t : table.grid.axes.temperature)
    for (const double a : table.grid.axes.axial_load)
      for (const double s : table.grid.axes.speed)
        table.grid.friction_moment.push_back(torque(s, a, t));
  table.band.axes = table.grid.axes;
  for (const double m : table.grid.friction_moment) table.band.friction_moment.push_back(0.1 * m);
  return table;
}

BearingState<> at(double speed, double axial, double radial, double temperature) {
  BearingState<> s;
  s.speed = speed, s.axial_load = axial, s.radial_load = radial, s.temperature = temperature;
  return s;
}

TEST(TorqueTable, IsStraightBetweenPointsOfAStraightGrid) {
  const TorqueTable table = straight_table();
  for (const auto& [s, a, t] : {std::array{0.0, 50.0, 290.0},
                                {333.0, 111.0, 301.0},
                                {900.0, 400.0, 340.0},
                                {17.0, 399.0, 339.0}}) {
    EXPECT_NEAR(table.moment(at(s, a, 0, t)), torque(s, a, t), 1e-12);
    EXPECT_NEAR(table.half_width(at(s, a, 0, t)), 0.1 * torque(s, a, t), 1e-12);
    EXPECT_TRUE(table.holds(at(s, a, 0, t)));
  }
  EXPECT_EQ(table.range(), "0 to 8594.37 rpm, 50 to 400 N axial, 16.85 to 66.85 C");
}

TEST(TorqueTable, HoldsItsEdgeAndSaysSo) {
  const TorqueTable table = straight_table();
  EXPECT_NEAR(table.moment(at(1000, 200, 0, 300)), torque(900, 200, 300), 1e-12);
  EXPECT_NEAR(table.moment(at(100, 20, 0, 350)), torque(100, 50, 340), 1e-12);
  EXPECT_FALSE(table.holds(at(1000, 200, 0, 300)));
  EXPECT_FALSE(table.holds(at(100, 20, 0, 300)));
  EXPECT_FALSE(table.holds(at(100, 200, 0, 350)));
}

TEST(TorqueTable, AnAxisThatTheFileLacksTakesEveryValue) {
  TorqueTable table = straight_table();
  EXPECT_TRUE(table.holds(at(100, 200, 5000, 300)));
  EXPECT_EQ(table.moment(at(100, 200, 5000, 300)), table.moment(at(100, 200, 0, 300)));
  // With the column its one load is the only one.
  table.has_radial_load = true;
  EXPECT_FALSE(table.holds(at(100, 200, 5000, 300)));
}

TEST(TorqueTable, TheLoadHasNoDirectionAndNoNumberGivesNone) {
  const TorqueTable table = straight_table();
  EXPECT_EQ(table.moment(at(100, -200, 0, 300)), table.moment(at(100, 200, 0, 300)));
  EXPECT_TRUE(std::isnan(table.moment(at(100, unset, 0, 300))));
}

TEST(TorqueTable, IsALawWithAFactor) {
  const TorqueTable table = straight_table();
  BearingState<> s = at(333, 111, 0, 301);
  const std::array values{1.25};
  EXPECT_TRUE(std::isnan(base_moments<double>(FrictionLaw::table, s, values).viscous));
  s.table = &table;
  const BaseMoments<double> m = base_moments<double>(FrictionLaw::table, s, values);
  EXPECT_EQ(m.load, 0.0);
  EXPECT_NEAR(m.viscous, 1.25 * torque(333, 111, 301), 1e-12);
  EXPECT_EQ(find_friction_law("table"), FrictionLaw::table);
}

}  // namespace
}  // namespace raceway::friction
