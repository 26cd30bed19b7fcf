#include "files/displacement_curve.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "tests/support/message_of.h"

namespace raceway::files {
namespace {

using testing::Contains;
using testing::ElementsAre;
using testing::HasSubstr;

DisplacementCurve parsed_curve(const std::string& text) {
  return read_displacement_curve({"u.csv", text});
}

std::string problem(const std::string& text) {
  return tests::message_of([&] { (void)parsed_curve(text); });
}

TEST(DisplacementCurve, IsReadIntoSi) {
  const DisplacementCurve curve =
      parsed_curve("# a comment\nspeed_rpm,axial_displacement_um,std_um\n0,0,0.1\n3000,1.5,0.2\n");
  ASSERT_EQ(curve.points.size(), 2U);
  EXPECT_DOUBLE_EQ(curve.points[1].speed, 100 * pi);
  EXPECT_DOUBLE_EQ(curve.points[1].displacement, 1.5e-6);
  EXPECT_DOUBLE_EQ(curve.points[1].std, 2e-7);
  EXPECT_THAT(texts(curve.notes), ElementsAre());
}

TEST(DisplacementCurve, NamesTheColumnsThatItDoesNotUse) {
  const DisplacementCurve curve = parsed_curve(
      "speed_rpm,axial_displacement_um,front_force_N,rear_force_N,a_deg,b_deg,c_deg\n"
      "0,0,1,1,1,1,1\n3000,1.5,2,2,2,2,2\n");
  EXPECT_THAT(texts(curve.notes),
              ElementsAre("not used: front_force_N, rear_force_N, a_deg, b_deg and 1 "
                          "more"));
  EXPECT_TRUE(std::isnan(curve.points[0].std));
}

TEST(DisplacementCurve, WarnsOfSeveralPreloadsInOneFile) {
  EXPECT_THAT(
      texts(
          parsed_curve("speed_rpm,axial_displacement_um,preload_N\n0,0,100\n3000,1.5,300\n").notes),
      Contains(HasSubstr("preload_N changes from row to row")));
}

TEST(DisplacementCurve, IsReadWithSemicolonsAndDecimalCommas) {
  const DisplacementCurve curve =
      parsed_curve("speed_rpm;axial_displacement_um\r\n0;0\r\n1500,5;-0,25\r\n");
  EXPECT_DOUBLE_EQ(curve.points[1].speed, 1500.5 * rpm);
  EXPECT_DOUBLE_EQ(curve.points[1].displacement, -0.25e-6);
}

TEST(DisplacementCurve, LeavesRowsOutWhoseStatusSaysWhyTheyAreEmpty) {
  const DisplacementCurve curve =
      parsed_curve("speed_rpm,axial_displacement_um,status\n0,0,converged\n9000,,no_equilibrium\n");
  EXPECT_EQ(curve.points.size(), 1U);
  EXPECT_THAT(texts(curve.notes), Contains(HasSubstr("1 of 2 rows have no displacement")));
  EXPECT_THAT(problem("speed_rpm,axial_displacement_um,status\n0,,converged\n"),
              HasSubstr("u.csv:2: axial_displacement_um = \"\": is empty"));
}

// The law was fitted to -9999 um as to any other reading.
TEST(DisplacementCurve, LeavesOutNumbersThatAreNoReadings) {
  const DisplacementCurve curve = parsed_curve(
      "speed_rpm,axial_displacement_um\n0,0\n1000,0.5\n2000,-9999\n3000,1.5\n4000,9.9e37\n");
  EXPECT_EQ(curve.points.size(), 3U);
  EXPECT_THAT(texts(curve.notes),
              ElementsAre("2 of 5 rows have a number that cannot be a reading (such as -9999, or a "
                          "physically impossible value) and are not used (lines 4, 6)"));
}

TEST(DisplacementCurve, NamesEveryBadCellWithItsLine) {
  const std::string text = problem(
      "speed_rpm,axial_displacement_um,std_um\n-5,0,1\n100,nan,1\n200,,1\n300,x,0\n400,1e7,1\n");
  EXPECT_THAT(text, HasSubstr("u.csv:2: speed_rpm = -5: must be from 0 to 1000000"));
  EXPECT_THAT(text, HasSubstr("u.csv:3: axial_displacement_um = \"nan\": is not a finite number"));
  EXPECT_THAT(text, HasSubstr("u.csv:4: axial_displacement_um = \"\": is empty"));
  EXPECT_THAT(text, HasSubstr("u.csv:5: axial_displacement_um = \"x\": is not a number"));
  EXPECT_THAT(text, HasSubstr("u.csv:5: std_um = 0: must be from 1e-09"));
  EXPECT_THAT(text, HasSubstr("u.csv:6: axial_displacement_um = 1e7: must be from"));
  EXPECT_THAT(text, HasSubstr("6 invalid values in 5 rows"));
}

TEST(DisplacementCurve, NamesTheColumnThatWasMeant) {
  EXPECT_THAT(problem("speed_rpm,axial_displacment_um\n0,0\n"),
              HasSubstr("u.csv:1: column axial_displacement_um is missing; did you mean "
                        "axial_displacment_um?"));
  EXPECT_THAT(problem("speed,axial_displacement_um\n0,0\n"), HasSubstr("column speed_rpm"));
  EXPECT_THAT(problem("speed_rpm,axial_displacement_um,std_u\n0,0,1\n"),
              HasSubstr("column std_u is unknown; did you mean std_um?"));
}

TEST(DisplacementTableText, ReadsBackAsACurve) {
  const DisplacementCurve curve = parsed_curve(
      "speed_rpm,axial_displacement_um\n0,0\n1000,0.1\n2000,0.5\n3000,1.5\n4000,1.6\n");
  const shaft::DisplacementTable table = shaft::make_displacement_table(curve.points);
  const std::string text = displacement_table_text(table, "u.csv");
  EXPECT_THAT(text, HasSubstr("speed_rpm,axial_displacement_um,slope_um_rpm\n0,0,"));
  EXPECT_THAT(text, HasSubstr("only rises or only falls"));
  const DisplacementCurve back = parsed_curve(text);
  ASSERT_EQ(back.points.size(), 5U);
  EXPECT_NEAR(back.points[3].displacement, 1.5e-6, 1e-18);
}

}  // namespace
}  // namespace raceway::files
