#include "correction/trust.h"

#include <gmock/gmock.h>

#include <cmath>

#include "tests/correction/made_record.h"

namespace raceway::correction {
namespace {

using testing::HasSubstr;
using testing::StartsWith;

constexpr double hour = 3600.0;

/// One lag of 1800 s, with a tolerance of 1 um.
Model judged_by(const Evidence& evidence) {
  Model m{.name = "z", .displacement = record::series_channel("displacement_z_um")};
  m.tolerance = 1 * um;
  m.channels = {{.name = "front",
                 .input = {.columns = {record::series_channel("front_temperature_C")}},
                 .sections = {{5e-6, 1800}}}};
  m.evidence = evidence;
  return m;
}

constexpr Evidence a_day{.error = 0.4 * um, .uncorrected = 12 * um, .duration = 24 * hour};

Evidence evidence_with(void (*change)(Evidence&)) {
  Evidence e = a_day;
  change(e);
  return e;
}

TEST(Trust, IsGoodWhereTheErrorHeldOutIsWithinTheTolerance) {
  EXPECT_EQ(line_of(trust_of(judged_by(a_day))), "good");
}

TEST(Trust, IsNoneWhereNothingShowsAnotherDay) {
  EXPECT_THAT(line_of(trust_of(judged_by(evidence_with([](Evidence& e) { e.error = unset; })))),
              StartsWith("do not use, because no part of the record of the fit could be held out"));
  EXPECT_THAT(
      line_of(trust_of(judged_by(evidence_with([](Evidence& e) { e.one_way = true; })))),
      StartsWith(
          "do not use, because in the record of the fit the displacement changes only once"));
  EXPECT_EQ(
      line_of(trust_of(judged_by(evidence_with([](Evidence& e) { e.duration = 0.4 * hour; })))),
      "do not use, because a time constant of front is 0.5 h, longer than the record of 0.4 h");
}

TEST(Trust, IsNoneWhereTheDisplacementItselfIsHardlyMore) {
  EXPECT_EQ(line_of(trust_of(judged_by(evidence_with(
                [](Evidence& e) { e.error = 12.3 * um, e.uncorrected = 14.7 * um; })))),
            "do not use, because the RMS error on held-out parts is 12.3 um; the RMS displacement "
            "without correction is 14.7 um");
}

TEST(Trust, IsWithinTheRangeWhereReadingsAreShortOrMoreIsLeftThanTolerated) {
  EXPECT_EQ(line_of(trust_of(judged_by(evidence_with([](Evidence& e) { e.duration = hour; })))),
            "only inside its range: a time constant of front is 0.5 h, and the record of 1 h is "
            "shorter than three time constants");
  const Evidence coarse = evidence_with([](Evidence& e) { e.error = 2.5 * um; });
  EXPECT_EQ(line_of(trust_of(judged_by(coarse))),
            "only inside its range: the RMS error on held-out parts is 2.5 um (tolerance 1 um)");
  // Without a tolerance a quarter of the displacement counts.
  Model untold = judged_by(coarse);
  untold.tolerance = unset;
  EXPECT_EQ(trust_of(untold).level, TrustLevel::good);
  untold.evidence->error = 3.5 * um;
  EXPECT_EQ(trust_of(untold).level, TrustLevel::within_range);
}

TEST(Trust, GoesByAnotherRecordWhereThereIsOne) {
  Evidence shown = evidence_with([](Evidence& e) { e.one_way = true, e.other_record = true; });
  EXPECT_EQ(line_of(trust_of(judged_by(shown))), "good");
  shown.error = 10 * um;
  EXPECT_THAT(line_of(trust_of(judged_by(shown))),
              StartsWith("do not use, because the RMS error on another record is 10 um"));
}

TEST(Trust, OnARecordIsNoBetterThanItsReadings) {
  const Model model = judged_by(a_day);
  const Beyond inside{.at_row = std::vector<bool>(100, false)};
  Beyond outside = inside;
  outside.at_row[7] = outside.at_row[8] = true;
  EXPECT_EQ(trust_on(model, {.rms = 1 * um}, 12 * um, inside).level, TrustLevel::good);
  EXPECT_EQ(trust_on(model, {}, unset, inside).level, TrustLevel::good);
  EXPECT_EQ(
      line_of(trust_on(model, {}, unset, outside)),
      "only inside its range: 2 of the 100 rows of this record are outside the range of the model");
  EXPECT_EQ(
      line_of(trust_on(model, {.rms = 12.3 * um}, 14.7 * um, outside)),
      "do not use, because the RMS error on this record is 12.3 um; the RMS displacement without "
      "correction is 14.7 um");
}

/// Up and down again, with a gap in the readings; or up alone.
MadeRecord course_of_made(bool returns) {
  MadeRecord record(20000, 20);
  record.with("front_temperature_C", [](double) { return 20.0; })
      .with("displacement_z_um", [&](double t) {
        if (t > 18000) return unset;
        return returns ? 10.0 * std::sin(2.0 * std::acos(-1.0) * t / 9000) : 10.0 * t / 18000;
      });
  return record;
}

TEST(Trust, EvidenceIsOfTheReadings) {
  const Model model = judged_by({});
  const Evidence e = evidence_on(model, course_of_made(true).record, 0.2 * um);
  EXPECT_EQ(e.error, 0.2 * um);
  EXPECT_FALSE(e.one_way);
  EXPECT_FALSE(e.other_record);
  EXPECT_EQ(e.duration, 18000.0);
  // Of a sine its amplitude over the root of two; one row of 901 is twice there.
  EXPECT_NEAR(e.uncorrected, 10 * um / std::sqrt(2.0), 0.01 * um);
  EXPECT_TRUE(evidence_on(model, course_of_made(false).record, unset).one_way);
}

TEST(Trust, WithoutEvidenceIsNotKnown) {
  Model model = judged_by(a_day);
  model.evidence.reset();
  EXPECT_THAT(line_of(trust_of(model)), StartsWith("not known: "));
}

}  // namespace
}  // namespace raceway::correction
