#include "rig/rig_subject.h"

#include <gmock/gmock.h>

#include <cmath>
#include <stdexcept>
#include <utility>
#include <vector>

#include "friction/roller_friction.h"
#include "loop/loop.h"
#include "model/bearing_life.h"
#include "model/heat_split.h"
#include "model/prediction.h"
#include "tests/roller/reference_cases.h"

namespace raceway::roller {
namespace {

using nlohmann::json;
using testing::HasSubstr;

/// An N1012 on a rig, with the oil of the reference.
model::Model roller_rig(friction::F1Load counted = friction::F1Load::rollers) {
  return {.name = "N1012",
          .bearing = steel_bearing(n1012()),
          .lubricant = {20 * mm2_per_s, 4.4 * mm2_per_s},
          .law = friction::FrictionLaw::roller_palmgren,
          .f1_load = counted,
          .law_values = {1.5, 0.0003},
          .effects = {},
          .solver = {},
          .rig = {.axial_load = 0.0},
          .free = {}};
}

TEST(RollerRig, APointHasBalanceFrictionHeatAndLife) {
  const model::Model m = roller_rig();
  const bearing::OperatingPoint point{
      .speed = 4000 * rpm, .radial_load = 2000.0, .temperature = kelvin(50)};
  const model::FrictionPrediction p = predict_friction(m, point);
  ASSERT_EQ(p.status(), bearing::SolveStatus::converged);
  EXPECT_NEAR(p.rollers->load[0], 2000.0, 1e-6);
  const friction::HeatSplit heat = heat_split(m, point, p);
  EXPECT_NEAR(heat.inner + heat.outer, p.power_loss, 1e-9);
  EXPECT_GT(heat.outer, heat.inner);
  const model::BearingLife life = bearing_life(m, point, p);
  EXPECT_GT(life.reference, life.basic);
  EXPECT_NEAR(life.load_rating, 41.4e3, 50.0);
}

TEST(RollerRig, NoNumberOfBallsIsGivenForRollers) {
  const model::Model m = roller_rig();
  EXPECT_THROW((void)m.bearing.geometry(), std::invalid_argument);
  EXPECT_THROW((void)static_cast<const bearing::Bearing&>(m.bearing), std::invalid_argument);
  EXPECT_EQ(m.bearing.pitch_diameter(), 77.5 * mm);
}

// The law as printed needs no balance; what the rollers carry is asked for with the preload.
TEST(RollerRig, APreloadHasTorqueByItsRollersAlone) {
  bearing::RollerGeometry g = n1012();
  g.radial_clearance = -6 * um;
  const bearing::OperatingPoint still{.speed = 1000 * rpm};
  for (const auto counted : {friction::F1Load::F_r, friction::F1Load::rollers}) {
    model::Model m = roller_rig(counted);
    m.bearing = steel_bearing(g);
    const model::FrictionPrediction p = predict_friction(m, still);
    ASSERT_TRUE(p.predicted());
    EXPECT_EQ(p.load > 0.0, counted == friction::F1Load::rollers);
  }
}

record::Record record_of(const ReferenceCase& c) {
  record::Record record;
  record.source = "rig.csv";
  const auto column = [&](const record::Channel& channel, const char* key) {
    std::vector<double> values;
    for (const json& row : c.inputs().at("rows"))
      values.push_back(channel.to_SI(row.at(key).get<double>()));
    record.set(channel, std::move(values));
  };
  column(record::speed, "speed_rpm");
  column(record::radial_load, "radial_load_N");
  column(record::temperature, "temperature_C");
  column(record::friction_torque, "friction_torque_Nmm");
  record.set(record::axial_load, std::vector<double>(record.rows(), 0.0));
  return record;
}

TEST(RollerReference, ARigUnderRadialLoadGivesItsFactorsBack) {
  const ReferenceCase c = reference_case("friction", "calibrate_rig");
  const auto found =
      loop::calibrate(rig::RigSubject(roller_rig(friction::F1Load::F_r)), record_of(c));
  ASSERT_TRUE(found.converged());
  ASSERT_EQ(found.parameters.size(), 2u);
  c.holds(c.outputs(), "f0", found.parameters[0].value);
  c.holds(c.outputs(), "f1", found.parameters[1].value);
}

/// Readings of a rig whose truth is written out here: Palmgren's two moments with f0 = 1.8 and f1 =
/// 0.00035, a torque in N mm on top that the model does not know, and scatter of 0.5 %.
template <typename Hidden>
record::Record rig_with(const Hidden& hidden) {
  std::vector<double> speeds, loads, temperatures, torques;
  for (const double n : {600.0, 1200.0, 2500.0, 4500.0, 7000.0, 9000.0})
    for (const double F : {500.0, 1500.0, 3000.0, 5000.0})
      for (const auto& [celsius_of_row, nu] : {std::pair{40.0, 20.0}, {100.0, 4.4}}) {
        const double viscous = 1.8e-7 * std::pow(nu * n, 2.0 / 3.0) * 77.5 * 77.5 * 77.5;
        const double scatter = 1.0 + 0.007 * std::sin(1.0 + 7.3 * static_cast<double>(n + F + nu));
        speeds.push_back(n * rpm);
        loads.push_back(F);
        temperatures.push_back(kelvin(celsius_of_row));
        torques.push_back((viscous + 0.00035 * F * 77.5 + hidden(n)) * scatter * N_mm);
      }
  record::Record record;
  record.source = "rig.csv";
  record.set(record::axial_load, std::vector<double>(speeds.size(), 0.0));
  record.set(record::speed, std::move(speeds));
  record.set(record::radial_load, std::move(loads));
  record.set(record::temperature, std::move(temperatures));
  record.set(record::friction_torque, std::move(torques));
  return record;
}

TEST(RollerRig, NothingIsMissingOnARigOfTheLaw) {
  const verdict::Diagnosis d = loop::diagnose(rig::RigSubject(roller_rig(friction::F1Load::F_r)),
                                              rig_with([](double) { return 0.0; }));
  EXPECT_EQ(d.verdict, verdict::Verdict::nothing_missing) << d.sentence;
}

// Drag of the lubricant and of the air go with the same power of the speed.
TEST(RollerRig, AHiddenDragUnderRadialLoadIsNamed) {
  const verdict::Diagnosis d =
      loop::diagnose(rig::RigSubject(roller_rig(friction::F1Load::F_r)),
                     rig_with([](double n) { return 150.0 * (n / 1e4) * (n / 1e4); }));
  EXPECT_NE(d.verdict, verdict::Verdict::nothing_missing) << d.sentence;
  EXPECT_THAT(d.sentence, testing::AnyOf(HasSubstr("ubricant drag"), HasSubstr("lubricant-drag"),
                                         HasSubstr("windage")));
}

TEST(RollerRig, RefusesAnAxialLoadInARecord) {
  record::Record record = record_of(reference_case("friction", "calibrate_rig"));
  record.set(record::axial_load, std::vector<double>(record.rows(), 100.0));
  try {
    rig::RigSubject(roller_rig()).require(record);
    FAIL();
  } catch (const std::invalid_argument& error) {
    EXPECT_THAT(error.what(), HasSubstr("axial_load_N = 100: must be 0"));
  }
}

TEST(RollerRig, EffectsOfBallsAreNotTestedAndSayWhy) {
  const rig::RigSubject subject(roller_rig());
  const record::Record record = record_of(reference_case("friction", "calibrate_rig"));
  for (const char* id : {"spin-friction", "gyroscopic-slip", "differential-slip", "thermal-preload",
                         "load-offset", "centrifugal-ring-growth"})
    EXPECT_THAT(subject.rules_out(id), HasSubstr("a ball bearing, because ")) << id;
  for (const char* id : {"spin-friction", "load-offset"})
    EXPECT_EQ(subject.lacks(id, record), "") << id;
  EXPECT_EQ(subject.lacks("lubricant-drag", record), "");
}

}  // namespace
}  // namespace raceway::roller
