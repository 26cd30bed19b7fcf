#include "correction/step_response.h"

#include <gmock/gmock.h>

#include <cmath>

#include "correction/own_effect.h"
#include "correction/series.h"
#include "correction/simulation.h"
#include "tests/correction/made_record.h"

namespace raceway::correction {
namespace {

using testing::ElementsAre;

constexpr double at = 3000.0;  // of the step [s]

const Channel* drive_column(const std::string& name) { return record::series_channel(name); }

/// A channel of a temperature with two sections and a feedthrough.
Model two_sections() {
  Model model;
  model.displacement = drive_column("displacement_z_um");
  model.channels = {
      {.name = "spindle",
       .input = {.name = "nose_temperature_C", .columns = {drive_column("nose_temperature_C")}},
       .sections = {{.gain = 5 * um, .time_constant = 5400},
                    {.gain = -2 * um, .time_constant = 700}},
       .feedthrough = 0.7 * um,
       .scale = 1.5}};
  return model;
}

/// One kelvin more from one row to the next, and then for ever.
MadeRecord step_of_temperature() {
  MadeRecord made(30000, 1);
  made.with("nose_temperature_C", [](double t) { return t > at ? 26.0 : 25.0; })
      .with("speed_rpm", [](double) { return 0.0; });
  return made;
}

double value(const StepResponse& r, double t) {
  double sum = r.at_once;
  for (const StepResponse::Part& p : r.parts)
    sum += p.gain * (1.0 - (1.0 - r.sensor_time_constant / p.time_constant) *
                               std::exp(-t / p.time_constant));
  return sum;
}

/// What is drawn is what a simulation does, half a step of the ramp between two rows later.
void expect_as_simulated(const Model& model) {
  const MadeRecord made = step_of_temperature();
  const std::vector<StepResponse> responses = step_responses(model, made.record);
  ASSERT_EQ(responses.size(), 1U);
  std::vector<double> simulated(made.time.size());
  simulate(model, Series(made.record), simulated);
  for (std::size_t k = 3500; k < made.time.size(); k += 900)
    EXPECT_NEAR(simulated[k], value(responses.front(), made.time[k] - at - 0.5), 1e-4 * um) << k;
}

TEST(StepResponse, IsWhatASimulationOfTheModelDoes) { expect_as_simulated(two_sections()); }

TEST(StepResponse, HasTheSectionThatAnEffectAddsAndTheLagOfASensor) {
  Model model = two_sections();
  model.effects = {{.id = "sensor-lag", .values = {300}}};
  expect_as_simulated(model);
  // The section of an effect is driven by the input as it was read.
  model.effects = {{.id = "second-time-constant", .values = {1.25, 9000}}};
  const StepResponse r = step_responses(model, step_of_temperature().record).front();
  ASSERT_EQ(r.parts.size(), 3U);
  EXPECT_EQ(r.parts[2].name, "second-time-constant");
  EXPECT_NEAR(r.parts[2].gain, 1.25 * um, 1e-15);
}

TEST(StepResponse, OfASpeedIsThatOfAThousandRevolutions) {
  Model model = two_sections();
  model.channels[0].input = {.name = "speed_rpm", .columns = {drive_column("speed_rpm")}};
  model.channels[0].sections = {{.gain = 3e-3 * um / rpm, .time_constant = 900}};
  const StepResponse r = step_responses(model, step_of_temperature().record).front();
  EXPECT_EQ(r.step, 1000.0);
  EXPECT_EQ(r.unit, "rpm");
  EXPECT_NEAR(r.parts.front().gain, 1.5 * 3 * um, 1e-12);
}

TEST(StepResponse, OfASpeedToAPowerIsThatOfAThousandRevolutionsAsWell) {
  Model model = two_sections();
  model.channels[0].input = {
      .name = "speed_rpm", .columns = {drive_column("speed_rpm")}, .exponent = 1.5};
  model.channels[0].sections = {{.gain = 3e-3 * um / rpm, .time_constant = 900}};
  model.channels[0].feedthrough = 0.0;
  MadeRecord made = step_of_temperature();
  made.with("speed_rpm", [](double t) { return t >= at ? 1000.0 : 0.0; });
  const StepResponse r = step_responses(model, made.record).front();
  EXPECT_EQ(r.input, "speed to the power 1.5");
  std::vector<double> simulated(made.time.size());
  simulate(model, Series(made.record), simulated);
  EXPECT_NEAR(simulated[5000], value(r, 5000 - at), 1e-9 * um);
}

TEST(StepResponse, NamesEffectsWithWhichTheChannelAnswersOtherwise) {
  Model model = two_sections();
  model.effects = {{.id = "thermal-asymmetry", .values = {1.4}},
                   {.id = "ambient-drift",
                    .columns = {drive_column("room_temperature_C")},
                    .values = {-2.5, 14000}},
                   {.id = "offset-jump", .values = {4, 100}}};
  const std::vector<StepResponse> list = step_responses(model, step_of_temperature().record);
  ASSERT_EQ(list.size(), 2U);
  EXPECT_THAT(list[0].changed_by, ElementsAre("thermal-asymmetry"));
  EXPECT_EQ(list[1].name, "ambient-drift");
  EXPECT_EQ(list[1].input, "room temperature");
  EXPECT_NEAR(list[1].parts.front().gain, -2.5 * um, 1e-15);
}

TEST(StepResponse, OfAFormulaWithALagIsDrawnAndAtOnceItIsNot) {
  Model model = two_sections();
  for (const bool lags : {true, false}) {
    Effect e{.id = lags ? "late" : "at-once", .values = {3.0}};
    if (lags) e.values.push_back(900.0);
    e.own = std::make_shared<const OwnEffect>(
        OwnEffect::Given{.id = e.id, .formula = "nose_temperature_C", .lags = lags});
    model.effects.push_back(std::move(e));
  }
  const std::vector<StepResponse> list = step_responses(model, step_of_temperature().record);
  ASSERT_EQ(list.size(), 2U);
  EXPECT_EQ(list[1].name, "late");
  EXPECT_EQ(list[1].input, "nose_temperature_C");
  ASSERT_EQ(list[1].parts.size(), 1U);
  EXPECT_NEAR(list[1].parts[0].gain, 3.0 * um, 1e-15);
  EXPECT_EQ(list[1].parts[0].time_constant, 900.0);
}

TEST(StepResponse, OfADelayElementIsShownAtTheMedianAndTheLargestPowerThatItTakes) {
  Model model = two_sections();
  auto table = std::make_shared<FrictionTable>(FrictionTable{.file = "t.csv",
                                                             .speed = {0, 1000},
                                                             .axial_load = {500},
                                                             .temperature = {300},
                                                             .torque = {1, 1}});
  model.channels[0].input = {.name = "power_W",
                             .table = table,
                             .axial_load = {500},
                             .radial_load = {0},
                             .temperature = {300}};
  model.channels[0].sections.clear();
  // T = 6000 s - 50 s/W P: no more than 120 W.
  const DelayElement element{.gain = Characteristic::Line{0.5 * um, 10 * um},
                             .time_constant = Characteristic::Line{-50, 6000}};
  model.channels[0].element = element;
  MadeRecord made = step_of_temperature();
  made.with("speed_rpm", [](double t) {
    return (t < 9000 ? 0.0 : t < 24000 ? 40.0 : t < 29000 ? 100.0 : 500.0) / rpm;
  });
  const std::vector<StepResponse> list = step_responses(model, made.record);
  ASSERT_EQ(list.size(), 2U);
  EXPECT_NEAR(list[0].step, 40.0, 1e-9);
  EXPECT_NEAR(list[0].parts.front().gain, 1.5 * 30 * um, 1e-12);
  EXPECT_NEAR(list[0].parts.front().time_constant, 4000, 1e-6);
  EXPECT_NEAR(list[1].step, 100.0, 1e-9);
  EXPECT_NEAR(list[1].parts.front().time_constant, 1000, 1e-6);

  model.effects = {{.id = "second-time-constant", .values = {1.25, 9000}}};
  const StepResponse more = step_responses(model, made.record).front();
  ASSERT_EQ(more.parts.size(), 2U);
  EXPECT_NEAR(more.parts[1].gain, 1.25 * 40 * um, 1e-12);
  EXPECT_EQ(more.parts[1].time_constant, 9000);
}

TEST(StepResponse, OfPrintedCoefficientsIsTheirOwn) {
  Model model = two_sections();
  const double decay = std::exp(-10.0 / 600.0);
  model.sampling = 10;
  model.channels[0].sections.clear();
  model.channels[0].feedthrough = 0.0;
  model.channels[0].printed = TransferFunction{
      .numerator = {0.0, 4 * um * (1 - decay)}, .denominator = {1, -decay}, .sampling = 10};
  const StepResponse r = step_responses(model, step_of_temperature().record).front();
  ASSERT_GT(r.sampled.size(), 100U);
  for (std::size_t k = 0; k < r.sampled.size(); k += 50)
    EXPECT_NEAR(r.sampled[k],
                1.5 * 4 * um * (1 - std::exp(-static_cast<double>(k) * r.sampling / 600.0)),
                1e-6 * um)
        << k;
}

}  // namespace
}  // namespace raceway::correction
