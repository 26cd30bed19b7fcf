#include "files/spindle_record.h"

#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>

#include "files/model_file.h"
#include "files/subject.h"
#include "loop/loop.h"
#include "tests/places.h"

// Records of a spindle with a known hidden effect, made by a detailed model of another kind
// (data/spindles/README.md), through the loop.
namespace raceway::spindle {
namespace {

struct Case {
  std::shared_ptr<const model::ModelSubject> subject;
  record::Record train, test;
};

Case read_case(const std::string& name) {
  const std::filesystem::path folder =
      std::filesystem::path(tests::source_dir()) / "data" / "spindles" / name;
  const files::ModelFile file = files::read_model((folder / "model.toml").string());
  const model::Spindle& spindle = *file.model.spindle;
  return {files::make_subject(file.model),
          files::read_spindle_record((folder / "train.csv").string(), spindle),
          files::read_spindle_record((folder / "test.csv").string(), spindle)};
}

/// What is left on a record that no fit saw, as root mean squares: of all thermometers together, of
/// the worst one, of the nose.
struct Errors {
  double kelvin = 0.0, worst_kelvin = 0.0, um = 0.0;
};

Errors errors_on(const fit::Subject& subject, const record::Record& record) {
  Errors left;
  int thermometers = 0;
  for (const verdict::Comparison& c : verdict::compare(subject, record)) {
    if (*c.channel == record::axial_displacement) {
      left.um = c.rmse / raceway::um;
      continue;
    }
    left.kelvin += c.rmse * c.rmse;
    left.worst_kelvin = std::max(left.worst_kelvin, c.rmse);
    ++thermometers;
  }
  left.kelvin = std::sqrt(left.kelvin / thermometers);
  return left;
}

constexpr double true_f0 = 0.6;
// Bars of the records, noise of 0.1 K and 0.3 um included.
constexpr double bar_K = 0.3, bar_um = 0.7;
// The end of the shaft with a drive's heat, which the model spreads over all of the end.
constexpr double worst_K = 0.4;

TEST(SpindleRecord, NothingIsMissingWhereNothingIsHidden) {
  const Case c = read_case("clean");
  const verdict::Diagnosis d = loop::diagnose(*c.subject, c.train, {});
  EXPECT_EQ(d.verdict, verdict::Verdict::nothing_missing) << d.sentence;
  EXPECT_EQ(d.channels.size(), 6u);
  const verdict::Calibration fitted = loop::calibrate(*c.subject, c.train);
  EXPECT_NEAR(fitted.parameters.at(0).value, true_f0, 0.03);
  const Errors e = errors_on(*fitted.subject, c.test);
  EXPECT_LE(e.kelvin, bar_K);
  EXPECT_LE(e.worst_kelvin, worst_K);
  EXPECT_LE(e.um, bar_um);
}

TEST(SpindleRecord, SeatsThatHoldHeatBackAreFound) {
  const Case c = read_case("seats");
  const verdict::Diagnosis d = loop::diagnose(*c.subject, c.train, {});
  ASSERT_EQ(d.verdict, verdict::Verdict::effect) << d.sentence;
  EXPECT_EQ(d.effects.front().id, "seat-conductance");
  EXPECT_NEAR(d.effects.front().parameters.front().value, 0.15, 0.03);
  const verdict::AddResult added =
      loop::add(*c.subject, std::vector<std::string>{"seat-conductance"}, c.train);
  ASSERT_FALSE(added.refused) << added.reason;
  const Errors e = errors_on(*added.calibration.subject, c.test);
  EXPECT_LE(e.kelvin, bar_K);
  EXPECT_LE(e.worst_kelvin, worst_K);
  EXPECT_LE(e.um, bar_um);
}

TEST(SpindleRecord, HeatOfTheDriveIsFound) {
  const Case c = read_case("drive");
  const verdict::Diagnosis d = loop::diagnose(*c.subject, c.train, {});
  ASSERT_EQ(d.verdict, verdict::Verdict::effect) << d.sentence;
  EXPECT_EQ(d.effects.front().id, "drive-heat");
  EXPECT_NEAR(d.effects.front().parameters.front().value, 150.0, 10.0);
  const verdict::AddResult added =
      loop::add(*c.subject, std::vector<std::string>{"drive-heat"}, c.train);
  ASSERT_FALSE(added.refused) << added.reason;
  const Errors e = errors_on(*added.calibration.subject, c.test);
  EXPECT_LE(e.kelvin, bar_K);
  EXPECT_LE(e.worst_kelvin, worst_K);
  EXPECT_LE(e.um, bar_um);
}

}  // namespace
}  // namespace raceway::spindle
