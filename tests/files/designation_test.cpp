#include "files/designation.h"

#include <cmath>

#include "files/bearing_estimate.h"
#include "files/boundary_dimensions.h"
#include "files/model_file.h"
#include "tests/reference_table.h"
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
  for (const char* of_15 : {"VEX 70 /NS 7CE1", "SEB70 7CE1 DDL", "E 270 7CE1", "2LA-HSE014C",
                            "5S-2LA-BNS014CLLB", "114HC", "C1914HC", "ZSB114C"})
    EXPECT_EQ(angle_deg(of_15), 15) << of_15;
  for (const char* of_25 : {"VEX707CE3", "HB70 /S 7CE3", "HSE914AD", "5S-2LA-HSL014D", "114HE"})
    EXPECT_EQ(angle_deg(of_25), 25) << of_25;
  EXPECT_EQ(angle_deg("VEB 70 7CE2"), 18);
  for (const char* of_20 : {"HSE014", "2LA-HSE014DB/GNP4", "BNS014LLB"})
    EXPECT_EQ(angle_deg(of_20), 20) << of_20;
  EXPECT_EQ(angle_deg("7014A"), 30);
  EXPECT_EQ(angle_deg("7014 B"), 40);
  EXPECT_EQ(angle_deg("7014 FE/P4A"), 18);
  EXPECT_EQ(angle_deg("70BNR10H"), 18);
  for (const char* none : {"7014", "HCB7014", "VEX 70", "HSF014", "114H", "mine", ""})
    EXPECT_TRUE(std::isnan(read_designation(none).contact_angle)) << none;
}

TEST(Designation, HybridsAreKnownByPrefixOrSuffix) {
  for (const char* hybrid : {"HCB7014", "XCB7014-E", "HCS7014-C", "7014CD/HCP4A", "7014 ACD/HCP4A",
                             "5S-7014UC", "HY S 6014 C", "70BNR10H", "7014C SN24",
                             "VEX 70 /NS 7CE1", "HX70 /S/NS 7CE1", "5S-2LA-HSE014", "C114HE"})
    EXPECT_TRUE(read_designation(hybrid).ceramic_balls) << hybrid;
  for (const char* steel : {"7014 C", "B7014-C", "HS7014-C", "S 6014 C TA", "70BNR10S",
                            "7014CD/P4A", "VEX 70 7CE1", "2LA-HSE014", "114HC"})
    EXPECT_FALSE(read_designation(steel).ceramic_balls) << steel;
}

TEST(Designation, PreloadAndArrangementAreRead) {
  EXPECT_EQ(read_designation("B7014-E-T-P4S-UL").preload, "light");
  EXPECT_EQ(read_designation("7014 CD/P4ADGB").preload, "medium");
  EXPECT_EQ(read_designation("7014UCDB/GNP4").arrangement, "DB");
  EXPECT_EQ(read_designation("7014UCDB/GNP4").preload, "light");
  EXPECT_EQ(read_designation("7014CTYNDBLP4").preload, "light");
  EXPECT_EQ(read_designation("7014CTYNDBC8P4").preload, "medium");
  EXPECT_EQ(read_designation("7014A5TYNSUELP4").preload, "extra light");
  EXPECT_EQ(read_designation("7014 ACD/P4ADBC").preload, "heavy");
  EXPECT_EQ(read_designation("70BNR10XTDBLP4A").arrangement, "DB");
}

TEST(Designation, SizesOfTheSeriesAreOne) {
  for (const char* text : {"7014", "B7014-C", "S 6014 C", "70BNR10S", "VEX 70 7CE1", "EX70",
                           "HSE014C", "114HC", "H7014C-2RZ/P4", "5S-2LA-7014UC"})
    EXPECT_EQ(read_designation(text).size(), "6014") << text;
  for (const char* text :
       {"71914 AC", "7914A5", "S 61914 C", "SEB 70", "HSE914", "1914HC", "70BNR19"})
    EXPECT_EQ(read_designation(text).size(), "61914") << text;
  for (const char* text : {"7214 C", "E 270 7CE1", "214HC", "BNT214"})
    EXPECT_EQ(read_designation(text).size(), "6214") << text;
  for (const char* text : {"mine", "E2.6205", "VEX 71", "114", "HSE714"})
    EXPECT_EQ(read_designation(text).size(), "") << text;
}

