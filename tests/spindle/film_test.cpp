#include "spindle/film.h"

#include <string>
#include <utility>

#include "tests/spindle/reference_cases.h"

namespace raceway::spindle {
namespace {

using model::Fluid;
using model::RotatingConvection;

/// The fluid that a case names.
FluidProperties fluid_of(const ReferenceCase& c) {
  return {.kinematic_viscosity = c.in("nu"), .conductivity = c.in("lam"), .prandtl = c.in("Pr")};
}

TEST(Film, OfALyingCylinderIsThatOfTheReference) {
  for (const ReferenceCase& c : reference_cases("free_cylinder_"))
    c.holds("h", free_cylinder(c.in("D_m"), c.in("dT_K"), c.in("T_film_K"), fluid_of(c)));
}

TEST(Film, OfATurningShaftIsThatOfTheReference) {
  for (const ReferenceCase& c : reference_cases("rotating_shaft_"))
    for (const auto& [name, law] :
         {std::pair{"becker", RotatingConvection::becker},
          std::pair{"kendoush", RotatingConvection::kendoush},
          std::pair{"anderson-saunders", RotatingConvection::anderson_saunders}})
      c.holds(name, rotating_shaft(law, c.in("rpm") * rpm, c.in("D_m"), fluid_of(c)));
}

TEST(Film, OfAGapIsThatOfTheReference) {
  for (const ReferenceCase& c : reference_cases("annular_gap_")) {
    const double inner = c.in("r_in_m"), outer = c.in("r_out_m"), speed = c.in("rpm") * rpm;
    c.holds("Ta", taylor_number(inner, outer, speed, fluid_of(c)));
    c.holds("h_surface_to_surface", annular_gap(inner, outer, speed, fluid_of(c)));
  }
}

TEST(Film, OfAChannelIsThatOfTheReference) {
  for (const ReferenceCase& c : reference_cases("channel_")) {
    const double w = c.in("width_mm") * mm, d = c.in("depth_mm") * mm;
    const Channel channel{
        .section = w * d, .hydraulic_diameter = 2.0 * w * d / (w + d), .length = c.in("length_m")};
    const double flow = c.in("flow_l_min") * 1e-3 / 60.0;
    c.holds("Re", channel.reynolds(flow, fluid_of(c)));
    c.holds("h", channel.film(flow, fluid_of(c)));
  }
}

TEST(Film, OfRadiationIsThatOfTheReference) {
  for (const ReferenceCase& c : reference_cases("radiation"))
    c.holds("h", radiation(c.in("eps"), kelvin(c.in("T_C")), kelvin(c.in("T0_C"))));
}

// An independent way to the numbers: kinetic theory would not do, printed tables do. Air at 300 K
// and 1.013 bar has ν 15.9 mm²/s, λ 0.0263, Pr 0.707; three digits are printed.
TEST(Film, AirIsThatOfTablesAtOneBar) {
  const FluidProperties air = air_properties(300.0);
  EXPECT_NEAR(air.kinematic_viscosity, 15.9 * mm2_per_s, 0.05 * mm2_per_s);
  EXPECT_NEAR(air.conductivity, 0.0263, 1e-4);
  EXPECT_NEAR(air.prandtl, 0.707, 2e-3);
  EXPECT_NEAR(air.density, 1.161, 1e-3);
}

// Printed digits of steam tables: ρ, c, λ, μ.
TEST(Film, WaterIsThatOfTables) {
  struct Row {
    double celsius, density, heat_capacity, conductivity, viscosity;
  };
  for (const Row& row :
       {Row{5, 999.97, 4205, 0.568, 1.518e-3}, Row{20, 998.21, 4184, 0.598, 1.0016e-3},
        Row{40, 992.22, 4179, 0.629, 0.6527e-3}, Row{60, 983.2, 4185, 0.651, 0.4660e-3},
        Row{80, 971.8, 4197, 0.667, 0.3540e-3}}) {
    SCOPED_TRACE(row.celsius);
    const FluidProperties water = fluid_properties(Fluid::water, kelvin(row.celsius));
    EXPECT_NEAR(water.density, row.density, 2e-4 * row.density);
    EXPECT_NEAR(water.heat_capacity, row.heat_capacity, 5e-4 * row.heat_capacity);
    EXPECT_NEAR(water.conductivity, row.conductivity, 0.01 * row.conductivity);
    EXPECT_NEAR(water.kinematic_viscosity * water.density, row.viscosity, 5e-3 * row.viscosity);
  }
  EXPECT_NEAR(fluid_properties(Fluid::water, kelvin(20)).prandtl, 7.0, 0.02);
}

TEST(Film, PropertiesAgreeWithEachOther) {
  // Pr = ν ρ c/λ.
  for (const double t : {-40.0, 0.0, 20.0, 45.0, 90.0, 150.0})
    for (const FluidProperties& f :
         {air_properties(kelvin(t)), fluid_properties(Fluid::water, kelvin(t)),
          fluid_properties(Fluid::oil, kelvin(t))}) {
      EXPECT_GT(f.kinematic_viscosity, 0.0);
      EXPECT_NEAR(f.prandtl, f.kinematic_viscosity * f.density * f.heat_capacity / f.conductivity,
                  1e-12 * f.prandtl);
    }
  EXPECT_NEAR(fluid_properties(Fluid::oil, kelvin(40)).kinematic_viscosity, 10 * mm2_per_s, 1e-14);
}

TEST(Film, WithoutDifferenceOrSpeedIsThatOfStillAir) {
  const FluidProperties air = air_properties(300.0);
  EXPECT_NEAR(free_cylinder(0.1, 0.0, 300.0, air), 0.36 * air.conductivity / 0.1, 1e-14);
  EXPECT_NEAR(free_plate(0.1, 0.0, 300.0, air), 0.825 * 0.825 * air.conductivity / 0.1, 1e-14);
  EXPECT_EQ(free_cylinder(0.1, 5.0, 300.0, air), free_cylinder(0.1, -5.0, 300.0, air));
  for (const auto law : {RotatingConvection::becker, RotatingConvection::kendoush,
                         RotatingConvection::anderson_saunders}) {
    EXPECT_EQ(rotating_shaft(law, 0.0, 0.08, air), 0.0);
    EXPECT_EQ(turning_shaft(law, 0.0, 0.08, 5.0, 300.0, air), free_cylinder(0.08, 5.0, 300.0, air));
  }
  EXPECT_NEAR(annular_gap(0.04, 0.041, 0.0, air), air.conductivity / 1e-3, 1e-9);
}

// 0.15 Ra^(1/3) of turbulent walls and 0.59 Ra^(1/4) of laminar ones, which Churchill and Chu fit.
TEST(Film, OfAWallLiesNearThePowerLaws) {
  const FluidProperties air = air_properties(300.0);
  for (const double height : {0.1, 0.2, 2.0}) {
    const double ra = rayleigh(height, 10.0, 300.0, air);
    const double power = ra < 1e9 ? 0.59 * std::pow(ra, 0.25) : 0.13 * std::cbrt(ra);
    EXPECT_NEAR(free_plate(height, 10.0, 300.0, air) * height / air.conductivity, power,
                0.15 * power);
  }
}

TEST(Film, OfAGapHasNoStep) {
  const FluidProperties air = air_properties(310.0);
  double before = annular_gap(0.04, 0.041, 0.0, air);
  for (double speed = 1.0; speed < 2000.0; speed += 0.25) {
    const double now = annular_gap(0.04, 0.041, speed, air);
    EXPECT_GE(now, before);
    EXPECT_LT(now - before, 0.01 * before);
    before = now;
  }
}

TEST(Film, OfAChannelHasNoStepAndNoGapInBetween) {
  double before = channel_nusselt(0.0, 7.0, 1e-3);
  EXPECT_NEAR(before, 3.66, 1e-12);
  for (double re = 1.0; re < 20000.0; re *= 1.002) {
    const double now = channel_nusselt(re, 7.0, 1e-3);
    EXPECT_GE(now, before);
    before = now;
  }
  // Steep in between, but without a step.
  for (const double re : {2300.0, 4000.0})
    EXPECT_NEAR(channel_nusselt(re * (1.0 - 1e-9), 7.0, 1e-3),
                channel_nusselt(re * (1.0 + 1e-9), 7.0, 1e-3), 1e-6);
}

TEST(Film, OfACoolantIsThatOfItsHelix) {
  const model::Coolant c{.fluid = Fluid::water,
                         .flow = 4e-3 / 60.0,
                         .inlet_temperature = kelvin(20),
                         .diameter = 150 * mm,
                         .channel_width = 10 * mm,
                         .channel_depth = 4 * mm,
                         .pitch = 15 * mm,
                         .start = 100 * mm,
                         .end = 280 * mm};
  const Channel channel = channel_of(c);
  EXPECT_NEAR(channel.length, 12.0 * std::sqrt(std::pow(pi * 0.15, 2) + std::pow(0.015, 2)), 1e-12);
  EXPECT_NEAR(channel.hydraulic_diameter, 80.0 / 14.0 * mm, 1e-15);
  EXPECT_EQ(coolant_film(c, kelvin(20), true),
            channel.film(c.flow, fluid_properties(Fluid::water, kelvin(20))));
  EXPECT_EQ(coolant_film(c, kelvin(20), false), 25.0);
  model::Coolant trickle = c;
  trickle.flow = 0.0;
  EXPECT_EQ(coolant_film(trickle, kelvin(20), true), 25.0);
}

TEST(Film, OfRadiationBetweenCylindersHasItsLimits) {
  // Black ones exchange as a body with its surroundings does; a wide one around is black.
  const double hot = 320.0, cold = 300.0;
  EXPECT_NEAR(radiation_of_gap(0.04, 0.05, 1.0, 1.0, hot, cold), radiation(1.0, hot, cold), 1e-12);
  EXPECT_NEAR(radiation_of_gap(1e-9, 1.0, 0.3, 0.2, hot, cold), radiation(0.3, hot, cold), 1e-6);
  // What one gives is what the other takes: by each one's area the same.
  const double given = 0.04 * radiation_of_gap(0.04, 0.05, 0.3, 0.8, hot, cold);
  const double taken = 0.05 * radiation(1.0 / (1.0 / 0.8 - 1.0 + 0.05 / 0.04 / 0.3), hot, cold);
  EXPECT_NEAR(given, taken, 1e-14);
  EXPECT_NEAR(radiation(0.5, cold, cold), 0.5 * 4.0 * stefan_boltzmann * cold * cold * cold, 1e-12);
}

TEST(Film, FrictionOfAChannelIsThatOfTheTables) {
  // f Re of rectangular ducts, Shah and London 1978, table 42: ratio of sides 1, 1/2, 1/4, 1/8.
  for (const auto& [aspect, wanted] :
       {std::pair{1.0, 56.908}, {0.5, 62.192}, {0.25, 72.932}, {0.125, 82.340}})
    EXPECT_NEAR(1000.0 * channel_friction(1000.0, aspect), wanted, 1e-3 * wanted) << aspect;
  // Smooth pipes by Prandtl's law, 1/sqrt(f) = 2 lg(Re sqrt(f)) - 0.8, solved elsewhere.
  for (const auto& [re, wanted] : {std::pair{1e4, 0.03089}, {1e5, 0.01799}, {1e6, 0.01165}})
    EXPECT_NEAR(channel_friction(re, 0.4), wanted, 0.015 * wanted) << re;
}

TEST(Film, PressureOfAChannelAndOfItsThrottle) {
  model::Coolant c{.flow = 2e-3 / 60.0,
                   .inlet_temperature = kelvin(20),
                   .diameter = 140 * mm,
                   .channel_width = 10 * mm,
                   .channel_depth = 4 * mm,
                   .pitch = 14 * mm,
                   .start = 60 * mm,
                   .end = 300 * mm};
  const ChannelFlow flow = channel_flow(c, kelvin(20));
  EXPECT_NEAR(flow.velocity, 0.8333, 1e-3);  // 2 l/min through 40 mm²
  EXPECT_NEAR(flow.reynolds, 0.83333 * 5.7143e-3 / 1.004e-6, 30.0);
  EXPECT_EQ(flow.film, coolant_film(c, kelvin(20), true));
  // By hand: ξ (1.8 lg 4744 - 1.5)^-2 = 0.0382, 7.54 m of helix, 998.2 kg/m³.
  EXPECT_NEAR(flow.pressure_drop, 0.0382 * 7.544 / 5.7143e-3 * 0.5 * 998.2 * 0.8333 * 0.8333,
              0.01 * flow.pressure_drop);
  EXPECT_EQ(flow.throttle_drop, 0.0);
  c.throttle_diameter = 3 * mm;
  // 4.716 m/s through 7.069 mm², as a jet 7.731 m/s.
  EXPECT_NEAR(channel_flow(c, kelvin(20)).throttle_drop, 0.5 * 998.2 * 7.731 * 7.731, 100.0);
}

}  // namespace
}  // namespace raceway::spindle
