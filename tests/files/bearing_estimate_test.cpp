#include "files/bearing_estimate.h"

#include <algorithm>

#include "files/model_file.h"
#include "record/units.h"
#include "tests/support/message_of.h"

namespace raceway::files {
namespace {

using testing::HasSubstr;

TEST(BearingEstimate, EveryCatalogueBearingLiesWithinTheSpreadOfTheOthers) {
  const auto rows = read_catalogues();
  std::size_t within = 0, with_balls = 0;
  for (const CatalogueBearing& row : rows) {
    auto others = rows;
    std::erase_if(others, [&](const auto& r) { return r.designation == row.designation; });
    const auto& g = row.geometry;
    const BearingOutline outline{.designation = row.designation,
                                 .bore = g.bore,
                                 .outer_diameter = g.outer_diameter,
                                 .contact_angle = g.contact_angle};
    const EstimatedBearing b = estimated_bearing(outline, others);
    EXPECT_NEAR(b.pitch_diameter.value, g.pitch_diameter, 1e-3 * g.pitch_diameter)
        << row.designation;
    const auto holds = [&](const Estimate& e) {
      return g.ball_diameter > 0.95 * e.lower && g.ball_diameter < 1.05 * e.upper;
    };
    within += holds(b.ball_diameter);
    BearingOutline counted = outline;
    counted.ball_count = g.ball_count;
    const EstimatedBearing c = estimated_bearing(counted, others);
    with_balls += holds(c.ball_diameter);
    // Who knows how many balls there are knows how large they are.
    EXPECT_NEAR(c.ball_diameter.value, g.ball_diameter, 0.16 * g.ball_diameter) << row.designation;
    EXPECT_LT(c.ball_diameter.upper - c.ball_diameter.lower, 0.35 * g.ball_diameter);
  }
  EXPECT_GE(within, rows.size() * 95 / 100);
  EXPECT_GE(with_balls, rows.size() * 95 / 100);
}

TEST(BearingEstimate, ADesignationSaysBoreAndOuterDiameter) {
  const BearingOutline o = outline_of("7014 C");
  EXPECT_DOUBLE_EQ(o.bore, 70 * mm);
  EXPECT_DOUBLE_EQ(o.outer_diameter, 110 * mm);
  EXPECT_DOUBLE_EQ(o.contact_angle, 15 * degree);
  EXPECT_DOUBLE_EQ(outline_of("71914 AC").contact_angle, 25 * degree);
  EXPECT_DOUBLE_EQ(outline_of("71914 AC").outer_diameter, 100 * mm);
  EXPECT_TRUE(std::isnan(outline_of("mine").bore));
  // No row of the catalogue has this size.
  EXPECT_DOUBLE_EQ(outline_of("7214 C").outer_diameter, 125 * mm);
  EXPECT_DOUBLE_EQ(outline_of("7214 C").width, 24 * mm);
}

TEST(BearingEstimate, TheModelMarksWhatIsEstimatedAndReadsBack) {
  const auto rows = read_catalogues();
  BearingOutline o = outline_of("7014 C");
  o.ball_count = 20;
  o.ball_material = "silicon-nitride";
  const std::string text = estimated_model_text(estimated_bearing(o, rows));
  for (const char* key : {"ball_diameter_mm", "pitch_diameter_mm", "inner_conformity",
                          "outer_conformity", "static_load_rating_N"}) {
    const std::size_t at = text.find(std::string(key) + " = ");
    ASSERT_NE(at, text.npos) << key;
    EXPECT_THAT(text.substr(at, text.find('\n', at) - at), HasSubstr("# estimated: ")) << key;
  }
  EXPECT_THAT(text, HasSubstr("ball_count = 20\n"));
  const ModelFile file = parse_model(text, "m.toml");
  EXPECT_EQ(file.model.bearing.geometry().ball_count, 20);
  EXPECT_NEAR(file.model.bearing.geometry().ball_diameter, 11.906 * mm, 1e-6);
  EXPECT_EQ(file.model.bearing.balls().name, "silicon-nitride");
  // Without the number of balls that is an estimate too.
  o.ball_count = 0;
  EXPECT_THAT(estimated_model_text(estimated_bearing(o, rows)),
              testing::ContainsRegex("ball_count = [0-9]+ +# estimated: "));
}

/// A section that the catalogue has not, and one that it has.
TEST(BearingEstimate, TheModelSaysWhichBearingsItIsMadeOf) {
  const auto rows = read_catalogues();
  const auto text = [&](const char* designation) {
    return estimated_model_text(estimated_bearing(outline_of(designation), rows));
  };
  EXPECT_THAT(text("7214 C"),
              HasSubstr("catalogue bearings of similar cross-section, none of series 02"));
  EXPECT_THAT(text("71814 C"), HasSubstr("of any cross-section, none of series 18"));
  EXPECT_THAT(text("7030 C"), testing::Not(HasSubstr("none of series")));
  const ModelFile file = parse_model(text("7214 AC"), "m.toml");
  EXPECT_DOUBLE_EQ(file.model.bearing.geometry().pitch_diameter, 97.5 * mm);
  // The catalogue lacks series 02, whose balls are larger: 22.225 mm in the 218 of books.
  const double estimated = estimated_bearing(outline_of("7218 B"), rows).ball_diameter.value;
  EXPECT_NEAR(estimated, 22.225 * mm, 0.12 * 22.225 * mm);
}

TEST(BearingEstimate, WhatIsNoRingIsRefused) {
  const auto rows = read_catalogues();
  EXPECT_THAT(tests::message_of([&] { (void)estimated_bearing({.designation = "x"}, rows); }),
              HasSubstr("\" is not in the catalogue; to estimate its inner geometry, give --bore "
                        "and --outer-diameter, and --balls if you know the number of balls"));
  EXPECT_THAT(tests::message_of([&] {
                (void)estimated_bearing(
                    {.designation = "x", .bore = 70 * mm, .outer_diameter = 60 * mm}, rows);
              }),
              HasSubstr("--outer-diameter = 60 mm: must be from 1.1 to 5 times the bore"));
}

}  // namespace
}  // namespace raceway::files
