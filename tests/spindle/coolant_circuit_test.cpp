#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <stdexcept>
#include <string>
#include <vector>

#include "loop/loop.h"
#include "model/own_data.h"
#include "model/parameters.h"
#include "record/spindle_channel.h"
#include "spindle/spindle.h"
#include "spindle/spindle_subject.h"
#include "tests/spindle/base_spindle.h"
#include "tests/spindle/recorded_hours.h"

// Inlet temperature and flow of coolant circuits as numbers of a fit and of a diagnosis.
namespace raceway::spindle {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

/// A spindle whose rear jacket has its own inlet of 25 °C, with thermometers near both circuits.
model::Model two_measured_circuits() {
  model::Model m = two_circuits();
  m.spindle->circuits[0].channel.inlet_temperature = kelvin(25);
  m.spindle->cells = model::Cells::coarse;
  using Part = model::ThermometerPlace::Part;
  const auto add = [&](const char* name, Part part, double position, double radius) {
    m.spindle->sensors.push_back(
        {.name = name, .part = part, .position = position * mm, .radius = radius * mm});
  };
  add("front", Part::housing, 60, 57);
  add("middle", Part::housing, 150, 80);
  add("rear", Part::housing, 290, 57);
  add("return", Part::coolant, 299.9, unset);
  add("end", Part::shaft, 365, 29);
  return m;
}

model::Coolant& jacket(model::Model& m) { return m.spindle->circuits[0].channel; }

record::Parameter find(const model::Model& m, const std::string& name) {
  for (const record::Parameter& p : model::parameters(m))
    if (p.name == name) return p;
  throw std::out_of_range(name);
}

double fitted(const verdict::Calibration& calibration, const std::string& name) {
  for (const record::Parameter& p : calibration.parameters)
    if (p.name == name) return p.value;
  throw std::out_of_range(name);
}

TEST(CoolantCircuit, HasItsNumbersAtTheAddressesOfItsTable) {
  const model::Model m = two_measured_circuits();
  EXPECT_THAT(find(m, "inlet_temperature_C").addresses, ElementsAre("coolant.inlet_temperature_C"));
  EXPECT_THAT(find(m, "flow_l_min").addresses, ElementsAre("coolant.flow_l_min"));
  EXPECT_THAT(find(m, "rear_jacket.inlet_temperature_C").addresses,
              ElementsAre("coolant.circuit.0.inlet_temperature_C"));
  EXPECT_THAT(find(m, "rear_jacket.flow_l_min").addresses,
              ElementsAre("coolant.circuit.0.flow_l_min"));
  EXPECT_NEAR(find(m, "rear_jacket.inlet_temperature_C").value, 25.0, 1e-12);
  EXPECT_NEAR(find(m, "rear_jacket.flow_l_min").value, 2.0, 1e-12);
}

TEST(CoolantCircuit, IsChangedAlone) {
  model::Model m = two_measured_circuits();
  model::set(m, find(m, "rear_jacket.inlet_temperature_C"), 31.0);
  model::set(m, find(m, "rear_jacket.flow_l_min"), 7.5);
  EXPECT_NEAR(jacket(m).inlet_temperature, kelvin(31), 1e-9);
  EXPECT_NEAR(jacket(m).flow, 7.5 / 60000.0, 1e-12);
  EXPECT_EQ(m.spindle->coolant->inlet_temperature, kelvin(20));
  EXPECT_EQ(m.spindle->coolant->flow, 2.0 / 60000.0);
}

TEST(CoolantCircuit, WithoutItsOwnInletHasNone) {
  model::Model m = two_circuits();
  EXPECT_THROW((void)find(m, "rear_jacket.inlet_temperature_C"), std::out_of_range);
  EXPECT_THAT(model::own_data(m), testing::Not(testing::Contains(HasSubstr("coolant-inlet:"))));
  record::Parameter inlet{.name = "one", .unit = "C"};
  inlet.addresses = {"coolant.circuit.0.inlet_temperature_C"};
  EXPECT_THROW(model::set(m, inlet, 30.0), std::invalid_argument);
  // Water freezes in a circuit that has the inlet of a first one with oil.
  m.spindle->coolant->fluid = model::Fluid::oil;
  EXPECT_NEAR(find(m, "inlet_temperature_C").lower, 0.0, 1e-12);
  jacket(m).fluid = model::Fluid::oil;
  EXPECT_NEAR(find(m, "inlet_temperature_C").lower, -50.0, 1e-12);
}

// Without heat, everything has one temperature: the room, the first coolant, and so the jacket.
TEST(CoolantCircuit, OfASpindleInEquilibriumHasTheTemperatureOfTheRoom) {
  constexpr double room = 23.7;
  model::Model m = two_measured_circuits();
  m.free = {"rear_jacket.inlet_temperature_C"};
  record::Record record;
  record.settings_hold = record::SettingsHold::until_row;
  std::vector<double> time;
  for (int k = 1; k <= 40; ++k) time.push_back(300.0 * k);
  const auto all = [&](double value) { return std::vector<double>(time.size(), value); };
  record.set(record::time, time);
  record.set(record::speed, all(0.0));
  for (const char* name : {"ambient_temperature_C", "coolant_inlet_temperature_C"})
    record.set(*record::spindle_channel(name), all(kelvin(room)));
  for (const model::ThermometerPlace& sensor : m.spindle->sensors)
    record.set(record::sensor_channel(sensor.name), all(kelvin(room)));
  const verdict::Calibration found = loop::calibrate(SpindleSubject(m), record);
  EXPECT_NEAR(fitted(found, "rear_jacket.inlet_temperature_C"), room, 0.01);
}

TEST(CoolantCircuit, InletAndFlowAreFoundByAFit) {
  model::Model truth = two_measured_circuits();
  jacket(truth).inlet_temperature = kelvin(29);
  jacket(truth).flow = 0.7 / 60000.0;
  const record::Record record = recorded(truth);
  model::Model start = two_measured_circuits();
  start.free = {"rear_jacket.inlet_temperature_C", "rear_jacket.flow_l_min"};
  const verdict::Calibration found = loop::calibrate(SpindleSubject(start), record);
  EXPECT_NEAR(fitted(found, "rear_jacket.inlet_temperature_C"), 29.0, 0.05);
  EXPECT_NEAR(fitted(found, "rear_jacket.flow_l_min"), 0.7, 0.02);
}

TEST(CoolantCircuit, WithAWrongInletIsDiagnosedByNameAndPutRight) {
  model::Model truth = two_measured_circuits();
  jacket(truth).inlet_temperature = kelvin(29);
  const record::Record record = recorded(truth);
  const SpindleSubject subject(two_measured_circuits());
  const verdict::Diagnosis d = loop::diagnose(subject, record, {});
  ASSERT_EQ(d.verdict, verdict::Verdict::effect) << d.sentence;
  EXPECT_EQ(d.effects.front().id, "coolant-inlet:rear_jacket");
  EXPECT_NEAR(d.effects.front().parameters.front().value, 29.0, 0.3);
  EXPECT_THAT(d.headline,
              testing::StartsWith("Wrong data rather than missing physics: check the inlet "
                                  "temperature of circuit rear_jacket, inlet 29"));
  EXPECT_THAT(d.headline, HasSubstr(" C instead of the entered 25"));
  const verdict::AddResult added =
      loop::add(subject, std::vector<std::string>{"coolant-inlet:rear_jacket"}, record);
  ASSERT_FALSE(added.refused) << added.reason;
  const model::Spindle& better = *model::model_of(*added.calibration.subject).spindle;
  EXPECT_NEAR(better.circuits[0].channel.inlet_temperature, kelvin(29), 0.3);
  EXPECT_EQ(better.coolant->inlet_temperature, kelvin(20));
}

TEST(CoolantCircuit, IsNoCandidateWhereItsInletIsFree) {
  const auto ids = [](const model::Model& m) {
    std::vector<std::string> list;
    for (const fit::Candidate& c : SpindleSubject(m).candidates()) list.push_back(c.id);
    return list;
  };
  model::Model m = two_measured_circuits();
  EXPECT_THAT(ids(m), testing::IsSupersetOf({"coolant-inlet", "coolant-inlet:rear_jacket"}));
  m.free = {"f0", "rear_jacket.inlet_temperature_C"};
  EXPECT_THAT(ids(m), testing::Contains("coolant-inlet"));
  EXPECT_THAT(ids(m), testing::Not(testing::Contains("coolant-inlet:rear_jacket")));
}

}  // namespace
}  // namespace raceway::spindle
