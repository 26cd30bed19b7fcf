#include "friction/friction_law.h"

#include <gmock/gmock.h>

#include "tests/friction/sample.h"
#include "tests/support/bearing_data.h"

namespace raceway {
namespace {

using friction::FrictionLaw;
using testing::HasSubstr;

TEST(FrictionLaw, IsFoundByItsName) {
  for (const FrictionLaw law : {FrictionLaw::palmgren, FrictionLaw::skf})
    EXPECT_EQ(friction::find_friction_law(friction::name(law)), law);
  EXPECT_EQ(friction::find_friction_law("palmgreen"), std::nullopt);
}

TEST(FrictionLaw, NamesTheLoadsOfItsFactor) {
  EXPECT_EQ(friction::name(friction::F1Load::P0), "P0");
  EXPECT_EQ(friction::name(friction::F1Load::F_b), "F_b");
}

TEST(FrictionLaw, ParametersStandInTheOrderInWhichValuesAreTaken) {
  const auto names = [](FrictionLaw law) {
    std::vector<std::string> list;
    for (const auto& p : friction::parameters(law)) {
      list.emplace_back(p.name);
      EXPECT_LE(p.lower, p.initial);
      EXPECT_LE(p.initial, p.upper);
    }
    return list;
  };
  EXPECT_THAT(names(FrictionLaw::palmgren), testing::ElementsAre("f0", "z", "y"));
  EXPECT_THAT(names(FrictionLaw::skf), testing::ElementsAre("mu_bl", "mu_EHL", "K_rs"));

  const auto bearing = tests::spindle_bearing();
  friction::BearingState<double> s;
  s.bearing = &bearing;
  s.speed = 5000 * rpm;
  s.axial_load = 500;
  s.kinematic_viscosity = 22 * mm2_per_s;
  const std::array palmgren{1.5, 0.001, 0.33};
  const auto p = base_moments<double>(FrictionLaw::palmgren, s, palmgren);
  EXPECT_EQ(p.load, friction::PalmgrenLoad::moment(s, 0.001, 0.33));
  EXPECT_EQ(p.viscous, friction::PalmgrenViscous::moment(s, 1.5));
  const std::array skf{0.15, 0.05, 6e-8};
  const auto q = base_moments<double>(FrictionLaw::skf, s, skf);
  EXPECT_EQ(q.load, friction::SkfSliding::moment(s, 0.15, 0.05));
  EXPECT_EQ(q.viscous, friction::SkfRolling::moment(s, 6e-8));
}

// What a law does not take in must not change a digit, so that a user can be told.
TEST(FrictionLaw, TakesInOfABearingWhatItSaysAndNothingElse) {
  const auto moments = [](FrictionLaw law, const bearing::Bearing& bearing) {
    std::vector<double> values;
    for (const auto& p : friction::parameters(law)) values.push_back(p.initial);
    friction::BearingState<double> s;
    s.bearing = &bearing;
    s.speed = 5000 * rpm;
    s.axial_load = 500;
    s.radial_load = 50;
    s.kinematic_viscosity = 22 * mm2_per_s;
    const auto m = base_moments<double>(law, s, values);
    return std::pair(m.load, m.viscous);
  };
  const bearing::Bearing entered = tests::spindle_bearing();
  for (const FrictionLaw law : {FrictionLaw::palmgren, FrictionLaw::skf}) {
    const auto data = friction::bearing_data(law);
    for (const auto& [datum, changed] : tests::with_each_datum_changed(entered)) {
      const bool said = std::find(data.begin(), data.end(), datum) != data.end();
      EXPECT_EQ(moments(law, changed) != moments(law, entered), said)
          << friction::name(law) << ", " << datum;
    }
  }
}

TEST(FrictionLaw, DemandsTheDataItNeeds) {
  bearing::BearingGeometry g = tests::spindle_geometry();
  g.static_load_rating = unset;
  const bearing::Bearing unrated(g, bearing::steel(), bearing::steel());
  const auto message = [](FrictionLaw law, const bearing::Bearing& b) {
    return tests::message_of([&] { friction::require_data(law, b); });
  };
  EXPECT_THAT(message(FrictionLaw::palmgren, unrated), HasSubstr("static_load_rating is missing"));
  EXPECT_EQ(message(FrictionLaw::skf, unrated), "");
  g = tests::spindle_geometry();
  g.contact_angle = 0.0;
  const bearing::Bearing deep_groove(g, bearing::steel(), bearing::steel());
  EXPECT_EQ(message(FrictionLaw::palmgren, deep_groove), "");
  EXPECT_THAT(message(FrictionLaw::skf, deep_groove), HasSubstr("contact_angle = 0 deg"));
}

}  // namespace
}  // namespace raceway
