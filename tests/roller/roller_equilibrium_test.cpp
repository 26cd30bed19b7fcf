#include "bearing/roller_equilibrium.h"

#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>

#include "bearing/balls.h"
#include "tests/roller/reference_cases.h"

namespace raceway::roller {
namespace {

using bearing::RollerBearing;
using bearing::RollerEquilibrium;
using bearing::SolveStatus;
using bearing::Vector4;

RollerBearing with_clearance(double clearance,
                             bearing::RollerProfile profile = bearing::RollerProfile::iso) {
  bearing::RollerGeometry g = n1012();
  g.radial_clearance = clearance;
  g.profile = profile;
  return steel_bearing(g);
}

TEST(RollerEquilibrium, StiffnessIsTheDifferenceQuotientOfTheLoad) {
  const RollerBearing b = with_clearance(3 * um);
  const Vector4 at(6 * um, 2 * um, 0.2e-3, -0.4e-3);
  const double speed = 9000 * rpm;
  const RollerEquilibrium e = displaced_roller_bearing(b, at, speed);
  ASSERT_TRUE(e.report.converged());
  for (int i = 0; i < 4; ++i) {
    const double h = i < 2 ? 1e-11 : 1e-9;
    Vector4 step = Vector4::Zero();
    step[i] = h;
    const Vector4 quotient = (displaced_roller_bearing(b, at + step, speed).load -
                              displaced_roller_bearing(b, at - step, speed).load) /
                             (2.0 * h);
    for (int j = 0; j < 4; ++j)
      EXPECT_NEAR(quotient[j], e.stiffness(j, i), 1e-4 * e.stiffness.row(j).cwiseAbs().maxCoeff())
          << j << ", " << i;
  }
  EXPECT_TRUE(e.stiffness.isApprox(e.stiffness.transpose(), 1e-9));
}

TEST(RollerEquilibrium, ADisplacedRingAsksForTheLoadThatPutItThere) {
  const RollerBearing b = with_clearance(-2 * um);
  const bearing::OperatingPoint point{.speed = 6000 * rpm,
                                      .radial_load = 1200.0,
                                      .radial_load_z = -300.0,
                                      .moment_y = 0.4,
                                      .moment_z = 0.9};
  const RollerEquilibrium e = solve_roller_bearing(b, point, {.tilt = bearing::Tilt::free});
  ASSERT_TRUE(e.report.converged());
  const RollerEquilibrium back = displaced_roller_bearing(b, e.displacement, point.speed);
  ASSERT_TRUE(back.report.converged());
  EXPECT_TRUE(back.load.isApprox(Vector4(1200.0, -300.0, 0.4, 0.9), 1e-9)) << back.load;
}

// Z Qmax/Fr of straight rollers without play; [Harris2006] rounds it to 4.08.
TEST(RollerEquilibrium, TheLargestRollerLoadIsThatOfTheCatalogues) {
  const RollerEquilibrium e =
      solve_roller_bearing(with_clearance(0.0, bearing::RollerProfile::none), {.radial_load = 5e3});
  EXPECT_NEAR(20.0 * e.rollers[0].inner_load / 5e3, 4.08, 0.01);
}

TEST(RollerEquilibrium, DisplacementGrowsWithTheNinthTenthOfTheLoad) {
  const RollerBearing b = with_clearance(0.0, bearing::RollerProfile::none);
  const double one = solve_roller_bearing(b, {.radial_load = 100.0}).displacement[0];
  const double more = solve_roller_bearing(b, {.radial_load = 1e4}).displacement[0];
  EXPECT_NEAR(std::log10(more / one), 1.8, 1e-9);
}

TEST(RollerEquilibrium, WithoutLoadAndPreloadTheBearingIsLoose) {
  for (const double speed : {0.0, 8000 * rpm}) {
    const RollerBearing b = with_clearance(10 * um);
    const RollerEquilibrium e = solve_roller_bearing(b, {.speed = speed});
    EXPECT_TRUE(e.loose);
    EXPECT_TRUE(e.report.converged());
    EXPECT_EQ(e.status(), "loose");
    EXPECT_EQ(e.displacement, Vector4::Zero());
    EXPECT_EQ(e.stiffness, bearing::Matrix4::Zero());
    EXPECT_EQ(e.inner_sum(), 0.0);
    EXPECT_NEAR(e.outer_sum(), 20.0 * b.centrifugal_force(speed), 1e-7);
  }
}

// 20 um of play under 2 N: the next rollers are 0.5 um away.
TEST(RollerEquilibrium, OneLoadedRollerHoldsTheRingInItsOwnDirectionAlone) {
  for (const double speed : {0.0, 3000 * rpm}) {
    const RollerEquilibrium e =
        solve_roller_bearing(with_clearance(20 * um), {.speed = speed, .radial_load = 2.0});
    ASSERT_TRUE(e.report.converged());
    EXPECT_EQ(e.loaded_rollers(), 1);
    EXPECT_NEAR(e.rollers[0].inner_load, 2.0, 1e-9);
    EXPECT_GT(e.stiffness(0, 0), 0.0);
    EXPECT_EQ(e.stiffness(1, 1), 0.0);
    EXPECT_NEAR(e.displacement[1], 0.0, 1e-12);
  }
}

// A roller at 90 deg is nearer by y cos(pi/2), some 1e-21 m.
TEST(RollerEquilibrium, RoundingMakesNoContact) {
  const RollerEquilibrium e =
      solve_roller_bearing(with_clearance(0.0, bearing::RollerProfile::none), {.radial_load = 2e3});
  EXPECT_EQ(e.loaded_rollers(), 9);
  EXPECT_EQ(e.rollers[5].inner_load, 0.0);
}

TEST(RollerEquilibrium, ConvergesFromLightToHeavyLoadsAtAllClearances) {
  int hardest = 0;
  for (const double clearance : {-30 * um, -1 * um, 0.0, 1 * um, 50 * um, 500 * um})
    for (const double load : {1e-3, 1.0, 1e3, 1e5})
      for (const double speed : {0.0, 1 * rpm, 3000 * rpm, 30000 * rpm})
        for (const double angle : {0.0, 4.5 * degree, 77 * degree})
          for (const auto tilt : {bearing::Tilt::locked, bearing::Tilt::free}) {
            const RollerEquilibrium e =
                solve_roller_bearing(with_clearance(clearance),
                                     {.speed = speed,
                                      .radial_load = load * std::cos(angle),
                                      .radial_load_z = load * std::sin(angle),
                                      .moment_z = 1e-3 * load},
                                     {.tilt = tilt});
            EXPECT_EQ(e.report.status, SolveStatus::converged)
                << clearance / um << " um, " << load << " N, " << speed / rpm << " rpm, " << angle
                << ", residual " << e.report.residual;
            // A contact begins with 3e-8 N at the least approach.
            EXPECT_NEAR(e.load[0], load * std::cos(angle), 3e-8 + 1e-9 * e.outer_sum());
            hardest = std::max(hardest, e.report.iterations);
          }
  RecordProperty("iterations", hardest);
  EXPECT_LT(hardest, 200);
}

TEST(RollerEquilibrium, TiltLeavesTheRollersAsTheMirrorImageDoes) {
  const RollerBearing b = with_clearance(-4 * um);
  const auto tilted = [&](double tilt) {
    return solve_roller_bearing(b, {.radial_load = 1500.0}, {.tilt_z = tilt});
  };
  const RollerEquilibrium one = tilted(0.5e-3), other = tilted(-0.5e-3);
  EXPECT_NEAR(one.load[3], -other.load[3], 1e-9);
  EXPECT_NEAR(one.rollers[0].inner_laminae.front(), other.rollers[0].inner_laminae.back(), 1e-9);
}

// Silicon nitride is 1.5 times as stiff as steel, so its contact with steel is 1.22 times.
TEST(RollerEquilibrium, StifferRollersMakeAStifferBearing) {
  const RollerBearing steel = with_clearance(0.0);
  const RollerBearing ceramic(n1012(), bearing::silicon_nitride(), bearing::steel());
  const double k_steel = (1 - 0.09) / 208e9, k_ceramic = (1 - 0.0676) / 310e9;
  EXPECT_NEAR(ceramic.contact().stiffness / steel.contact().stiffness,
              2 * k_steel / (k_steel + k_ceramic), 1e-12);
  EXPECT_NEAR(ceramic.roller_mass() / steel.roller_mass(), 3200.0 / 7800.0, 1e-12);
}

std::string refusal(void (*change)(bearing::RollerGeometry&)) {
  bearing::RollerGeometry g = n1012();
  change(g);
  try {
    (void)validated(g);
  } catch (const std::invalid_argument& error) {
    return error.what();
  }
  return "taken";
}

TEST(RollerGeometry, SaysWhatCannotBe) {
  using G = bearing::RollerGeometry;
  EXPECT_EQ(refusal([](G&) {}), "taken");
  EXPECT_EQ(refusal([](G& g) { g.roller_count = 30; }),
            "roller_count = 30: at most 29 rollers of 8 mm fit on a pitch circle of 77.5 mm");
  EXPECT_EQ(refusal([](G& g) { g.roller_length = 90 * mm; }),
            "roller_length = 90 mm: must be from 0.5 to 80 mm");
  EXPECT_EQ(refusal([](G& g) { g.width = 7 * mm; }), "width = 7 mm: must be from 8 to 5000 mm");
  EXPECT_EQ(refusal([](G& g) { g.bore = 70 * mm; }), "bore = 70 mm: must be from 0 to 69.5 mm");
  EXPECT_EQ(refusal([](G& g) { g.outer_diameter = 85 * mm; }),
            "outer_diameter = 85 mm: must be from 85.5 to 171 mm");
  EXPECT_EQ(refusal([](G& g) { g.radial_clearance = -101 * um; }),
            "radial_clearance = -101 um: must be from -100 to 1000 um");
  EXPECT_EQ(refusal([](G& g) { g.roller_diameter = unset; }),
            "roller_diameter is missing: must be from 0.5 to 300 mm");
}

TEST(RollerEquilibrium, CarriesNoAxialLoad) {
  try {
    (void)solve_roller_bearing(with_clearance(0.0), {.axial_load = 10.0, .radial_load = 100.0});
    FAIL();
  } catch (const std::invalid_argument& error) {
    EXPECT_STREQ(error.what(),
                 "axial_load = 10 N: must be 0, because a cylindrical roller bearing of type N "
                 "cannot carry an axial load");
  }
}

}  // namespace
}  // namespace raceway::roller
