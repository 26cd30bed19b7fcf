#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <string>
#include <utility>

#include "loop/loop.h"
#include "model/parameters.h"
#include "record/expression.h"
#include "record/spindle_channel.h"
#include "spindle/spindle.h"
#include "spindle/spindle_subject.h"
#include "spindle/thermal_system.h"
#include "tests/spindle/base_spindle.h"
#include "tests/spindle/recorded_hours.h"

// Heat at a place of a spindle.
namespace raceway::spindle {
namespace {

using model::HeatSource;
using Place = HeatSource::Place;

/// A spindle with one more source of 100 W.
model::Model heated(HeatSource source) {
  model::Model m = base_spindle();
  if (source.name.empty()) source.name = "own";
  if (std::isnan(source.watts) && !source.formula) source.watts = 100.0;
  m.spindle->heat.push_back(std::move(source));
  return m;
}

/// Heat [W] between two planes of a body.
double heat_in(const ThermalSystem& system, Body body, double from, double to) {
  double sum = 0.0;
  for (std::size_t k = 0; k < system.layout().mesh.size(); ++k) {
    const Cell& c = system.layout().mesh.cells[k];
    const double middle = 0.5 * (c.start + c.end);
    if (c.body == body && middle > from && middle < to)
      sum += system.paths().source[static_cast<Eigen::Index>(k)];
  }
  return sum;
}

ThermalSystem sources_at_6000(const model::Model& model, Inputs inputs = {}) {
  ThermalSystem system(model, {}, model.spindle->cells);
  inputs.speed = 6000 * rpm;
  system.set_inputs(inputs, 0.0);
  return system;
}

TEST(HeatSource, ArisesWhereItSays) {
  const auto on = [](Place place, double position = unset, double length = unset,
                     double radius = unset) {
    return sources_at_6000(heated(
        {.name = {}, .place = place, .position = position, .length = length, .radius = radius}));
  };
  EXPECT_NEAR(heat_in(on(Place::shaft, 190 * mm, 60 * mm), Body::shaft, 160 * mm, 220 * mm), 100.0,
              1e-9);
  EXPECT_NEAR(heat_in(on(Place::housing, 120 * mm, 40 * mm), Body::housing, 100 * mm, 140 * mm),
              100.0, 1e-9);
  EXPECT_NEAR(heat_in(on(Place::pulley), Body::shaft, 300 * mm, 375 * mm), 100.0, 1e-9);
  EXPECT_NEAR(heat_in(on(Place::seal), Body::shaft, 40 * mm, 50 * mm), 100.0, 1e-9);
  HeatSource motor{.name = {}, .place = Place::motor, .rotor_share = 0.3};
  const ThermalSystem of_motor = sources_at_6000(heated(motor));
  EXPECT_NEAR(heat_in(of_motor, Body::shaft, 100 * mm, 280 * mm), 30.0, 1e-9);
  EXPECT_NEAR(heat_in(of_motor, Body::housing, 100 * mm, 280 * mm), 70.0, 1e-9);
  HeatSource rear{.name = {}, .place = Place::bearing, .bearing = 2, .rotor_share = 0.6};
  const ThermalSystem of_rear = sources_at_6000(heated(rear));
  EXPECT_NEAR(heat_in(of_rear, Body::inner_ring, 280 * mm, 300 * mm), 60.0, 1e-9);
  EXPECT_NEAR(heat_in(of_rear, Body::outer_ring, 280 * mm, 300 * mm), 40.0, 1e-9);
  EXPECT_NEAR(of_rear.driven_heat(), 100.0, 1e-9);
  EXPECT_EQ(of_rear.source_heat(), std::vector<double>{100.0});
  // At a radius the cells there alone.
  const ThermalSystem node = on(Place::housing, 120 * mm, 40 * mm, 88 * mm);
  for (std::size_t k = 0; k < node.layout().mesh.size(); ++k)
    if (node.paths().source[static_cast<Eigen::Index>(k)] != 0.0) {
      EXPECT_GT(node.layout().mesh.cells[k].outer_radius, 88 * mm);
    }
}

TEST(HeatSource, FollowsAPowerThatChangesAtConstantSpeed) {
  const model::Model model = heated({.name = "own",
                                     .formula = std::make_shared<const record::Expression>(
                                         "0.05*motor_power_W", model::heat_variables),
                                     .place = Place::seal});
  std::vector<ProfileRow> rows;
  for (int k = 1; k <= 40; ++k)
    rows.push_back(
        {.time = 60.0 * k, .inputs = {.speed = 6000 * rpm, .motor_power = k <= 20 ? 0.0 : 3000.0}});
  Simulator simulator(model);
  const auto whole = simulator.simulate(rows);
  const auto before = simulator.simulate(std::span(rows).first(20));
  const auto after = simulator.simulate(std::span(rows).subspan(20), &before.end);
  ASSERT_TRUE(whole.report.converged() && after.report.converged());
  EXPECT_NEAR(whole.moments.back().displacement, after.moments.back().displacement, 1e-11);
}

TEST(HeatSource, GoesByFormulaOfSpeedLoadAndPower) {
  const auto formula = [](const char* text) {
    return heated(
        {.name = "own",
         .formula = std::make_shared<const record::Expression>(text, model::heat_variables),
         .factor = 2.0,
         .place = Place::seal});
  };
  EXPECT_NEAR(sources_at_6000(formula("speed_rpm/100")).driven_heat(), 120.0, 1e-9);
  EXPECT_NEAR(
      sources_at_6000(formula("0.1*radial_load_N + moment_Nm"), {.radial_load = 200.0, .moment = 5})
          .driven_heat(),
      50.0, 1e-9);
  const model::Model by_power = formula("0.05*motor_power_W");
  EXPECT_NEAR(sources_at_6000(by_power, {.motor_power = 3000.0}).driven_heat(), 300.0, 1e-9);
  // A power that is not given is no power of 0.
  try {
    static_cast<void>(sources_at_6000(by_power));
    ADD_FAILURE() << "no error";
  } catch (const std::invalid_argument& e) {
    EXPECT_THAT(e.what(), testing::HasSubstr("needs motor_power_W, which is not given"));
  }
}

TEST(HeatSource, SeveralAddAndTheirHeatLeaves) {
  model::Model m = heated({.name = "a", .place = Place::pulley});
  m.spindle->heat.push_back({.name = "b", .watts = 40.0, .place = Place::bearing, .bearing = 0});
  m.spindle->drive = HeatSource{.name = "drive", .watts = 10.0, .place = Place::pulley};
  Report report;
  const Moment moment = Simulator(m).steady({.speed = 6000 * rpm}, report);
  ASSERT_TRUE(report.converged()) << report.message;
  EXPECT_NEAR(moment.heat.drive, 150.0, 1e-9);
  EXPECT_EQ(moment.sources, (std::vector<double>{100.0, 40.0}));
  EXPECT_NEAR(moment.heat.friction + 150.0,
              moment.heat.coolant + moment.heat.air + moment.heat.machine, 0.05);
  const Moment without = Simulator(base_spindle()).steady({.speed = 6000 * rpm}, report);
  EXPECT_GT(moment.bearings[2].inner_ring_temperature,
            without.bearings[2].inner_ring_temperature + 3.0);
}

TEST(HeatSource, AtTheRearEffectHeatsRollersBehindTheSetElseTheSet) {
  const effects::SpindleCondition hot{.rear_bearing_heat = 100.0};
  const model::Model balls = base_spindle();
  ThermalSystem system(balls, hot, balls.spindle->cells);
  system.set_inputs({.speed = 10000 * rpm}, 0.0);
  EXPECT_NEAR(heat_in(system, Body::inner_ring, 280 * mm, 300 * mm), 50.0, 1e-9);
  EXPECT_NEAR(heat_in(system, Body::outer_ring, 280 * mm, 300 * mm), 50.0, 1e-9);
}

/// The same with four thermometers.
model::Model with_thermometers(model::Model m) {
  using Part = model::ThermometerPlace::Part;
  const auto add = [&](const char* name, Part part, double position, double radius) {
    m.spindle->sensors.push_back(
        {.name = name, .part = part, .position = position * mm, .radius = radius * mm});
  };
  add("front", Part::ring, 60, 53);
  add("rear", Part::ring, 290, 53);
  add("wall", Part::housing, 190, 57);
  add("end", Part::shaft, 365, 29);
  m.spindle->cells = model::Cells::coarse;
  return m;
}

TEST(HeatSource, IsFoundByAFitWhetherNumberOrFactor) {
  model::Model truth = with_thermometers(base_spindle());
  truth.spindle->motor =
      HeatSource{.name = "motor", .watts = 150.0, .place = Place::motor, .rotor_share = 0.5};
  truth.spindle->heat.push_back({.name = "belt",
                                 .formula = std::make_shared<const record::Expression>(
                                     "0.01*speed_rpm", model::heat_variables),
                                 .factor = 1.6,
                                 .place = Place::bearing,
                                 .bearing = 2,
                                 .rotor_share = 0.5});
  const record::Record record = recorded(truth);
  model::Model start = truth;
  start.spindle->motor->watts = 20.0;
  start.spindle->heat[0].factor = 0.5;
  start.free = {"motor.heat_W", "belt.heat_factor"};
  const verdict::Calibration found = loop::calibrate(SpindleSubject(start), record);
  const auto value = [&](const std::string& name) {
    for (const record::Parameter& p : found.parameters)
      if (p.name == name) return p.value;
    return unset;
  };
  EXPECT_NEAR(value("motor.heat_W"), 150.0, 1.5);
  EXPECT_NEAR(value("belt.heat_factor"), 1.6, 0.016);
}

TEST(HeatSource, AtTheRearBearingIsDiagnosedByName) {
  const model::Model m = with_thermometers(base_spindle());
  model::Model truth = m;
  truth.spindle->heat.push_back({.name = "hidden",
                                 .formula = std::make_shared<const record::Expression>(
                                     "0.015*speed_rpm", model::heat_variables),
                                 .place = Place::bearing,
                                 .bearing = 2,
                                 .rotor_share = 0.5});
  const record::Record record = recorded(truth);
  const verdict::Diagnosis d = loop::diagnose(SpindleSubject(m), record, {});
  ASSERT_EQ(d.verdict, verdict::Verdict::effect) << d.sentence;
  EXPECT_EQ(d.effects.front().id, "rear-bearing-heat");
  EXPECT_NEAR(d.effects.front().parameters.front().value, 150.0, 8.0);
}

}  // namespace
}  // namespace raceway::spindle