/// Sizes as makers print them.
TEST(Designation, BoundaryDimensionsAreThoseOfISO15) {
  for (const tests::ReferenceRow& row : tests::reference_table("boundary_dimensions.csv")) {
    SCOPED_TRACE(row.place());
    const auto size = read_designation(row.text("designation")).boundary();
    ASSERT_TRUE(size);
    EXPECT_DOUBLE_EQ(size->bore, row["bore_mm"] * mm);
    EXPECT_DOUBLE_EQ(size->outer_diameter, row["outer_diameter_mm"] * mm);
    EXPECT_DOUBLE_EQ(size->width, row["width_mm"] * mm);
  }
  for (const CatalogueBearing& row : read_catalogues()) {
    const auto size = read_designation(row.designation).boundary();
    ASSERT_TRUE(size) << row.designation;
    EXPECT_DOUBLE_EQ(size->outer_diameter, row.geometry.outer_diameter) << row.designation;
    EXPECT_DOUBLE_EQ(size->width, row.width) << row.designation;
  }
}

/// Diameters grow with the bore and from series to series.
TEST(Designation, SizesGrowWithBoreAndSeries) {
  double before[5] = {};
  for (int code = 0; code <= 40; ++code) {
    const std::string bore_code = (code < 10 ? "0" : "") + std::to_string(code);
    double smaller = 0.0;
    std::size_t k = 0;
    for (const char* series : {"18", "19", "10", "02", "03"}) {
      const auto size = boundary_dimensions(series, bore_code);
      double& last = before[k++];
      if (!size) continue;
      EXPECT_GT(size->outer_diameter, std::fmax(last, smaller)) << series << bore_code;
      EXPECT_LT(size->width, 0.5 * size->outer_diameter) << series << bore_code;
      last = smaller = size->outer_diameter;
    }
  }
}

TEST(Designation, BearingsOfAnotherTypeAreNamed) {
  for (const auto& [text, words] : {std::pair{"N1012", "a cylindrical roller bearing"},
                                    {"NN3014 K", "cylindrical roller"},
                                    {"HCN1012", "cylindrical roller"},
                                    {"NU 214", "cylindrical roller"},
                                    {"32014 X", "tapered"},
                                    {"22214 E", "spherical"},
                                    {"6014-2RSR", "deep groove"},
                                    {"234414-M-SP", "thrust"},
                                    {"30214", "tapered"},
                                    {"16014", "deep groove"},
                                    {"BSA 201", "screw drives"},
                                    {"30TAC62B", "screw drives"},
                                    {"7602035", "screw drives"},
                                    {"29414", "spherical roller thrust"}})
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
      testing::Contains("bearing.ball_material = \"silicon-nitride\" (from the designation)"));
  EXPECT_THAT(lines(read("7014").defaults),
              testing::Contains("bearing.contact_angle_deg = 15 (assumed, because the designation "
                                "has no contact angle)"));
  EXPECT_THAT(
      tests::message_of([&] { (void)read("N1012"); }),
      HasSubstr(
          "is a cylindrical roller bearing: the catalogue has only single-row angular-contact ball "
          "bearings, such as 7014 C; a model of a cylindrical roller bearing has type = "
          "\"cylindrical-roller\""));
  EXPECT_THAT(tests::message_of([&] { (void)read("51214"); }),
              testing::EndsWith("a thrust ball bearing: the catalogue has only single-row "
                                "angular-contact ball bearings, such as 7014 C"));
}

}  // namespace
}  // namespace raceway::files
