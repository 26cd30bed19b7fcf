#include <gtest/gtest.h>

#include <cmath>
#include <numeric>

#include "spindle/loaded_shaft.h"
#include "spindle/spindle.h"
#include "tests/spindle/base_spindle.h"

namespace raceway::spindle {
namespace {

/// An N1012 with assumed rollers at the rear of the spindle of the cases, under a belt.
model::Model belt_spindle(double belt = 1500.0, double clearance = 15 * um) {
  model::Model m = base_spindle();
  model::Spindle& s = *m.spindle;
  s.housing.segments = {{.length = 265 * mm, .diameter = 180 * mm, .bore = unset},
                        {.length = 40 * mm, .diameter = 180 * mm, .bore = 95 * mm}};
  for (model::Segment& piece : s.housing.segments) piece.material = model::iron_of_housings;
  s.coolant.reset();
  bearing::RollerGeometry g{.roller_count = 20,
                            .roller_diameter = 8 * mm,
                            .roller_length = 8 * mm,
                            .pitch_diameter = 77.5 * mm,
                            .radial_clearance = clearance,
                            .bore = 60 * mm,
                            .outer_diameter = 95 * mm,
                            .width = 18 * mm};
  s.rollers.push_back({.name = "belt_end",
                       .position = 330 * mm,
                       .bearing = {g, bearing::steel(), bearing::steel()},
                       .f0 = 1.0,
                       .f1 = 0.0003});
  s.belt = model::Belt{.force = belt, .position = 360 * mm};
  return m;
}

Moment steady(const model::Model& m, const Inputs& inputs) {
  Simulator simulator(m);
  Report report;
  const Moment moment = simulator.steady(inputs, report);
  EXPECT_TRUE(report.converged()) << report.message;
  return moment;
}

const Inputs at_6000{.speed = 6000 * rpm};

TEST(RollerSpindle, ItsBearingHeatsItsRingsAndLosesItsClearance) {
  const Moment m = steady(belt_spindle(), at_6000);
  ASSERT_EQ(m.bearings.size(), 4U);
  const BearingState& rollers = m.bearings[3];
  EXPECT_EQ(rollers.force, 0.0);
  EXPECT_GT(rollers.power, 50.0);
  EXPECT_GT(rollers.inner_ring_temperature, rollers.outer_ring_temperature);
  EXPECT_LT(rollers.clearance, 12 * um);
  // Through that clearance the rear set takes much of the belt; without it hardly any.
  const Moment close = steady(belt_spindle(1500.0, 0.0), at_6000);
  EXPECT_GT(rollers.radial_force, 400.0);
  EXPECT_GT(close.bearings[3].radial_force, 2.0 * rollers.radial_force);
  EXPECT_LT(close.bearings[3].clearance, -1 * um);
  // Each watt is there once.
  EXPECT_NEAR(m.heat.friction,
              std::accumulate(m.bearings.begin(), m.bearings.end(), 0.0,
                              [](double sum, const BearingState& b) { return sum + b.power; }),
              1e-9);
  EXPECT_NEAR(m.heat.stored, 0.0, 1e-3);
}

TEST(RollerSpindle, TheSteadyStateIsWhereTimeLeadsTo) {
  const model::Model model = belt_spindle();
  const Moment m = steady(model, at_6000);
  Simulator simulator(model);
  const std::vector<ProfileRow> day{{.time = 0.0}, {.time = 24 * 3600.0, .inputs = at_6000}};
  const spindle::Run run = simulator.simulate(day);
  ASSERT_TRUE(run.report.converged());
  EXPECT_LT(run.report.energy_error, 1e-10);
  const Moment& end = run.moments.back();
  for (std::size_t k = 0; k < 4; ++k) {
    EXPECT_NEAR(end.bearings[k].inner_ring_temperature, m.bearings[k].inner_ring_temperature, 0.02);
    EXPECT_NEAR(end.bearings[k].radial_force, m.bearings[k].radial_force, 0.5);
    EXPECT_NEAR(end.bearings[k].power, m.bearings[k].power, 0.02);
  }
  EXPECT_NEAR(end.bearings[3].clearance, m.bearings[3].clearance, 0.01 * um);
}

TEST(RollerSpindle, TheBearingsCarryTheBeltAndTheForceAtTheNose) {
  const model::Model model = belt_spindle(1500.0);
  Simulator simulator(model);
  Report report;
  Inputs inputs = at_6000;
  inputs.radial_load = 400.0, inputs.moment = 20.0;
  (void)simulator.steady(inputs, report);
  ASSERT_TRUE(report.converged());
  const LoadedShaft& bent = *simulator.shaft();
  const double places[] = {60 * mm, 90 * mm, 290 * mm};
  double force = bent.rollers[0].load[0], about_nose = 330 * mm * force + bent.rollers[0].load[3];
  for (std::size_t i = 0; i < 3; ++i) {
    const double side = presses_rearwards(*simulator.arrangement(), i) ? 1.0 : -1.0;
    force += bent.loads[i][1];
    about_nose += places[i] * bent.loads[i][1] + side * bent.loads[i][4];
  }
  EXPECT_NEAR(force, 1900.0, 1e-4);
  // θ counts rearwards: the moment at the nose is that of a force in front of it.
  EXPECT_NEAR(about_nose, 360 * mm * 1500.0 - 20.0, 1e-5);
}

TEST(RollerSpindle, APreloadOfTheRollersDoesNotPushTheShaftAlong) {
  const Moment loose = steady(belt_spindle(0.0, 20 * um), at_6000);
  const Moment tight = steady(belt_spindle(0.0, 10 * um), at_6000);
  EXPECT_LT(tight.bearings[3].clearance, loose.bearings[3].clearance);
  for (const Moment* m : {&loose, &tight}) {
    EXPECT_NEAR(m->bearings[3].radial_force, 0.0, 1e-6);
    EXPECT_NEAR(m->front_force, m->rear_force, 1e-3);
  }
}

TEST(RollerSpindle, ABeltAtAnotherAngleIsCarriedAlike) {
  model::Model model = belt_spindle();
  const Moment along_y = steady(model, at_6000);
  // A pitch of the rollers, 18 deg, times five.
  model.spindle->belt->angle = 90 * degree;
  const Moment along_z = steady(model, at_6000);
  for (std::size_t k = 0; k < 4; ++k) {
    EXPECT_NEAR(along_z.bearings[k].radial_force, along_y.bearings[k].radial_force, 1e-4);
    EXPECT_NEAR(along_z.bearings[k].power, along_y.bearings[k].power, 1e-5);
  }
}

TEST(RollerSpindle, RollersThatHeatIntoTheirOwnPreloadRunAway) {
  model::Model model = belt_spindle(1500.0, -25 * um);
  model.spindle->rollers[0].f0 = 8.0;
  model.spindle->rollers[0].f1 = 0.006;
  Simulator simulator(model);
  Report report;
  (void)simulator.steady({.speed = 12000 * rpm}, report);
  EXPECT_EQ(report.status, Status::thermal_runaway);
}

TEST(LoadsAcross, ARadialForceAtTheNoseActsOnFrictionAndHeat) {
  const model::Model model = base_spindle();
  const Moment idle = steady(model, at_6000);
  Inputs inputs = at_6000;
  inputs.radial_load = 1000.0;
  const Moment loaded = steady(model, inputs);
  EXPECT_EQ(idle.bearings[0].radial_force, 0.0);
  EXPECT_GT(loaded.bearings[0].radial_force, 500.0);
  EXPECT_GT(loaded.bearings[0].power, 1.01 * idle.bearings[0].power);
  EXPECT_GT(loaded.bearings[0].inner_ring_temperature, idle.bearings[0].inner_ring_temperature);
  // The other way round it is the same.
  inputs.radial_load = -1000.0;
  EXPECT_NEAR(steady(model, inputs).heat.friction, loaded.heat.friction, 1e-6);
  // A moment that is that of the force 100 mm further in front.
  inputs.radial_load = 1000.0, inputs.moment = 100.0;
  EXPECT_GT(steady(model, inputs).bearings[1].radial_force, loaded.bearings[1].radial_force);
}

TEST(LoadsAcross, TheyGoWithTheRowsOfAProgramme) {
  Simulator simulator(base_spindle());
  Inputs loaded = at_6000;
  loaded.radial_load = 1000.0;
  const std::vector<ProfileRow> rows{{.time = 0.0},
                                     {.time = 600.0, .inputs = at_6000},
                                     {.time = 1200.0, .inputs = loaded},
                                     {.time = 1800.0, .inputs = at_6000}};
  const spindle::Run run = simulator.simulate(rows);
  ASSERT_TRUE(run.report.converged());
  EXPECT_LT(run.report.energy_error, 1e-10);
  EXPECT_EQ(run.moments[1].bearings[0].radial_force, 0.0);
  EXPECT_GT(run.moments[2].bearings[0].radial_force, 500.0);
  EXPECT_EQ(run.moments[3].bearings[0].radial_force, 0.0);
  EXPECT_GT(run.moments[2].heat.friction, run.moments[3].heat.friction);
}

TEST(LoadsAcross, TheBeltAtStandstillIsTheZeroOfTheDisplacement) {
  const model::Model model = belt_spindle();
  Simulator simulator(model);
  const std::vector<ProfileRow> rows{{.time = 0.0}, {.time = 60.0}};
  const spindle::Run run = simulator.simulate(rows);
  ASSERT_TRUE(run.report.converged());
  EXPECT_NEAR(run.moments.back().displacement, 0.0, 1e-3 * um);
}

}  // namespace
}  // namespace raceway::spindle
