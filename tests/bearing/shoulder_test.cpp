#include "bearing/shoulder.h"

#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>
#include <string>

namespace raceway::bearing {
namespace {

constexpr double inner_shoulder = 78.2 * mm, outer_shoulder = 101.0 * mm;

/// A 7014 with shoulders.
BearingGeometry with_shoulders(double contact_angle_deg = 25.0) {
  return {.ball_count = 18,
          .ball_diameter = 12.7 * mm,
          .pitch_diameter = 90.0 * mm,
          .contact_angle = contact_angle_deg * degree,
          .inner_conformity = 0.525,
          .outer_conformity = 0.515,
          .inner_shoulder_diameter = inner_shoulder,
          .outer_shoulder_diameter = outer_shoulder};
}

Bearing bearing_with_shoulders(double contact_angle_deg = 25.0) {
  return {with_shoulders(contact_angle_deg), steel(), steel()};
}

/// Angle at which a circle of the groove's radius meets the shoulder's cylinder, by walking up the
/// groove from its bottom.
double walked_angle(double centre_radius, double groove_radius, double shoulder_radius,
                    double side) {
  double low = 0.0, high = pi / 2.0;
  for (int i = 0; i < 60; ++i) {
    const double angle = 0.5 * (low + high);
    const double here = centre_radius + side * groove_radius * std::cos(angle);
    (side * (here - shoulder_radius) > 0.0 ? low : high) = angle;
  }
  return low;
}

TEST(Shoulder, AngleIsWhereTheGrooveMeetsTheShoulder) {
  // Ball centre on d_m/2, groove centres (f - 0.5) D from it along the nominal contact angle.
  const double c = std::cos(25.0 * degree), D = 12.7 * mm;
  EXPECT_NEAR(shoulder_angle(with_shoulders(), Race::inner),
              walked_angle(45 * mm + 0.025 * D * c, 0.525 * D, 0.5 * inner_shoulder, -1.0), 1e-12);
  EXPECT_NEAR(shoulder_angle(with_shoulders(), Race::outer),
              walked_angle(45 * mm - 0.015 * D * c, 0.515 * D, 0.5 * outer_shoulder, 1.0), 1e-12);
  // By hand: (45 + 0.28776 - 39.1)/6.6675 = 0.92804, and (50.5 - 45 + 0.17265)/6.5405 = 0.86731.
  EXPECT_NEAR(shoulder_angle(with_shoulders(), Race::inner) / degree, 21.867, 0.01);
  EXPECT_NEAR(shoulder_angle(with_shoulders(), Race::outer) / degree, 29.853, 0.01);
}

TEST(Shoulder, AngleOfNoShoulderIsNoNumber) {
  BearingGeometry g = with_shoulders();
  g.inner_shoulder_diameter = unset;
  EXPECT_TRUE(std::isnan(shoulder_angle(g, Race::inner)));
  const Bearing b(g, steel(), steel());
  const auto e = solve_bearing_equilibrium(b, {.axial_load = 500.0});
  EXPECT_TRUE(std::isnan(shoulder_margins(b, e).inner));
  EXPECT_FALSE(std::isnan(shoulder_margins(b, e).outer));
  EXPECT_TRUE(std::isnan(permissible_axial_loads(b).inner));
  EXPECT_EQ(permissible_axial_loads(b).least(), permissible_axial_loads(b).outer);
}

/// Pure thrust at standstill without the solver [Harris2006, vol. 1, ch. 7]: the inner groove moves
/// along the axis, (B D + δ) cos α = B D cos α0, Q = F/(Z sin α), δ of both contacts; the ellipse
/// by a³ = 6 κ² E Q/(π Σρ E*) of the textbook.
struct HandThrust {
  const Bearing& bearing;

