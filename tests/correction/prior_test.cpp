// Numbers that a record cannot tell stay at their priors; those that it tells follow the record.
#include "correction/prior.h"

#include <gmock/gmock.h>

#include <algorithm>
#include <random>

#include "correction/correction_subject.h"
#include "correction/simulation.h"
#include "loop/loop.h"
#include "tests/correction/made_record.h"

namespace raceway::correction {
namespace {

using testing::Contains;
using testing::Field;
using testing::HasSubstr;

/// A room, and a law of instant displacement.
Model room_and_law() {
  Model m;
  m.displacement = record::series_channel("displacement_z_um");
  m.tolerance = 2.0 * um;
  DrivenChannel ambient{.name = "room"};
  ambient.input.columns = {record::series_channel("ambient_temperature_C")};
  ambient.input.name = "ambient_temperature_C";
  ambient.sections = {{.gain = -3.0 * um, .time_constant = 7200.0}};
  m.channels.push_back(std::move(ambient));
  m.kinematic = Kinematic{0.00115, 0.6151, 0.000634};
  return m;
}

/// The readings of a model with noise of 0.3 um.
record::Record read_by(const Model& truth, bool turns) {
  MadeRecord made(36 * 3600.0, 120.0);
  made.with("speed_rpm", [&](double t) { return turns ? stepped_speed(t, 3600.0) : 0.0; })
      .with("ambient_temperature_C", [](double t) { return 20.0 + 2.0 * std::sin(t / 9000.0); });
  std::vector<double> readings(made.record.rows());
  simulate(truth, Series(made.record), readings);
  std::mt19937 engine(5);
  std::normal_distribution<double> noise(0.0, 0.3 * um);
  for (double& r : readings) r += noise(engine);
  made.record.set(*truth.displacement, std::move(readings));
  return made.record;
}

const record::Parameter& named(const verdict::Calibration& found, const std::string& name) {
  const auto at = std::find_if(found.parameters.begin(), found.parameters.end(),
                               [&](const record::Parameter& p) { return p.name == name; });
  EXPECT_NE(at, found.parameters.end()) << name;
  return *at;
}

TEST(Prior, OfANumberThatTheRecordCannotTellStaysAndIsSaid) {
  Model m = room_and_law();
  m.priors = computed_priors(m);
  const record::Record at_rest = read_by(m, false);
  m.channels[0].sections[0].gain = -2.0 * um;
  const verdict::Calibration found = loop::calibrate(CorrectionSubject(m), at_rest);
  for (const char* const name : {"kinematic.A", "kinematic.B", "kinematic.C"}) {
    const record::Parameter& p = named(found, name);
    EXPECT_EQ(p.value, p.prior.value) << name;
    EXPECT_EQ(p.std, p.prior.std) << name;
    EXPECT_TRUE(p.held) << name;
    EXPECT_THAT(found.messages,
                Contains(Field(&record::Note::text, HasSubstr(std::string(name) + " stays at "))));
  }
  EXPECT_NEAR(named(found, "room.gain_1").value, -3.0, 0.05);
  EXPECT_EQ(found.correlation.rows(), std::ssize(found.parameters));
}

/// Three of its standard uncertainties away.
TEST(Prior, OfANumberThatTheRecordTellsGivesWay) {
  const Model truth = room_and_law();
  const record::Record turning = read_by(truth, true);
  Model m = truth;
  m.kinematic->A *= 1.6;
  m.priors = {{"kinematic.A", {.value = m.kinematic->A, .std = 0.2 * truth.kinematic->A}}};
  m.free = {"offset", "gains", "time_constants", "kinematic.A"};
  const verdict::Calibration found = loop::calibrate(CorrectionSubject(m), turning);
  const record::Parameter& p = named(found, "kinematic.A");
  EXPECT_FALSE(p.held);
  EXPECT_LT(p.std, 0.05 * p.prior.std);
  EXPECT_NEAR(p.value / truth.kinematic->A, 1.0, 0.02);
  // What a fit without it finds, within its error.
  m.priors.clear();
  const verdict::Calibration alone = loop::calibrate(CorrectionSubject(m), turning);
  EXPECT_NEAR(named(alone, "kinematic.A").value, p.value, p.std);
}

/// A fit that begins at a fit of the same record with the same priors stays there.
TEST(Prior, DoesNotWanderWithRepeatedFits) {
  Model m = room_and_law();
  m.priors = computed_priors(m);
  const record::Record turning = read_by(room_and_law(), true);
  m.kinematic->A *= 1.3;
  m.priors = computed_priors(m);
  const verdict::Calibration first = loop::calibrate(CorrectionSubject(m), turning);
  const verdict::Calibration second =
      loop::calibrate(CorrectionSubject(model_of(*first.subject)), turning);
  for (const char* const name : {"kinematic.A", "kinematic.B", "kinematic.C"})
    EXPECT_NEAR(named(second, name).value, named(first, name).value, 0.05 * named(first, name).std)
        << name;
}

/// A fit that is worse than its start on parts that it has not seen.
TEST(Calibrate, SaysWhereTheModelWasBetterBefore) {
  const Model truth = room_and_law();
  record::Record turning = read_by(truth, true);
  // In one part something moved that no model knows.
  std::vector<double> readings(turning.values(*truth.displacement).begin(),
                               turning.values(*truth.displacement).end());
  for (std::size_t k = 0; k < readings.size() / 8; ++k) readings[k] += 40.0 * um;
  turning.set(*truth.displacement, std::move(readings));
  const verdict::Calibration found = loop::calibrate(CorrectionSubject(truth), turning);
  EXPECT_THAT(found.messages,
              Contains(Field(&record::Note::text, HasSubstr("but before the fit the error was"))));
  const verdict::Calibration good = loop::calibrate(
      [] {
        Model m = room_and_law();
        m.channels[0].sections[0].gain = -2.0 * um;
        return CorrectionSubject(m);
      }(),
      read_by(truth, true));
  for (const record::Note& note : good.messages)
    EXPECT_THAT(note.text, testing::Not(HasSubstr("before the fit")));
}

TEST(Prior, OfAComputedSpindleIsOfItsScaleAndItsLaw) {
  Model m = room_and_law();
  const std::vector<NumberPrior> priors = computed_priors(m);
  ASSERT_EQ(priors.size(), 3U);
  EXPECT_EQ(priors[0].name, "kinematic.A");
  EXPECT_DOUBLE_EQ(priors[0].prior.std, 0.2 * 0.00115);
  m.kinematic.reset();
  EXPECT_TRUE(computed_priors(m).empty());
}

}  // namespace
}  // namespace raceway::correction
