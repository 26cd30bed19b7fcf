#include "friction/contact/rolling.h"

#include <gtest/gtest.h>

#include "bearing/hertz.h"
#include "tests/friction_contact/contact_cases.h"

namespace raceway::friction::contact {
namespace {

/// The exact ellipse of two radii.
bearing::HertzContact ellipse_of(double along, double across, double modulus) {
  const bearing::Material m{.name = "of the case",
                            .elastic_modulus = modulus,
                            .poisson_ratio = 0.0,
                            .density = 7800.0,
                            .thermal_expansion = 0.0};
  const double sum = 1.0 / along + 1.0 / across;
  return bearing::hertz_contact({.sum = sum, .difference = (1.0 / along - 1.0 / across) / sum}, m,
                                m);
}

RollingEllipse rolling_ellipse(const nlohmann::json& in) {
  const bearing::HertzContact hertz = ellipse_of(in.at("R_x"), in.at("R_z"), in.at("E_prime"));
  return {.inlet = {.viscosity = in.at("eta0"),
                    .pressure_viscosity = in.at("alpha"),
                    .speed = in.at("u"),
                    .modulus = in.at("E_prime"),
                    .radius_along = in.at("R_x"),
                    .load = in.at("Q")},
          .radius_across = in.at("R_z"),
          .semi_major_axis = hertz.semi_major_axis(in.at("Q")),
          .semi_minor_axis = hertz.semi_minor_axis(in.at("Q")),
          .second_integral = hertz.second_integral};
}

TEST(Rolling, IsThatOfTheReference) {
  Distance off("rolling");
  for (const auto& c : contact_cases("rolling_")) {
    const auto& in = c.at("inputs");
    const RollingEllipse e = rolling_ellipse(in);
    const double force =
        rolling_force(e, in.at("supply") == "flooded" ? Inlet::flooded : Inlet::limited);
    const auto holds = [&](const char* key, double value) {
      off.holds(value, c.at("outputs").at(key), 1e-7, c.at("id").get<std::string>() + " " + key);
    };
    holds("a", e.semi_major_axis);
    holds("b", e.semi_minor_axis);
    holds("E_integral", e.second_integral);
    holds("M_moes", moes_load(e));
    holds("F_N", force);
    holds("power_W", rolling_power(force, e.inlet.speed));
  }
}

RollingEllipse rolling_sample(double load, double speed) {
  const bearing::HertzContact hertz = ellipse_of(7.1e-3, 0.218, 2.286e11);
  return {.inlet = {0.019, 1.52e-8, speed, 2.286e11, 7.1e-3, load},
          .radius_across = 0.218,
          .semi_major_axis = hertz.semi_major_axis(load),
          .semi_minor_axis = hertz.semi_minor_axis(load),
          .second_integral = hertz.second_integral};
}

TEST(Rolling, GoesFromTheRigidToTheElasticLimitAsTheLoadGrows) {
  // Flooded, 0.77 and 1.8 lines: F/(E' R_x²) over (2a/R_x) goes from U^(2/3) to U^(3/4).
  const auto exponent = [](double load) {
    const double low = rolling_force(rolling_sample(load, 1.0), Inlet::flooded);
    return std::log(rolling_force(rolling_sample(load, 1.001), Inlet::flooded) / low) /
           std::log(1.001);
  };
  EXPECT_NEAR(exponent(1e-4), 2.0 / 3.0, 5e-3);
  EXPECT_NEAR(exponent(1e6), 0.75, 5e-3);
}

TEST(Rolling, VanishesAtStandstillAndGrowsWithSpeedLoadAndViscosity) {
  for (const Inlet supply : {Inlet::flooded, Inlet::limited}) {
    EXPECT_EQ(rolling_force(rolling_sample(50.0, 0.0), supply), 0.0);
    for (const double u : {1e-3, 0.1, 10.0, 60.0})
      for (const double Q : {1.0, 30.0, 1000.0}) {
        RollingEllipse e = rolling_sample(Q, u);
        const double force = rolling_force(e, supply);
        EXPECT_GT(force, 0.0);
        EXPECT_GT(rolling_force(rolling_sample(Q, 1.1 * u), supply), force);
        EXPECT_GT(rolling_force(rolling_sample(1.1 * Q, u), supply), force);
        e.inlet.viscosity *= 1.1;
        EXPECT_GT(rolling_force(e, supply), force);
      }
  }
}

TEST(Rolling, LosesToTheHeatOfItsInlet) {
  EXPECT_EQ(thermal_rolling_factor(0.0), 1.0);
  EXPECT_NEAR(thermal_rolling_factor(1.0), 1.0 / 1.29, 1e-15);
  // Smooth at the beginning, no step.
  EXPECT_NEAR(thermal_rolling_factor(1e-12), 1.0, 1e-9);
}

}  // namespace
}  // namespace raceway::friction::contact
