#include "bearing/contact_pressure.h"

#include <gtest/gtest.h>

#include <cmath>

#include "bearing/bearing_equilibrium.h"

namespace raceway::bearing {
namespace {

/// A bearing that is loose at one side under this load.
BearingGeometry size_7014() {
  return {.ball_count = 20,
          .ball_diameter = 11.906 * mm,
          .pitch_diameter = 90 * mm,
          .contact_angle = 25 * degree,
          .inner_conformity = 0.52,
          .outer_conformity = 0.52};
}

// "Contact stresses in a steel ball bearing", amesweb.info/HertzianContact, read 2026: a ball of
// radius 4.90 mm in a groove of radius 5 mm on an inner race of radius 25 mm, E = 210 GPa, ν =
// 0.29, 1500 N; printed 2193.6 MPa, semi-axes 2.101 and 0.156 mm, approach 0.012 mm. The page fits
// the ellipse: its numbers carry (2/3) pi p a b = 1506 N, and are good to 0.4 %.
TEST(ContactPressure, IsThatOfAPublishedBallBearing) {
  const Material steel{.name = "printed",
                       .elastic_modulus = 210 * GPa,
                       .poisson_ratio = 0.29,
                       .density = 7800,
                       .thermal_expansion = 0.0};
  const Bearing bearing({.ball_count = 12,
                         .ball_diameter = 9.8 * mm,
                         .pitch_diameter = 59.8 * mm,
                         .contact_angle = 0.0,
                         .inner_conformity = 5.0 / 9.8,
                         .outer_conformity = 5.0 / 9.8},
                        steel, steel);
  const HertzContact& contact = bearing.contact(Race::inner);
  EXPECT_NEAR(contact.peak_pressure(1500), 2193.6 * MPa, 0.002 * 2193.6 * MPa);
  EXPECT_NEAR(contact.semi_major_axis(1500), 2.101 * mm, 0.004 * 2.101 * mm);
  EXPECT_NEAR(contact.semi_minor_axis(1500), 0.156 * mm, 0.0005 * mm);
  EXPECT_NEAR(contact.approach(1500), 0.012 * mm, 0.0005 * mm);
}

TEST(ContactPressure, IsThatOfTheMostLoadedBall) {
  const Bearing bearing(size_7014(), steel(), steel());
  const BearingEquilibrium e = solve_bearing_equilibrium(
      bearing, {.speed = 8000 * rpm, .axial_load = 300, .radial_load = 200});
  ASSERT_TRUE(e.report.converged());
  double inner = 0.0, outer = 0.0;
  for (std::size_t k = 0; k < e.balls.size(); ++k) {
    inner = std::fmax(inner, bearing.contact(Race::inner).peak_pressure(e.balls[k].inner_load));
    outer = std::fmax(outer, bearing.contact(Race::outer).peak_pressure(e.balls[k].outer_load));
  }
  EXPECT_EQ(largest_pressure(bearing, e).inner, inner);
  EXPECT_EQ(largest_pressure(bearing, e).outer, outer);
  EXPECT_GT(inner, 0.2 * GPa);
}

TEST(ContactPressure, IsNoneWithoutBalance) {
  const ContactPressure none =
      largest_pressure(Bearing(size_7014(), steel(), steel()), BearingEquilibrium());
  EXPECT_TRUE(std::isnan(none.inner));
  EXPECT_TRUE(std::isnan(none.outer));
}

}  // namespace
}  // namespace raceway::bearing
