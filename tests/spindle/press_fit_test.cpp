#include "spindle/press_fit.h"

#include "tests/spindle/reference_cases.h"

namespace raceway::spindle {
namespace {

model::SolidMaterial steel(double density = 7850.0) {
  model::SolidMaterial m = model::steel_of_rings;
  m.density = density;
  return m;
}

/// 6 um on 70/82 mm, on a shaft bored to 36 mm.
PressedPart shaft(double rise = 0.0) {
  return {.bore = 36 * mm, .diameter = 70 * mm, .material = steel(), .rise = rise};
}
PressedPart ring(double rise = 0.0) {
  return {.bore = 70 * mm, .diameter = 82 * mm, .material = steel(7800.0), .rise = rise};
}

TEST(PressFit, OfARingOnAShaftIsThatOfTheReference) {
  for (const ReferenceCase& c : reference_cases("press_")) {
    model::SolidMaterial inner{.density = c.in("rho_shaft"),
                               .thermal_expansion = c.in("alpha"),
                               .elastic_modulus = c.in("E_Pa"),
                               .poissons_ratio = c.in("nu")};
    model::SolidMaterial outer = inner;
    outer.density = c.in("rho_ring");
    const double seat = c.in("seat_mm") * mm;
    const PressFit fit = press_fit({.bore = c.in("shaft_bore_mm") * mm,
                                    .diameter = seat,
                                    .material = inner,
                                    .rise = c.in("dT_shaft_K")},
                                   {.bore = seat,
                                    .diameter = c.in("ring_outer_mm") * mm,
                                    .material = outer,
                                    .rise = c.in("dT_ring_K")},
                                   c.in("interference_diametral_um") * um, c.in("rpm") * rpm);
    c.holds("pressure_MPa", fit.pressure / MPa);
    c.holds("effective_interference_um", fit.effective_interference / um);
    c.holds("ring_outer_radius_growth_um", fit.outer_radius_growth / um);
    EXPECT_EQ(fit.loose(), c.out("pressure_MPa") == 0.0);
  }
}

TEST(PressFit, OfTwoMaterialsIsThatOfTheReference) {
  for (const ReferenceCase& c : reference_cases("press_outer_ring_")) {
    model::SolidMaterial inner = model::steel_of_rings, outer = model::iron_of_housings;
    inner.elastic_modulus = c.in("E_ring");
    inner.poissons_ratio = c.in("nu_ring");
    outer.elastic_modulus = c.in("E_housing");
    outer.poissons_ratio = c.in("nu_housing");
    const double seat = c.in("seat_mm") * mm;
    const PressFit fit =
        press_fit({.bore = c.in("ring_bore_mm") * mm, .diameter = seat, .material = inner},
                  {.bore = seat, .diameter = c.in("housing_outer_mm") * mm, .material = outer},
                  c.in("interference_diametral_um") * um, 0.0);
    c.holds("pressure_MPa", fit.pressure / MPa);
  }
}

TEST(PressFit, ASeatOf6MicrometresIsLooseAt13664RevolutionsPerMinute) {
  // To the digits printed with the case.
  EXPECT_FALSE(press_fit(shaft(), ring(), 6 * um, 13663 * rpm).loose());
  const PressFit fit = press_fit(shaft(), ring(), 6 * um, 13665 * rpm);
  EXPECT_TRUE(fit.loose());
  EXPECT_EQ(fit.pressure, 0.0);
  EXPECT_GT(fit.gap, 0.0);
  EXPECT_EQ(fit.gap, -0.5 * fit.effective_interference);
}

TEST(PressFit, PressureOfOneMaterialOnASolidShaftIsTheTextbooks) {
  // p = E δ/(4 b) (1 - b²/c²), δ diametral.
  PressedPart solid = shaft();
  solid.bore = 0.0;
  const double b = 35 * mm, c = 41 * mm;
  const PressFit fit = press_fit(solid, ring(), 10 * um, 0.0);
  const double expected = 208e9 * 10 * um / (4.0 * b) * (1.0 - b * b / (c * c));
  EXPECT_NEAR(fit.pressure, expected, 1e-12 * expected);
  EXPECT_EQ(fit.inner_radius_growth, 0.0);
}

TEST(PressFit, SurfacesMeetWhereTheyAreFit) {
  // Growth of both parts at the seat by the pressure, less what each has alone, is the
  // interference.
  const PressFit fit = press_fit(shaft(5.0), ring(12.0), 10 * um, 6000 * rpm);
  const double E = 208e9, nu = 0.3, a = 18 * mm, b = 35 * mm, c = 41 * mm;
  const double in = fit.pressure * b / E * ((b * b + a * a) / (b * b - a * a) - nu);
  const double out = fit.pressure * b / E * ((c * c + b * b) / (c * c - b * b) + nu);
  EXPECT_NEAR(in + out, 0.5 * fit.effective_interference, 1e-17);
  // Volume of plane stress: a ring under inner pressure grows at its outside by 2 p b² c/(E (c² -
  // b²)), which is what the inside has less the squeeze of the wall.
  EXPECT_GT(out, fit.pressure * 2.0 * b * b * c / (E * (c * c - b * b)));
}

TEST(PressFit, WarmsOpenBySlopeOfExpansion) {
  const double tight = press_fit(shaft(), ring(), 10 * um, 0.0).effective_interference;
  const double warm_ring = press_fit(shaft(), ring(10.0), 10 * um, 0.0).effective_interference;
  EXPECT_NEAR(tight - warm_ring, 70 * mm * 11.5 * per_million_K * 10.0, 1e-15);
  // Both alike change nothing where both are of one material, but the size.
  const PressFit both = press_fit(shaft(10.0), ring(10.0), 10 * um, 0.0);
  EXPECT_NEAR(both.effective_interference, tight, 1e-18);
  EXPECT_NEAR(
      both.outer_radius_growth - press_fit(shaft(), ring(), 10 * um, 0.0).outer_radius_growth,
      41 * mm * 11.5 * per_million_K * 10.0, 1e-15);
}

TEST(PressFit, AClearanceIsAGapThatClosesWithTheTemperatureOfTheRing) {
  // Outer ring in a housing: the ring warms first.
  const PressedPart outer_ring{.bore = 98 * mm, .diameter = 110 * mm, .material = steel()};
  const PressedPart housing{
      .bore = 110 * mm, .diameter = 180 * mm, .material = model::iron_of_housings};
  const PressFit cold = press_fit(outer_ring, housing, -4 * um, 0.0);
  EXPECT_NEAR(cold.gap, 2 * um, 1e-18);
  EXPECT_EQ(cold.outer_radius_growth, 0.0);
  PressedPart warm = outer_ring;
  warm.rise = 10.0;
  const PressFit closed = press_fit(warm, housing, -4 * um, 0.0);
  EXPECT_FALSE(closed.loose());
  EXPECT_EQ(closed.gap, 0.0);
  EXPECT_LT(closed.inner_radius_growth, 49 * mm * 11.5 * per_million_K * 10.0);
}

}  // namespace
}  // namespace raceway::spindle
