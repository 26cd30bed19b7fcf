#include "friction/lubricant.h"

#include <gmock/gmock.h>

#include <random>

#include "tests/friction/sample.h"
#include "tests/reference_table.h"

namespace raceway {
namespace {

using friction::Lubricant;
using testing::HasSubstr;

void expect_reference(const std::string& file) {
  for (const auto& row : tests::reference_table(file)) {
    SCOPED_TRACE(row.place());
    const Lubricant oil(row["viscosity_40C_mm2_s"] * mm2_per_s,
                        row["viscosity_100C_mm2_s"] * mm2_per_s);
    tests::expect_relative(oil.kinematic_viscosity(kelvin(row["temperature_C"])) / mm2_per_s,
                           row["kinematic_viscosity_mm2_s"], row["relative_tolerance"]);
  }
}

TEST(Lubricant, FollowsAstmD341) { expect_reference("lubricant_astm_d341.csv"); }

TEST(Lubricant, MeetsAnOilWithPrintedViscosities) { expect_reference("lubricant_krw_oil.csv"); }

TEST(Lubricant, ReturnsTheGivenPointsAlsoWhereThePrintedInverseIsOff) {
  for (const double hot : {0.5, 0.9, 1.5, 2.0, 4.8, 9.0}) {
    const Lubricant oil(10 * mm2_per_s, hot * mm2_per_s);
    tests::expect_relative(oil.kinematic_viscosity(kelvin(100)), hot * mm2_per_s, 1e-12);
    tests::expect_relative(oil.kinematic_viscosity(kelvin(40)), 10 * mm2_per_s, 1e-12);
  }
}

TEST(Lubricant, ViscosityFallsWithTemperature) {
  std::mt19937 random(1);
  std::uniform_real_distribution<double> log_cold(std::log(1.5), std::log(1000.0)), share(0.1, 0.9);
  for (int i = 0; i < 200; ++i) {
    const double cold = std::exp(log_cold(random));
    const double hot = std::max(0.5, std::pow(cold, share(random)));
    if (hot >= cold) continue;
    const Lubricant oil(cold * mm2_per_s, hot * mm2_per_s);
    double before = oil.kinematic_viscosity(kelvin(-70));
    for (double t = -65; t <= 370; t += 5) {
      const double nu = oil.kinematic_viscosity(kelvin(t));
      EXPECT_LT(nu, before) << cold << ' ' << hot << ' ' << t;
      EXPECT_GT(nu, 0.0);
      before = nu;
    }
  }
}

TEST(Lubricant, NamesWhatIsWrong) {
  const auto message = [](double cold, double hot) {
    return tests::message_of([&] { Lubricant(cold * mm2_per_s, hot * mm2_per_s); });
  };
  EXPECT_EQ(message(22, 25), "viscosity_100C = 25 mm2/s: must be below viscosity_40C = 22 mm2/s");
  EXPECT_THAT(message(22, 22), HasSubstr("must be below"));
  EXPECT_THAT(message(-1, 5), HasSubstr("viscosity_40C = -1 mm2/s"));
  EXPECT_THAT(message(unset, 5), HasSubstr("viscosity_40C is missing"));
  EXPECT_THAT(message(22, unset), HasSubstr("viscosity_100C is missing"));
  EXPECT_THAT(message(22, 0), HasSubstr("viscosity_100C = 0 mm2/s"));
}

TEST(Supply, IsFoundByItsName) {
  for (const auto supply : {friction::Supply::oil_air, friction::Supply::grease,
                            friction::Supply::jet, friction::Supply::bath}) {
    EXPECT_EQ(friction::find_supply(friction::name(supply)), supply);
    EXPECT_FALSE(friction::words(supply).empty());
  }
  EXPECT_EQ(friction::find_supply("oil_air"), std::nullopt);
}

}  // namespace
}  // namespace raceway