  [[nodiscard]] double angle(double load) const {
    const BearingGeometry& g = bearing.geometry();
    const double B = g.groove_centre_distance();
    double low = g.contact_angle, high = 89.0 * degree;
    for (int i = 0; i < 200; ++i) {
      const double a = 0.5 * (low + high);
      const double Q = load / (g.ball_count * std::sin(a));
      const double delta = std::pow(Q / bearing.contact(Race::inner).contact_stiffness, 2.0 / 3.0) +
                           std::pow(Q / bearing.contact(Race::outer).contact_stiffness, 2.0 / 3.0);
      (B * (std::cos(g.contact_angle) / std::cos(a) - 1.0) < delta ? low : high) = a;
    }
    return low;
  }
  [[nodiscard]] double half_axis(double load, Race race) const {
    const HertzContact& h = bearing.contact(race);
    const double Q = load / (bearing.geometry().ball_count * std::sin(angle(load)));
    const double k = std::sqrt(1.0 - 1.0 / (h.ellipse_ratio * h.ellipse_ratio));
    return std::cbrt(6.0 * h.ellipse_ratio * h.ellipse_ratio * std::comp_ellint_2(k) * Q /
                     (2.0 * pi * h.curvature_sum * h.contact_modulus));
  }
};

TEST(Shoulder, MarginUnderThrustIsThatOfTheHandCalculation) {
  const Bearing b = bearing_with_shoulders(15.0);
  const HandThrust hand{b};
  for (const double load : {10.0, 500.0, 5000.0, 20000.0}) {
    const auto e = solve_bearing_equilibrium(b, {.axial_load = load});
    const ShoulderMargins left = shoulder_margins(b, e);
    for (const Race race : {Race::inner, Race::outer}) {
      const double r = (race == Race::inner ? 0.525 : 0.515) * 12.7 * mm;
      const double expected = shoulder_angle(b.geometry(), race) - hand.angle(load) -
                              std::asin(hand.half_axis(load, race) / r);
      EXPECT_NEAR(race == Race::inner ? left.inner : left.outer, expected, 1e-9) << load;
    }
  }
}

TEST(Shoulder, PermissibleLoadIsWhereTheEllipseReachesTheEdge) {
  const Bearing b = bearing_with_shoulders(15.0);
  const HandThrust hand{b};
  const PermissibleLoads load = permissible_axial_loads(b);
  EXPECT_GT(load.outer, load.inner);
  EXPECT_EQ(load.least(), load.inner);
  for (const Race race : {Race::inner, Race::outer}) {
    const double at = race == Race::inner ? load.inner : load.outer;
    const double r = (race == Race::inner ? 0.525 : 0.515) * 12.7 * mm;
    EXPECT_NEAR(hand.angle(at) + std::asin(hand.half_axis(at, race) / r),
                shoulder_angle(b.geometry(), race), 1e-8);
  }
  const auto below = solve_bearing_equilibrium(b, {.axial_load = 0.999 * load.inner}),
             above = solve_bearing_equilibrium(b, {.axial_load = 1.001 * load.inner});
  EXPECT_GT(shoulder_margins(b, below).inner, 0.0);
  EXPECT_EQ(shoulder_margins(b, below).inner_cut, 0.0);
  EXPECT_LT(shoulder_margins(b, above).inner, 0.0);
  EXPECT_GT(shoulder_margins(b, above).inner_cut, 0.0);
}

TEST(Shoulder, BelowTheNominalContactCarriesNothing) {
  EXPECT_EQ(permissible_axial_loads(bearing_with_shoulders(25.0)).inner, 0.0);
}

TEST(Shoulder, MarginIsThatOfTheWorstBallAndAtSpeedOfEachRace) {
  const Bearing b = bearing_with_shoulders(15.0);
  const OperatingPoint combined{.axial_load = 2000.0, .radial_load = 800.0};
  const auto e = solve_bearing_equilibrium(b, combined);
  const ShoulderMargins left = shoulder_margins(b, e);
  double least = unset;
  for (const BallEquilibrium& ball : e.balls)
    least = std::fmin(least, shoulder_angle(b.geometry(), Race::inner) - ball.inner_contact_angle -
                                 std::asin(b.contact(Race::inner).semi_major_axis(ball.inner_load) /
                                           (0.525 * 12.7 * mm)));
  EXPECT_DOUBLE_EQ(left.inner, least);
  const auto fast = solve_bearing_equilibrium(b, {.speed = 12000 * rpm, .axial_load = 2000.0});
  const auto still = solve_bearing_equilibrium(b, {.axial_load = 2000.0});
  // Centrifugal force lifts the inner contact towards its shoulder, lowers the outer one.
  EXPECT_LT(shoulder_margins(b, fast).inner, shoulder_margins(b, still).inner);
  EXPECT_GT(shoulder_margins(b, fast).outer, shoulder_margins(b, still).outer);
}

TEST(Shoulder, OfADeepGrooveBearingStandsOnBothSides) {
  BearingGeometry g = with_shoulders(0.0);
  g.radial_clearance = 10 * um;
  const Bearing b(g, steel(), steel());
  const auto to = solve_bearing_equilibrium(b, {.axial_load = 400.0}),
             fro = solve_bearing_equilibrium(b, {.axial_load = -400.0});
  ASSERT_TRUE(to.report.converged() && fro.report.converged());
  EXPECT_NEAR(shoulder_margins(b, to).inner, shoulder_margins(b, fro).inner, 1e-9);
}

TEST(Shoulder, DiametersOutsideTheGrooveAreRefused) {
  const auto message = [](double inner, double outer) -> std::string {
    BearingGeometry g = with_shoulders();
    g.inner_shoulder_diameter = inner;
    g.outer_shoulder_diameter = outer;
    try {
      (void)validated(g);
    } catch (const std::invalid_argument& error) {
      return error.what();
    }
    return "";
  };
  EXPECT_EQ(message(inner_shoulder, outer_shoulder), "");
  EXPECT_NE(message(70 * mm, outer_shoulder).find("inner_shoulder_diameter = 70 mm"),
            std::string::npos);
  EXPECT_NE(message(inner_shoulder, 89 * mm).find("outer_shoulder_diameter = 89 mm"),
            std::string::npos);
  EXPECT_NE(message(91 * mm, outer_shoulder), "");
  EXPECT_NE(message(inner_shoulder, 104 * mm), "");
}

}  // namespace
}  // namespace raceway::bearing
