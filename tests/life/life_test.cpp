#include <gtest/gtest.h>

#include <cmath>

#include "life/equivalent_load.h"
#include "life/fatigue_load.h"
#include "life/load_rating.h"
#include "life/modified_life.h"
#include "tests/life/life_cases.h"

namespace raceway::life {
namespace {

TEST(Life, OfACatalogueBearingIsThatOfTheReference) {
  for (const auto& c : life_cases("life_iso281_")) {
    const auto& in = c.at("inputs");
    const auto& out = c.at("outputs");
    const bearing::BearingGeometry g{.ball_count = in.at("Z"),
                                     .ball_diameter = in.at("D_mm").get<double>() * mm,
                                     .pitch_diameter = in.at("dm_mm").get<double>() * mm,
                                     .contact_angle = in.at("alpha_deg").get<double>() * degree,
                                     .inner_conformity = in.at("f_i"),
                                     .outer_conformity = in.at("f_o")};
    const double axial = in.at("Fa"), radial = in.value("Fr", 0.0);
    const double speed = in.at("rpm").get<double>() * rpm;
    const LoadFactors factors = load_factors(g, axial);
    const auto holds = [&](const char* key, double value, double tolerance = 1e-8) {
      expect_share(value, out.at(key), tolerance, c.at("id").get<std::string>() + " " + key);
    };
    expect_share(factors.X, in.at("X_Y_e")[0], 1e-12, "X");
    expect_share(factors.Y, in.at("X_Y_e")[1], 1e-12, "Y");
    expect_share(factors.e, in.at("X_Y_e")[2], 1e-12, "e");
    const double C = dynamic_load_rating(g), P = equivalent_load(factors, radial, axial);
    const double C_u = fatigue_load(g), nu = in.at("nu_mm2_s").get<double>() * mm2_per_s;
    const double kappa = viscosity_ratio(nu, speed, g.pitch_diameter);
    holds("gamma", g.diameter_ratio() * std::cos(g.contact_angle));
    holds("C_N", C);
    holds("P_N", P);
    holds("L10_Mrev", basic_rating_life(C, P));
    holds("L10h", life_hours(basic_rating_life(C, P), speed));
    holds("C_u_N", C_u, 1e-7);
    holds("nu_1", rated_viscosity(speed, g.pitch_diameter) / mm2_per_s);
    holds("kappa", kappa);
    holds("a_ISO", life_modification(kappa, in.at("e_C").get<double>() * C_u / P));
  }
}

TEST(Life, FactorOfThePrintedTableIsThatOfTheReference) {
  for (const auto& c : life_cases("life_iso281_")) {
    if (!c.at("inputs").contains("f_c_at_gamma_0_01_to_0_40")) continue;
    double hundredths = 1.0;
    for (const double factor : c.at("inputs").at("f_c_at_gamma_0_01_to_0_40"))
      EXPECT_NEAR(rating_factor(0.01 * hundredths++), factor, 1e-9);
  }
}

TEST(Life, ModificationFactorsAreThoseOfTheReference) {
  for (const auto& c : life_cases("life_a_iso_table")) {
    const auto& points = c.at("inputs").at("kappa_and_eC_Cu_over_P");
    const auto& factors = c.at("outputs").at("a_ISO");
    ASSERT_EQ(points.size(), factors.size());
    for (std::size_t i = 0; i < points.size(); ++i) {
      const double value = life_modification(points[i][0], points[i][1]);
      if (factors[i].is_null())
        EXPECT_TRUE(std::isnan(value)) << points[i];
      else
        expect_share(value, factors[i], 1e-8, points[i].dump());
    }
    for (const auto& row : c.at("outputs").at("nu_1"))
      expect_share(
          rated_viscosity(row[0].get<double>() * rpm, row[1].get<double>() * mm) / mm2_per_s,
          row[2], 1e-8, row.dump());
  }
}

TEST(Life, BranchesOfTheModificationFactorMeet) {
  for (const double kappa : {0.4, 1.0})
    for (const double ratio : {0.01, 0.1, 0.3}) {
      const double below = life_modification(kappa * (1 - 1e-9), ratio);
      EXPECT_NEAR(life_modification(kappa, ratio), below, 5e-3 * below);
    }
  EXPECT_EQ(life_modification(2.0, 1e6), 50.0);
  EXPECT_EQ(life_modification(2.0, std::numeric_limits<double>::infinity()), 50.0);
  EXPECT_NEAR(life_modification(1.0, 0.0), 0.1, 1e-15);
}

TEST(Life, EquivalentLoadIsContinuousWhereTheAxialLoadBeginsToCount) {
  // X + Y e = 1 to the digits printed: a slip of one digit in the table would show. Between printed
  // angles the product of two straight lines bulges.
  const auto leap = [](double angle, double relative_load) {
    bearing::BearingGeometry g = spindle_geometry();
    g.contact_angle = angle * degree;
    const LoadFactors f = load_factors(g, relative_load * g.ball_count * 12.7 * 12.7);
    return f.X + f.Y * f.e - 1.0;
  };
  for (const double relative :
       {0.1, 0.172, 0.345, 0.689, 1.03, 1.38, 2.07, 3.45, 5.17, 6.89, 9.0}) {
    for (const double angle : {0.0, 5.0, 10.0, 15.0, 20.0, 25.0, 30.0, 35.0, 40.0, 45.0})
      EXPECT_NEAR(leap(angle, relative), 0.0, 1e-2) << angle << " deg, " << relative;
    for (const double angle : {7.5, 12.0, 18.0, 22.0, 37.0})
      EXPECT_NEAR(leap(angle, relative), 0.0, 2.5e-2) << angle << " deg, " << relative;
  }
}

TEST(Life, EquivalentLoadIsTheRadialLoadUntilTheAxialLoadCounts) {
  const LoadFactors f = load_factors(spindle_geometry(), 100.0);
  EXPECT_EQ(equivalent_load(f, 1000.0, 600.0), 1000.0);
  EXPECT_EQ(equivalent_load(f, 1000.0, -700.0), 410.0 + 0.87 * 700.0);
  EXPECT_EQ(equivalent_load(f, 0.0, 500.0), 435.0);
  EXPECT_TRUE(std::isinf(basic_rating_life(1e4, equivalent_load(f, 0.0, 0.0))));
}

TEST(Life, HasNoNumberForThrustBearingsNorBeyondTheTable) {
  bearing::BearingGeometry g = spindle_geometry();
  g.contact_angle = 60 * degree;
  EXPECT_TRUE(std::isnan(dynamic_load_rating(g)));
  EXPECT_TRUE(std::isnan(fatigue_load(g)));
  EXPECT_TRUE(std::isnan(equivalent_load(load_factors(g, 100.0), 1000.0, 0.0)));
  EXPECT_TRUE(std::isnan(rating_factor(0.005)));
  EXPECT_TRUE(std::isnan(rating_factor(0.41)));
  EXPECT_TRUE(std::isnan(rating_factor(unset)));
}

TEST(Life, LargeBallsAreRatedWithoutALeap) {
  bearing::BearingGeometry g = spindle_geometry();
  g.pitch_diameter = 200 * mm;
  g.ball_diameter = 25.4 * mm;
  const double at = dynamic_load_rating(g);
  g.ball_diameter = 25.401 * mm;
  EXPECT_NEAR(dynamic_load_rating(g), at, 1e-3 * at);
}

TEST(Life, IsShorterWhereMoreBearingsAreToReachIt) {
  EXPECT_EQ(reliability_factor(90.0), 1.0);
  EXPECT_EQ(reliability_factor(95.0), 0.64);
  EXPECT_EQ(reliability_factor(99.0), 0.25);
  EXPECT_TRUE(std::isnan(reliability_factor(89.0)));
  double before = 2.0;
  for (double r = 90.0; r <= 99.95; r += 0.05) {
    EXPECT_LT(reliability_factor(r), before);
    before = reliability_factor(r);
  }
  EXPECT_NEAR(life_hours(1.0, 1000 * rpm), 1e6 / 60000.0, 1e-9);
  EXPECT_TRUE(std::isinf(life_hours(1.0, 0.0)));
}

}  // namespace
}  // namespace raceway::life
