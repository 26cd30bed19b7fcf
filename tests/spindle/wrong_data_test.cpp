#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "loop/loop.h"
#include "model/parameters.h"
#include "record/spindle_channel.h"
#include "spindle/spindle.h"
#include "spindle/spindle_subject.h"
#include "tests/spindle/base_spindle.h"
#include "tests/spindle/recorded_hours.h"

// Numbers of a spindle that were entered wrong.
namespace raceway::spindle {
namespace {

model::Model measured_spindle() {
  model::Model m = base_spindle();
  using Part = model::ThermometerPlace::Part;
  const auto add = [&](const char* name, Part part, double position, double radius) {
    m.spindle->sensors.push_back(
        {.name = name, .part = part, .position = position * mm, .radius = radius * mm});
  };
  add("front", Part::housing, 60, 57);
  add("rear", Part::housing, 290, 57);
  add("ring", Part::ring, 60, 53);
  add("end", Part::shaft, 365, 29);
  m.spindle->cells = model::Cells::coarse;
  return m;
}

bool has(const std::vector<fit::Candidate>& all, const std::string& id) {
  return std::any_of(all.begin(), all.end(), [&](const fit::Candidate& c) { return c.id == id; });
}

TEST(SpindleWrongData, AreCandidatesThatAreWordedAsData) {
  const std::vector<fit::Candidate> all = SpindleSubject(measured_spindle()).candidates();
  for (const char* id :
       {"sensor-place:front", "sensor-place:ring", "coolant-inlet", "viscosity-slope", "mounting"})
    EXPECT_TRUE(has(all, id)) << id;
  for (const fit::Candidate& c : all)
    if (c.id.starts_with("sensor-place:")) {
      EXPECT_EQ(c.datum, "the place of the thermometer " + c.id.substr(c.id.find(':') + 1));
    }
  // Friction and preload do what they do.
  EXPECT_FALSE(has(all, "contact-angle"));
  EXPECT_FALSE(has(all, "lubricant-viscosity"));
}

TEST(SpindleWrongData, AThermometerStaysInItsPart) {
  const model::Model m = measured_spindle();
  for (const record::Parameter& p : model::parameters(m)) {
    if (p.name == "sensor.front.position_mm") {
      EXPECT_DOUBLE_EQ(p.value, 60.0);
      EXPECT_DOUBLE_EQ(p.lower, 40.0);
      EXPECT_DOUBLE_EQ(p.upper, 315.0);
    } else if (p.name == "sensor.ring.position_mm") {
      EXPECT_DOUBLE_EQ(p.lower, 50.0);
      EXPECT_DOUBLE_EQ(p.upper, 70.0);
    } else if (p.name == "sensor.end.position_mm") {  // at a radius that thinner pieces have, too
      EXPECT_DOUBLE_EQ(p.lower, 0.0);
      EXPECT_DOUBLE_EQ(p.upper, 375.0);
    }
  }
}

TEST(SpindleWrongData, AMovedThermometerReadsAsOneThatWasEnteredThere) {
  model::Model m = measured_spindle();
  const record::Record record = recorded(m);
  const SpindleSubject subject(m);
  const std::vector<std::string> on{"sensor-place:front"};
  const std::unique_ptr<fit::Subject> with = subject.with_candidates(on);
  const auto predictor =
      with->predictor(record, {"sensor-place:front.position_mm"}, with->prepare(record));
  std::vector<double> read(subject.measured().size() * record.rows());
  for (const double place : {60.0, 71.3, 52.0}) {
    predictor->readings(std::vector<double>{place}, read);
    m.spindle->sensors.front().position = place * mm;
    const std::vector<double> there = fit::predict(SpindleSubject(m), record);
    for (std::size_t k = 0; k < read.size(); ++k) EXPECT_NEAR(read[k], there[k], 1e-9) << place;
  }
}

TEST(SpindleWrongData, FewReadingsAreThoseOfTheChannelsInTheRecord) {
  const model::Model m = measured_spindle();
  const record::Record all = recorded(m);
  std::vector<std::size_t> rows;
  for (std::size_t k = 0; k < all.rows(); k += 4) rows.push_back(k);
  record::Record few = all.picked(rows);
  std::vector<const record::Channel*> gone{&record::axial_displacement};
  for (std::size_t k = 1; k < m.spindle->sensors.size(); ++k)
    gone.push_back(&record::sensor_channel(m.spindle->sensors[k].name));
  std::erase_if(few.columns, [&](const record::Column& c) {
    return std::any_of(gone.begin(), gone.end(),
                       [&](const record::Channel* g) { return *g == *c.channel; });
  });
  const verdict::Diagnosis d = loop::diagnose(SpindleSubject(m), few, {});
  const auto said = std::find_if(d.messages.begin(), d.messages.end(), [](const auto& note) {
    return note.text.starts_with("only 30 readings of ");
  });
  ASSERT_NE(said, d.messages.end());
  EXPECT_TRUE(said->text.starts_with("only 30 readings of front temperature:")) << said->text;
}

TEST(SpindleWrongData, AThermometerAwayFromItsPlaceIsFoundAndPutThere) {
  model::Model m = measured_spindle();
  m.spindle->sensors.front().position = 78 * mm;
  const record::Record record = recorded(m);
  m.spindle->sensors.front().position = 60 * mm;
  const SpindleSubject subject(m);
  const verdict::Diagnosis d = loop::diagnose(subject, record, {});
  ASSERT_EQ(d.verdict, verdict::Verdict::effect) << d.sentence;
  const verdict::RankedEffect& found = d.effects.front();
  EXPECT_EQ(found.id, "sensor-place:front");
  EXPECT_NEAR(found.parameters.front().value, 78.0, 2.0);
  EXPECT_TRUE(
      d.headline.starts_with("Wrong data rather than missing physics: check the place of "
                             "the thermometer front, position 7"))
      << d.headline;
  const verdict::AddResult added =
      loop::add(subject, std::vector<std::string>{"sensor-place:front"}, record);
  ASSERT_FALSE(added.refused) << added.reason;
  EXPECT_NEAR(model::model_of(*added.calibration.subject).spindle->sensors.front().position,
              78 * mm, 2 * mm);
}

}  // namespace
}  // namespace raceway::spindle
