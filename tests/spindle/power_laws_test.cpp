#include "spindle/power_laws.h"

#include <gtest/gtest.h>

// Needs isnan without std::.
#include <math.h>

#include <boost/math/interpolators/pchip.hpp>
#include <cmath>
#include <vector>

#include "spindle/step_fit.h"
#include "tests/spindle/reference.h"

namespace raceway::spindle {
namespace {

/// Step responses of a cooled spindle by another program.
std::vector<LagAt> steps_of_case() {
  std::vector<LagAt> points;
  const nlohmann::json rows = reference("step_responses_cooled")["outputs"]["rows"];
  for (const nlohmann::json& row : rows)
    points.push_back(
        {row["P_end_W"], row["K_um"].get<double>() * um, row["T_min"].get<double>() * one_minute});
  return points;
}

// Least squares of the printed rows: nine digits on both sides.
TEST(PowerLaws, LinesAreTheChordsOfTheReference) {
  const nlohmann::json out = reference("step_responses_cooled")["outputs"];
  const PowerLaws laws = fit_power_laws(steps_of_case());
  const auto near_ratio = [](double a, const nlohmann::json& b) { return a / b.get<double>(); };
  EXPECT_NEAR(near_ratio(laws.gain_line.slope / um, out["K_of_P"]["slope_um_W"]), 1.0, 1e-6);
  EXPECT_NEAR(near_ratio(laws.gain_line.offset / um, out["K_of_P"]["offset_um"]), 1.0, 1e-6);
  EXPECT_NEAR(near_ratio(laws.time_line.slope / one_minute, out["T_of_P"]["slope_min_W"]), 1.0,
              1e-6);
  EXPECT_NEAR(near_ratio(laws.time_line.offset / one_minute, out["T_of_P"]["offset_min"]), 1.0,
              1e-6);
}

// As the case says: K ~ P^0.82, T ~ P^-0.23, and K(0) of the line, 4.8 um, is no physics.
TEST(PowerLaws, APowerFollowsACooledSpindleCloserThanALine) {
  const PowerLaws laws = fit_power_laws(steps_of_case());
  EXPECT_NEAR(laws.gain_power.exponent, 0.82, 0.005);
  EXPECT_NEAR(laws.time_power.exponent, -0.23, 0.005);
  double line = 0.0;
  for (const LagAt& p : steps_of_case())
    line += std::pow(laws.gain_line(p.input) / p.gain - 1.0, 2) / 5.0;
  EXPECT_LT(laws.gain_power.rms, 0.2 * std::sqrt(line));
  EXPECT_GT(laws.gain_line.slope_std, 0.0);
}

TEST(PowerLaws, LinesOfExactPointsAreExact) {
  const std::vector<LagAt> points{{50, 30 * um, 300}, {150, 50 * um, 200}};
  const PowerLaws laws = fit_power_laws(points);
  EXPECT_NEAR(laws.gain_line.slope / um, 0.2, 1e-12);
  EXPECT_NEAR(laws.gain_line.offset / um, 20.0, 1e-10);
  EXPECT_NEAR(laws.valid_to, 350.0, 1e-9);
  EXPECT_TRUE(std::isnan(laws.gain_line.slope_std));
}

// K = 0.2 (P - 40) um is of no use below 40 W, K = -0.2 (P - 40) um neither.
TEST(PowerLaws, EndsWhereALineChangesItsSign) {
  for (const double sign : {1.0, -1.0}) {
    const std::vector<LagAt> points{{50, sign * 2 * um, 300}, {150, sign * 22 * um, 300}};
    const PowerLaws laws = fit_power_laws(points);
    EXPECT_NEAR(laws.valid_from, 40.0, 1e-9);
    EXPECT_TRUE(std::isinf(laws.valid_to));
    EXPECT_EQ(laws.gain_power.factor < 0.0, sign < 0.0);
  }
}

TEST(PowerLaws, OfOnePowerThereAreNone) {
  const std::vector<LagAt> points{{50, 2 * um, 300}};
  EXPECT_TRUE(std::isnan(fit_power_laws(points).gain_line.slope));
  EXPECT_TRUE(std::isnan(fit_power_laws(points).valid_to));
  EXPECT_DOUBLE_EQ(gain_curve(points)(25.0), 1 * um);
  EXPECT_DOUBLE_EQ(time_curve(points)(25.0), 300.0);
}

TEST(PowerLaws, OverALoadGoThroughZeroBetweenBothSigns) {
  const std::vector<LagAt> points{{500, 6 * um, 500}, {-500, -4 * um, 700}, {1000, 10 * um, 400}};
  const MonotoneCurve gain = gain_curve(points), time = time_curve(points, 650);
  EXPECT_EQ(gain.x(), (std::vector<double>{-500, 0, 500, 1000}));
  EXPECT_EQ(gain(0.0), 0.0);
  EXPECT_EQ(gain(-500.0), -4 * um);
  EXPECT_LT(gain(-1.0), 0.0);
  EXPECT_EQ(time(0.0), 650.0);
  EXPECT_NEAR(fit_load_laws(points).gain_line.slope / um, 6.0 / 650.0, 2e-3);
  EXPECT_THROW((void)fit_power_laws(points), std::invalid_argument);
}

TEST(MonotoneCurve, IsThatOfBoost) {
  const std::vector<double> x{0, 59, 169, 308, 474, 669}, y{0, 7.5, 18.4, 29.8, 29.0, 41.8};
  const MonotoneCurve curve(x, y);
  const boost::math::interpolators::pchip<std::vector<double>> of_boost(std::vector<double>{x},
                                                                        std::vector<double>{y});
  // At its ends Boost takes other slopes: only the pieces within are the same.
  for (double at = 59; at <= 474; at += 1.0) EXPECT_NEAR(curve(at), of_boost(at), 1e-12) << at;
}

TEST(MonotoneCurve, TurnsNowhereButAtItsPoints) {
  const MonotoneCurve curve = gain_curve(steps_of_case());
  EXPECT_EQ(curve(0.0), 0.0);
  for (double P = 1.0; P < 668.0; P += 1.0) ASSERT_GT(curve(P), curve(P - 1.0));
  for (const LagAt& p : steps_of_case()) EXPECT_DOUBLE_EQ(curve(p.input), p.gain);
  const MonotoneCurve time = time_curve(steps_of_case(), 700.0);
  EXPECT_EQ(time(0.0), 700.0);
  for (double P = 1.0; P < 668.0; P += 1.0) ASSERT_LT(time(P), time(P - 1.0));
  EXPECT_EQ(time(1000.0), time(668.580347));
}

}  // namespace
}  // namespace raceway::spindle
