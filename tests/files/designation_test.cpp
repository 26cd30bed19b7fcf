#include "files/designation.h"

#include <cmath>

#include "files/bearing_estimate.h"
#include "files/model_file.h"
#include "tests/support/message_of.h"

namespace raceway::files {
namespace {

using testing::HasSubstr;

double angle_deg(std::string_view designation) {
  return std::round(read_designation(designation).contact_angle / degree);
}

TEST(Designation, AnglesOfTheMakersSystems) {
  for (const char* of_15 : {"7014 C", "B7014-C-T-P4S", "HCB7014-C", "7014 CD/P4A", "7014 CE/HCP4A",
                            "7014CTYNSULP4", "7014UCGD2/GNP4", "S 6014 C TA", "FAG B7014-C"})
    EXPECT_EQ(angle_deg(of_15), 15) << of_15;
  for (const char* of_25 : {"71914 AC", "7014 ACD/P4A", "B7014-E", "XCB7014-E-T-P4S", "7014A5",
                            "7014A5TRDUMP4", "7014UADG/GNP42", "S 6014 E TA", "70BER10S"})
    EXPECT_EQ(angle_deg(of_25), 25) << of_25;
  EXPECT_EQ(angle_deg("7014A"), 30);
  EXPECT_EQ(angle_deg("7014 B"), 40);
  EXPECT_EQ(angle_deg("7014 FE/P4A"), 18);
  EXPECT_EQ(angle_deg("70BNR10H"), 18);
  for (const char* none : {"7014", "HCB7014", "mine", ""})
    EXPECT_TRUE(std::isnan(read_designation(none).contact_angle)) << none;
}

TEST(Designation, HybridsAreKnownByPrefixOrSuffix) {
  for (const char* hybrid : {"HCB7014", "XCB7014-E", "HCS7014-C", "7014CD/HCP4A", "7014 ACD/HCP4A",
                             "5S-7014UC", "HY S 6014 C", "70BNR10H", "7014C SN24"})
    EXPECT_TRUE(read_designation(hybrid).ceramic_balls) << hybrid;
  for (const char* steel :
       {"7014 C", "B7014-C", "HS7014-C", "S 6014 C TA", "70BNR10S", "7014CD/P4A"})
    EXPECT_FALSE(read_designation(steel).ceramic_balls) << steel;
}

TEST(Designation, PreloadAndArrangementAreRead) {
  EXPECT_EQ(read_designation("B7014-E-T-P4S-UL").preload, "light");
  EXPECT_EQ(read_designation("7014 CD/P4ADGB").preload, "medium");
  EXPECT_EQ(read_designation("7014UCDB/GNP4").arrangement, "DB");
}

TEST(Designation, SizesOfTheSeriesAreOne) {
  for (const char* text : {"7014", "B7014-C", "S 6014 C", "70BNR10S"})
    EXPECT_EQ(read_designation(text).size(), "6014") << text;
  for (const char* text : {"71914 AC", "7914A5", "S 61914 C"})
    EXPECT_EQ(read_designation(text).size(), "61914") << text;
  EXPECT_EQ(read_designation("mine").size(), "");
}

TEST(Designation, BearingsOfAnotherTypeAreNamed) {
  for (const auto& [text, words] : {std::pair{"N1012", "a cylindrical roller bearing"},
                                    {"NN3014 K", "cylindrical roller"},
                                    {"HCN1012", "cylindrical roller"},
                                    {"NU 214", "cylindrical roller"},
                                    {"32014 X", "tapered"},
                                    {"22214 E", "spherical"},
                                    {"6014-2RSR", "deep groove"},
                                    {"234414-M-SP", "thrust"}})
    EXPECT_THAT(tests::message_of([&, t = text] { require_angular_contact(t); }), HasSubstr(words))
        << text;
  for (const char* text : {"7014 C", "S 6014 C", "HCB7014", "mine", "X 7014"})
    EXPECT_NO_THROW(require_angular_contact(text)) << text;
}

/// A model may name any bearing that can be estimated.
TEST(Designation, AModelMayNameABearingThatNoCatalogueHas) {
  const auto read = [](const std::string& name) {
    return parse_model("[bearing]\ncatalogue = \"" + name +
                           "\"\n[lubricant]\nviscosity_40C_mm2_s = 22\n"
                           "viscosity_100C_mm2_s = 4.8\n",
                       "m.toml");
  };
  const ModelFile hybrid = read("HCB7014-E");
  EXPECT_EQ(hybrid.model.bearing.balls().name, "silicon-nitride");
  EXPECT_DOUBLE_EQ(hybrid.model.bearing.geometry().contact_angle, 25 * degree);
  EXPECT_DOUBLE_EQ(hybrid.model.bearing.geometry().bore, 70 * mm);
  EXPECT_EQ(hybrid.model.name, "HCB7014-E");
  EXPECT_THAT(
      lines(hybrid.defaults),
      testing::Contains("bearing.ball_material = \"silicon-nitride\" (by the designation)"));
  EXPECT_THAT(
      lines(read("7014").defaults),
      testing::Contains("bearing.contact_angle_deg = 15 (assumed, the designation states none)"));
  EXPECT_THAT(
      tests::message_of([&] { (void)read("N1012"); }),
      HasSubstr("a cylindrical roller bearing: the catalogue has single-row angular-contact "
                "ball bearings, as 7014 C; a model of rollers has type = "
                "\"cylindrical-roller\""));
  EXPECT_THAT(tests::message_of([&] { (void)read("51214"); }),
              testing::EndsWith("a thrust ball bearing: the catalogue has single-row "
                                "angular-contact ball bearings, as 7014 C"));
}

}  // namespace
}  // namespace raceway::files
