#include "files/roller_estimate.h"

#include <cmath>
#include <string>

#include "files/model_file.h"
#include "life/roller_life.h"
#include "tests/roller/reference_cases.h"
#include "tests/support/message_of.h"

namespace raceway::roller {
namespace {

using testing::HasSubstr;

TEST(RollerEstimate, KnowsDesignationsOfCylindricalRollers) {
  EXPECT_TRUE(files::names_rollers("N1012"));
  EXPECT_TRUE(files::names_rollers("nu 210 ecp"));
  EXPECT_FALSE(files::names_rollers("7014 C"));
  EXPECT_FALSE(files::names_rollers("NSK 7014"));
}

// E gives the diameter of the rollers and C0 their number; the printed C is used for neither.
TEST(RollerEstimate, RollersByPrintedNumbersMeetThePrintedDynamicRating) {
  int within = 0, printed = 0;
  for (int code = 6; code <= 24; ++code) {
    if (code == 23) continue;
    const files::EstimatedRollers one =
        files::estimated_rollers((code < 10 ? "N 100" : "N 10") + std::to_string(code));
    if (!one.printed()) continue;
    ++printed;
    const double twice = one.geometry.roller_diameter / (0.5 * mm);
    EXPECT_NEAR(twice, std::round(twice), 1e-9) << code;  // rollers come in steps of 0.5 mm
    EXPECT_NEAR(life::static_load_rating(one.geometry) / one.static_rating, 1.0, 0.025) << code;
    const double ratio = life::dynamic_load_rating(one.geometry) / one.dynamic_rating;
    EXPECT_NEAR(ratio, 1.0, 0.17) << code;
    if (std::abs(ratio - 1.0) < 0.021) ++within;
  }
  EXPECT_EQ(printed, 11);
  EXPECT_EQ(within, 8);
}

TEST(RollerEstimate, WritesAModelThatReadsBack) {
  const auto read = [](const char* designation, friction::FrictionLaw law) {
    const files::EstimatedRollers rollers = files::estimated_rollers(designation);
    const files::ModelFile file = files::parse_model(
        files::estimated_model_text(rollers, law, "silicon-nitride"), "n10.toml");
    EXPECT_EQ(file.model.law, law);
    EXPECT_EQ(file.model.bearing.rollers()->rollers().name, "silicon-nitride");
    return file.model.bearing.rollers()->geometry();
  };
  const bearing::RollerGeometry n1012 =
      read("N1012 KTN/SP", friction::FrictionLaw::roller_palmgren);
  EXPECT_EQ(n1012.roller_count, 22);
  EXPECT_NEAR(n1012.roller_diameter, 8 * mm, 1e-12);
  EXPECT_NEAR(n1012.width, 18 * mm, 1e-12);
  const bearing::RollerGeometry n1014 = read("N 1014", friction::FrictionLaw::roller_skf);
  // A size of no catalogue here.
  EXPECT_NEAR(read("N 1030", friction::FrictionLaw::roller_skf).outer_diameter, 225 * mm, 1e-12);
  EXPECT_NEAR(n1014.bore, 70 * mm, 1e-12);
  EXPECT_NEAR(n1014.roller_diameter, 9.5 * mm, 1e-12);  // 0.485 of 20 mm
}

TEST(RollerEstimate, RefusesOtherSeriesAndSizes) {
  const auto why = [](const char* designation) {
    return tests::message_of([&] { (void)files::estimated_rollers(designation); });
  };
  EXPECT_THAT(why("NU 210"), HasSubstr("only cylindrical roller bearings of series N10"));
  EXPECT_THAT(why("N 1099"), HasSubstr("no boundary dimensions for this size"));
}

}  // namespace
}  // namespace raceway::roller
