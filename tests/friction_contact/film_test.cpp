#include "friction/contact/film.h"

#include <gtest/gtest.h>

#include "tests/friction_contact/contact_cases.h"

namespace raceway::friction::contact {
namespace {

RollingInlet inlet_of(const nlohmann::json& in) {
  return {.viscosity = in.at("eta0"),
          .pressure_viscosity = in.at("alpha"),
          .speed = in.at("u"),
          .modulus = in.at("E_prime"),
          .radius_along = in.at("R_x"),
          .load = in.at("Q")};
}

TEST(Film, IsThatOfTheReference) {
  Distance off("film");
  for (const auto& c : contact_cases("film_")) {
    const auto& in = c.at("inputs");
    const auto& out = c.at("outputs");
    const auto holds = [&](const char* key, double value) {
      if (out.contains(key))
        off.holds(value, out.at(key), 1e-7, c.at("id").get<std::string>() + " " + key);
    };
    const RollingInlet inlet = inlet_of(in);
    const Film flooded = isothermal_film(inlet, in.at("k"));
    if (!in.contains("b")) {
      holds("h_c_um", flooded.central / um);
      holds("h_min_um", flooded.minimum / um);
      continue;
    }
    const double L = thermal_loading(inlet.viscosity, in.at("beta"), inlet.speed, in.at("k_f"));
    const double thermal = thermal_film_factor(L);
    const StarvationFactors starved =
        in.at("inlet_over_b").is_null()
            ? StarvationFactors{}
            : starvation_factors(flooded, inlet.radius_along, in.at("b"), in.at("inlet_over_b"));
    const Film film{flooded.central * thermal * starved.central,
                    flooded.minimum * thermal * starved.minimum};
    holds("h_c_isothermal_um", flooded.central / um);
    holds("h_min_isothermal_um", flooded.minimum / um);
    holds("L", L);
    holds("phi_T", thermal);
    holds("phi_starved_c", starved.central);
    holds("phi_starved_min", starved.minimum);
    holds("h_c_um", film.central / um);
    holds("h_min_um", film.minimum / um);
    const double ratio = film_ratio(film, 0.05 * um);
    holds("lambda_", ratio);
    holds("asperity_share", asperity_share(ratio));
  }
}

TEST(Film, VanishesAtStandstillWithoutTrouble) {
  RollingInlet inlet{0.02, 1.5e-8, 0.0, 2.3e11, 6e-3, 50.0};
  EXPECT_EQ(isothermal_film(inlet, 8.0).central, 0.0);
  EXPECT_EQ(isothermal_film(inlet, 8.0).minimum, 0.0);
  EXPECT_EQ(thermal_film_factor(0.0), 1.0);
  EXPECT_EQ(asperity_share(0.0), 1.0);
  inlet.speed = 1e-12;
  EXPECT_GT(isothermal_film(inlet, 8.0).minimum, 0.0);
}

TEST(Film, IsNeverThickerStarvedThanFlooded) {
  const RollingInlet inlet{0.02, 1.5e-8, 20.0, 2.3e11, 6e-3, 50.0};
  const Film flooded = isothermal_film(inlet, 8.0);
  double before = 0.0;
  for (const double m : {1.0, 1.05, 1.5, 2.0, 5.0, 20.0, 100.0}) {
    const StarvationFactors f = starvation_factors(flooded, 6e-3, 7e-5, m);
    EXPECT_GE(f.central, before);
    EXPECT_LE(f.central, 1.0);
    EXPECT_LE(f.minimum, 1.0);
    before = f.central;
  }
  EXPECT_EQ(before, 1.0);
}

TEST(Film, ThinsAsTheInletHeatsAndAsItSlides) {
  EXPECT_LT(thermal_film_factor(2.0), thermal_film_factor(1.0));
  EXPECT_LT(thermal_film_factor(1.0, 0.1), thermal_film_factor(1.0));
  EXPECT_LT(asperity_share(2.0), asperity_share(1.0));
  EXPECT_NEAR(composite_roughness(0.045, 0.02), 0.0492, 1e-4);
}

}  // namespace
}  // namespace raceway::friction::contact
