#include "files/catalogue_file.h"

#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>

#include "record/units.h"
#include "tests/places.h"
#include "tests/support/message_of.h"

namespace raceway::files {
namespace {

using testing::HasSubstr;

std::string written(const std::string& name, const std::string& text) {
  const std::string path = testing::TempDir() + name;
  std::ofstream(path) << text;
  return path;
}

const std::string catalogue_header =
    "designation,bore_mm,outer_diameter_mm,pitch_diameter_mm,ball_diameter_mm,ball_count,"
    "contact_angle_deg,static_load_rating_steel_N\n";

TEST(CatalogueFile, ARowIsReadInSI) {
  const auto rows = read_catalogue(
      written("acme_spindle.csv", catalogue_header + "X 1 C,70,110,90,11.906,20,15,43000\n"));
  ASSERT_EQ(rows.size(), 1u);
  const auto& g = rows[0].geometry;
  EXPECT_EQ(rows[0].full_name(), "ACME X 1 C");
  EXPECT_EQ(g.ball_count, 20);
  EXPECT_DOUBLE_EQ(g.ball_diameter, 11.906e-3);
  EXPECT_DOUBLE_EQ(g.pitch_diameter, 0.09);
  EXPECT_DOUBLE_EQ(g.contact_angle, 15 * degree);
  EXPECT_DOUBLE_EQ(g.bore, 0.07);
  EXPECT_DOUBLE_EQ(g.static_load_rating, 43000);
  EXPECT_DOUBLE_EQ(g.inner_conformity, 0.52);
  EXPECT_TRUE(std::isnan(rows[0].mass));
}

TEST(CatalogueFile, TheMakerMayBeNamedInAComment) {
  const auto rows = read_catalogue(written("x.csv", "# maker: Acme Works\n" + catalogue_header +
                                                        "X 1 C,70,110,90,11.906,20,15,43000\n"));
  EXPECT_EQ(rows[0].maker, "Acme Works");
}

TEST(CatalogueFile, ImpossibleValuesAndMissingColumnsAreNamed) {
  EXPECT_THAT(tests::message_of([] {
                (void)read_catalogue(
                    written("b.csv", catalogue_header + "X,70,110,90,11.9,2.5,15,43000\n"));
              }),
              HasSubstr("b.csv:2: ball_count = 2.5: must be a whole number from 3 to 200"));
  EXPECT_THAT(tests::message_of([] {
                (void)read_catalogue(
                    written("b.csv", catalogue_header + "X,70,110,-90,11.9,20,15,43000\n"));
              }),
              HasSubstr("b.csv:2: pitch_diameter_mm = -90"));
  EXPECT_THAT(tests::message_of([] { (void)read_catalogue(written("b.csv", "designation\nX\n")); }),
              HasSubstr("b.csv:1: column ball_count is missing"));
}

TEST(CatalogueFile, NamesMatchWhateverTheirCaseBlanksMakerAndCage) {
  const auto rows = read_catalogues();
  for (const char* name : {"S 6014 C", "S 6014 C TA", "GMN S 6014 C", "s6014c", "gmn s6014cta"}) {
    EXPECT_EQ(find_bearing(rows, name).designation, "S 6014 C TA") << name;
  }
}

TEST(CatalogueFile, UnknownBearingsAreAnsweredWithTheNearest) {
  const auto rows = read_catalogues();
  EXPECT_THAT(tests::message_of([&] { (void)find_bearing(rows, "S 6014"); }),
              HasSubstr("GMN S 6014 C TA"));
  EXPECT_EQ(tests::message_of([&] { (void)find_bearing(rows, "something else"); }),
            "bearing \"something else\" is not in the catalogue");
}

TEST(CatalogueFile, FiltersFindPartsOfNames) {
  const auto rows = read_catalogues();
  EXPECT_EQ(matching_bearings(rows, "").size(), rows.size());
  const auto some = matching_bearings(rows, "s 6014");
  ASSERT_FALSE(some.empty());
  for (const auto& row : some) EXPECT_THAT(row.designation, HasSubstr("6014"));
  EXPECT_TRUE(matching_bearings(rows, "no such").empty());
}

TEST(CatalogueFile, EveryRowIsABearingThatCanBe) {
  for (const auto& row : read_catalogues())
    EXPECT_NO_THROW((void)bearing::validated(row.geometry)) << row.full_name();
}

TEST(CatalogueFile, TheDataDirectoryMayBeNamedByTheUser) {
  ::setenv("RACEWAY_DATA", "/no/such/folder", 1);
  EXPECT_EQ(tests::message_of([] { (void)read_catalogues(); }),
            "RACEWAY_DATA = /no/such/folder: this folder does not exist");
  const std::string own = testing::TempDir() + "own_bearings";
  std::filesystem::remove_all(own);
  std::filesystem::create_directories(own);
  ::setenv("RACEWAY_DATA", own.c_str(), 1);
  EXPECT_THAT(tests::message_of([] { (void)read_catalogues(); }),
              HasSubstr("no catalogue of bearings"));
  std::ofstream(own + "/acme.csv") << catalogue_header + "X 7014,70,110,90,11.906,20,15,43000\n" +
                                          "S 6014 C,70,110,90,12.7,19,15,44000\n";
  const auto rows = read_catalogues();
  EXPECT_EQ(find_bearing(rows, "X 7014").full_name(), "ACME X 7014");
  // Beside ours, and before them where two are called alike.
  EXPECT_EQ(find_bearing(rows, "S 6014 C").maker, "ACME");
  EXPECT_EQ(find_bearing(rows, "GMN S 6014 C").maker, "GMN");
  EXPECT_EQ(find_bearing(rows, "S 6010 C").maker, "GMN");
  ::unsetenv("RACEWAY_DATA");
  EXPECT_EQ(data_directory(), tests::source_dir() + "/data");
  EXPECT_EQ(own_data_directory(), "");
}

}  // namespace
}  // namespace raceway::files
