#include "friction/contact/oil.h"

#include <gtest/gtest.h>

#include "friction/contact/roelands.h"
#include "tests/friction_contact/contact_cases.h"

namespace raceway::friction::contact {
namespace {

TEST(Oil, IsThatOfTheReference) {
  Distance off("lubricant");
  for (const auto& c : contact_cases("lubricant_")) {
    const auto& in = c.at("inputs");
    const auto type = find_oil_type(in.at("type").get<std::string>());
    ASSERT_TRUE(type) << c.at("id");
    const Lubricant lubricant(in.at("viscosity_40C_mm2_s").get<double>() * mm2_per_s,
                              in.at("viscosity_100C_mm2_s").get<double>() * mm2_per_s);
    for (const auto& row : c.at("outputs").at("rows")) {
      const OilState oil = oil_state(lubricant, {.type = *type}, kelvin(row.at("T_C")));
      const std::string where = c.at("id").get<std::string>() + " " + row.at("T_C").dump() + " C";
      const auto holds = [&](const char* key, double value, double tolerance = 1e-8) {
        off.holds(value, row.at(key), tolerance, where + " " + key);
      };
      holds("nu_mm2_s", oil.kinematic_viscosity / mm2_per_s);
      holds("density_kg_m3", oil.density);
      holds("eta_Pas", oil.viscosity);
      holds("beta_1_K", oil.viscosity_slope, 1e-6);  // of differences there, a derivative here
      holds("alpha_1_GPa", oil.pressure_viscosity * GPa);
      holds("eta_at_1GPa_Pas", Roelands(oil.viscosity, oil.pressure_viscosity)(1 * GPa));
    }
  }
}

TEST(Oil, SlopeOfViscosityIsTheDifferenceQuotientOfViscosity) {
  for (const OilType type : {OilType::mineral, OilType::pao, OilType::ester})
    for (const double celsius : {-20.0, 15.0, 40.0, 95.0, 180.0}) {
      const Lubricant lubricant(32 * mm2_per_s, 6 * mm2_per_s);
      const OilData data{.type = type};
      const double step = 1e-3, T = kelvin(celsius);
      const double quotient = (std::log(oil_state(lubricant, data, T - step).viscosity) -
                               std::log(oil_state(lubricant, data, T + step).viscosity)) /
                              (2.0 * step);
      EXPECT_NEAR(oil_state(lubricant, data, T).viscosity_slope, quotient, 1e-7 * quotient);
    }
}

TEST(Oil, GivenPropertiesTakeThePlaceOfTheDefaults) {
  const Lubricant lubricant(22 * mm2_per_s, 4.8 * mm2_per_s);
  const OilState oil =
      oil_state(lubricant, {.density_15C = 1000.0, .conductivity = 0.2, .pressure_viscosity = 2e-8},
                kelvin(15.0));
  EXPECT_EQ(oil.density, 1000.0);
  EXPECT_EQ(oil.conductivity, 0.2);
  EXPECT_EQ(oil.pressure_viscosity, 2e-8);
}

TEST(Oil, NamesOfTypesAreReadBack) {
  for (const OilType type : {OilType::mineral, OilType::pao, OilType::ester})
    EXPECT_EQ(find_oil_type(name(type)), type);
  EXPECT_FALSE(find_oil_type("water"));
}

TEST(Roelands, BeginsAsBarusLaw) {
  const Roelands law(0.02, 1.5e-8);
  EXPECT_EQ(law(0.0), 0.02);
  const double p = 1e3;
  EXPECT_NEAR(std::log(law(p) / 0.02) / p, 1.5e-8, 1e-12);
  EXPECT_LT(law(1 * GPa), 0.02 * std::exp(15.0));
}

TEST(Roelands, HasNoValueForAnOilThinnerThanItsPole) {
  EXPECT_TRUE(roelands_holds(1e-4));
  EXPECT_FALSE(roelands_holds(6e-5));
  EXPECT_TRUE(std::isnan(Roelands(6e-5, 1e-8)(1 * GPa)));
}

}  // namespace
}  // namespace raceway::friction::contact
