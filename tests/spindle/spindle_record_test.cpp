#include "io/spindle_record.h"

#include <gtest/gtest.h>

#include <filesystem>

#include "fit/add.h"
#include "fit/calibrate.h"
#include "fit/diagnose.h"
#include "io/model_file.h"
#include "io/subject.h"

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
      std::filesystem::path(RACEWAY_SOURCE_DIR) / "data" / "spindles" / name;
  const io::ModelFile file = io::read_model((folder / "model.toml").string());
  const model::Spindle& spindle = *file.model.spindle;
  return {io::make_subject(file.model),
          io::read_spindle_record((folder / "train.csv").string(), spindle),
          io::read_spindle_record((folder / "test.csv").string(), spindle)};
}

/// Worst channel of each kind on a record that no fit saw: residuals as root mean squares, in K and
/// in um.
struct Errors {
  double kelvin = 0.0, um = 0.0;
};

Errors errors_on(const fit::Subject& subject, const record::Record& record) {
  Errors worst;
  for (const fit::Comparison& c : fit::compare(subject, record)) {
    if (*c.channel == record::axial_displacement)
      worst.um = std::max(worst.um, c.rmse / raceway::um);
    else
      worst.kelvin = std::max(worst.kelvin, c.rmse);
  }
  return worst;
}

constexpr double true_f0 = 0.6;
// What is left of the worst sensor, that at the rear bearing, which the model reads 0.3 K too cold;
// why is not known. The aim is 0.3 K.
constexpr double reached_K = 0.42;
constexpr double reached_um = 0.7;

TEST(SpindleRecord, NothingIsMissingWhereNothingIsHidden) {
  const Case c = read_case("clean");
  const fit::Diagnosis d = fit::diagnose(*c.subject, c.train, {});
  EXPECT_EQ(d.verdict, fit::Verdict::nothing_missing) << d.sentence;
  EXPECT_EQ(d.channels.size(), 6u);
  const fit::Calibration fitted = fit::calibrate(*c.subject, c.train);
  EXPECT_NEAR(fitted.parameters.at(0).value, true_f0, 0.03);
  const Errors e = errors_on(*fitted.subject, c.test);
  EXPECT_LE(e.kelvin, reached_K);
  EXPECT_LE(e.um, reached_um);
}

TEST(SpindleRecord, SeatsThatHoldHeatBackAreFound) {
  const Case c = read_case("seats");
  const fit::Diagnosis d = fit::diagnose(*c.subject, c.train, {});
  ASSERT_EQ(d.verdict, fit::Verdict::effect) << d.sentence;
  EXPECT_EQ(d.effects.front().id, "seat-conductance");
  EXPECT_NEAR(d.effects.front().parameters.front().value, 0.15, 0.03);
  const fit::AddResult added =
      fit::add(*c.subject, std::vector<std::string>{"seat-conductance"}, c.train);
  ASSERT_FALSE(added.refused) << added.reason;
  const Errors e = errors_on(*added.calibration.subject, c.test);
  EXPECT_LE(e.kelvin, reached_K);
  EXPECT_LE(e.um, reached_um);
}

TEST(SpindleRecord, HeatOfTheDriveIsFound) {
  const Case c = read_case("drive");
  const fit::Diagnosis d = fit::diagnose(*c.subject, c.train, {});
  ASSERT_EQ(d.verdict, fit::Verdict::effect) << d.sentence;
  EXPECT_EQ(d.effects.front().id, "drive-heat");
  EXPECT_NEAR(d.effects.front().parameters.front().value, 150.0, 10.0);
  const fit::AddResult added =
      fit::add(*c.subject, std::vector<std::string>{"drive-heat"}, c.train);
  ASSERT_FALSE(added.refused) << added.reason;
  const Errors e = errors_on(*added.calibration.subject, c.test);
  EXPECT_LE(e.kelvin, reached_K);
  EXPECT_LE(e.um, reached_um);
}

}  // namespace
}  // namespace raceway::spindle
