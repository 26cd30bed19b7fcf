#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <atomic>
#include <chrono>
#include <cmath>
#include <thread>

#include "fit/problem.h"
#include "spindle/layout.h"
#include "spindle/spindle.h"
#include "spindle/tr_bdf2.h"
#include "tests/spindle/base_spindle.h"
#include "tests/spindle/reference_cases.h"

namespace raceway::spindle {
namespace {

std::vector<ProfileRow> day() {
  std::vector<ProfileRow> profile;
  for (int k = 1; k <= 480; ++k) {
    const double speed = k <= 120 ? 2000 : k <= 240 ? 8000 : k <= 300 ? 0 : k <= 400 ? 6000 : 10000;
    profile.push_back({.time = 60.0 * k,
                       .inputs = {.speed = speed * rpm,
                                  .ambient_temperature = kelvin(20.0 + 2.0 * std::sin(0.01 * k)),
                                  .coolant_on = k <= 330 || k > 380}});
  }
  return profile;
}

TEST(TrBdf2, AmplifiesAsItsReferenceSaysAndDampsWhatIsStiff) {
  for (const ReferenceCase& c : reference_cases("integrator")) {
    for (std::size_t k = 0; k < c.inputs["z"].size(); ++k) {
      const double r = TrBdf2::amplification(c.inputs["z"][k]), wanted = c.outputs["R"][k];
      EXPECT_NEAR(r, wanted, c.tolerance * std::max(std::abs(wanted), 1e-1)) << c.inputs["z"][k];
    }
  }
}

// A file with rounded positions moved the shoulder behind the last bearing into the air: the shaft
// end was 1 K colder.
TEST(Layout, IsTheSameForRoundedPositions) {
  const auto rear_area = [](double moved) {
    model::Model m = base_spindle();
    m.spindle->rear_positions = {290 * mm + moved};
    double sum = 0.0;
    for (const Joint& j : make_layout(m, model::Cells::medium).rear) sum += j.area;
    return sum;
  };
  const double exact = rear_area(0.0);
  for (const double moved : {-0.4e-6, 0.4e-6})
    EXPECT_NEAR(rear_area(moved), exact, 1e-4 * exact) << moved;
}

TEST(Simulator, StoresWhatCameInOverAWeek) {
  const std::vector<ProfileRow> one = day();
  std::vector<ProfileRow> week;
  for (int k = 0; k < 21; ++k)
    for (ProfileRow row : one) {
      row.time += 28800.0 * k;
      week.push_back(row);
    }
  const auto run = Simulator(base_spindle()).simulate(week);
  ASSERT_TRUE(run.report.converged()) << run.report.message;
  EXPECT_EQ(run.moments.size(), week.size());
  EXPECT_LT(run.report.energy_error, 1e-10);
}

// Ten kelvins everywhere: each piece of the shaft is longer by alpha dT.
TEST(Simulator, KnowsTheShaftFromItsNoseToItsRearEnd) {
  Simulator simulator(base_spindle());
  Report report;
  const Moment still = simulator.steady({.ambient_temperature = kelvin(30),
                                         .machine_temperature = kelvin(30),
                                         .coolant_inlet = kelvin(30)},
                                        report);
  ASSERT_TRUE(report.converged());
  const std::vector<ShaftPlace> shaft = simulator.along_shaft(still);
  ASSERT_GE(shaft.size(), 6u);
  EXPECT_EQ(shaft.front().position, 0.0);
  EXPECT_NEAR(shaft.back().position, 375 * mm, 1e-12);
  EXPECT_NEAR(shaft.front().displacement, still.displacement, 1e-15);
  for (const ShaftPlace& place : shaft)
    EXPECT_NEAR(shaft.front().displacement - place.displacement, 11.5e-6 * 10 * place.position,
                1e-3 * um);
}

TEST(Simulator, TellsPressureAndConductanceOfEachSeat) {
  Simulator simulator(base_spindle());
  Report report;
  static_cast<void>(simulator.steady({}, report));
  ASSERT_TRUE(report.converged());
  const std::vector<SeatsOfBearing> cold = simulator.seats();
  ASSERT_EQ(cold.size(), 3u);
  // 6 um of interference on a shaft of 36 and 70 mm within a ring of 82 mm, Lame:
  // p = delta/d E/(A + B), A = (D² + d²)/(D² - d²), B = (d² + b²)/(d² - b²), one steel.
  const double d2 = 70.0 * 70.0, ring = (82.0 * 82.0 + d2) / (82.0 * 82.0 - d2),
               shaft = (d2 + 36.0 * 36.0) / (d2 - 36.0 * 36.0);
  const double pressure = 6e-3 / 70.0 * 210e9 / (ring + shaft);
  EXPECT_NEAR(cold[0].inner.pressure, pressure, 0.02 * pressure);
  EXPECT_GT(cold[0].inner.conductance, 1000.0);
  EXPECT_EQ(cold[0].outer.pressure, 0.0);
  EXPECT_NEAR(cold[0].outer.gap, 2 * um, 1e-9 * um);
  // Air alone: lambda/(3 Ra + gap).
  EXPECT_NEAR(cold[0].outer.conductance, 0.027 / (3 * 0.8e-6 + 2e-6), 1.0);
  static_cast<void>(simulator.steady({.speed = 10000 * rpm}, report));
  ASSERT_TRUE(report.converged());
  EXPECT_LT(simulator.seats()[0].inner.pressure, cold[0].inner.pressure);  // rotation lifts
  EXPECT_GT(simulator.seats()[0].outer.pressure, 0.0);                     // heat closes
}

TEST(Simulator, ComesToTheSteadyState) {
  const std::vector<ProfileRow> profile{{.time = 86400.0, .inputs = {.speed = 6000 * rpm}}};
  Simulator simulator(base_spindle());
  const auto run = simulator.simulate(profile);
  Report report;
  const Moment steady = simulator.steady(profile[0].inputs, report);
  ASSERT_TRUE(run.report.converged() && report.converged());
  EXPECT_NEAR(run.moments[0].displacement, steady.displacement, 1e-4 * steady.displacement);
  EXPECT_NEAR(run.moments[0].front_force, steady.front_force, 1e-4 * steady.front_force);
}

TEST(Simulator, StopsWhereItIsToldAndGoesOnAsIfNothingHadBeen) {
  const std::vector<ProfileRow> profile{{.time = 3600.0, .inputs = {.speed = 6000 * rpm}}};
  std::atomic<bool> cancelled = true;
  Simulator simulator(base_spindle());
  simulator.stop_on(&cancelled);
  Simulator copy = simulator;
  Report report;
  EXPECT_THROW(static_cast<void>(simulator.simulate(profile)), fit::Cancelled);
  EXPECT_THROW(static_cast<void>(copy.simulate(profile)), fit::Cancelled);
  EXPECT_THROW(static_cast<void>(simulator.steady(profile[0].inputs, report)), fit::Cancelled);
  EXPECT_FALSE(report.converged());
  cancelled = false;
  const auto run = simulator.simulate(profile), other = Simulator(base_spindle()).simulate(profile);
  ASSERT_TRUE(run.report.converged());
  // The sets begin their balance where they were: the last digits differ.
  EXPECT_NEAR(run.moments[0].displacement, other.moments[0].displacement,
              1e-8 * other.moments[0].displacement);
}

TEST(Simulator, ASteadySearchThatIsStoppedLeavesTheStepsOfARunAsFineAsTheyWere) {
  using Clock = std::chrono::steady_clock;
  // Too fast for Newton's method alone: the search goes through time in coarse steps.
  const Inputs too_fast{.speed = 60000 * rpm};
  const std::vector<ProfileRow> profile{{.time = 3600.0, .inputs = {.speed = 6000 * rpm}}};
  const auto expected = Simulator(base_spindle()).simulate(profile).step_ends;
  Report report;
  const Clock::time_point start = Clock::now();
  static_cast<void>(Simulator(base_spindle()).steady(too_fast, report));
  const Clock::duration whole = Clock::now() - start;

  int stopped = 0;
  // Stopped before it begins, and at shares of a time that may be longer than that of the next
  // search.
  for (const int percent : {0, 1, 5, 10, 30, 50, 90}) {
    std::atomic<bool> cancelled = percent == 0;
    Simulator simulator(base_spindle());
    simulator.stop_on(&cancelled);
    std::thread stops([&] {
      std::this_thread::sleep_for(whole * percent / 100);
      cancelled = true;
    });
    try {
      static_cast<void>(simulator.steady(too_fast, report));
    } catch (const fit::Cancelled&) {
      ++stopped;
      EXPECT_FALSE(report.converged());
    }
    stops.join();
    cancelled = false;
    // [s]; a coarse step is minutes longer, another last digit of the sets moves none so far.
    EXPECT_THAT(simulator.simulate(profile).step_ends,
                testing::Pointwise(testing::DoubleNear(0.1), expected));
  }
  EXPECT_GT(stopped, 0);
}

TEST(Simulator, AnswersDoNotDependOnRowsThatChangeNothing) {
  std::vector<ProfileRow> many, few{{.time = 3600.0, .inputs = {.speed = 5000 * rpm}}};
  for (int k = 1; k <= 60; ++k) many.push_back({.time = 60.0 * k, .inputs = few[0].inputs});
  const double a = Simulator(base_spindle()).simulate(few).moments.back().displacement;
  const double b = Simulator(base_spindle()).simulate(many).moments.back().displacement;
  EXPECT_NEAR(a, b, 1e-13);
}

TEST(Simulator, GoesOnFromAStateAsIfItHadNeverStopped) {
  const std::vector<ProfileRow> profile = day();
  const std::size_t half = 240;  // where the speed jumps
  Simulator simulator(base_spindle());
  const auto whole = simulator.simulate(profile);
  const auto first = simulator.simulate(std::span(profile).first(half));
  const auto second = simulator.simulate(std::span(profile).subspan(half), &first.end);
  ASSERT_EQ(second.moments.size(), profile.size() - half);
  EXPECT_NEAR(second.moments.back().displacement, whole.moments.back().displacement, 1e-11);
}

TEST(Simulator, GoesOnFromTheSteadyStateWithTheWholeDriftOfTheMachine) {
  model::Model m = base_spindle();
  m.effects.push_back({effects::find("structure-temperature", m.form()), {3.0, 2.0}});
  const Inputs inputs{.speed = 6000 * rpm};
  Simulator simulator(m);
  Report report;
  const Moment steady = simulator.steady(inputs, report);
  const State state = simulator.state();
  const std::vector<ProfileRow> hour{{.time = 3600.0, .inputs = inputs}};
  const auto run = simulator.simulate(hour, &state);
  ASSERT_TRUE(report.converged() && run.report.converged());
  EXPECT_NEAR(run.moments[0].displacement, steady.displacement, 1e-4 * steady.displacement);
}

TEST(Simulator, KeptStepsGiveTheSameRun) {
  const std::vector<ProfileRow> profile = day();
  Simulator simulator(base_spindle());
  const auto first = simulator.simulate(profile);
  const auto again = simulator.simulate(profile, nullptr, first.step_ends);
  ASSERT_EQ(first.moments.size(), again.moments.size());
  for (std::size_t k = 0; k < first.moments.size(); ++k)
    EXPECT_NEAR(first.moments[k].displacement, again.moments[k].displacement, 1e-12);
}

TEST(Simulator, OneStepMoreOrLessIsWithinATenthOfAPercent) {
  const std::vector<ProfileRow> profile = day();
  model::Model short_steps = base_spindle();
  short_steps.spindle->step = 20.0;
  const auto fine = Simulator(short_steps).simulate(profile);
  const auto run = Simulator(base_spindle()).simulate(profile);
  for (std::size_t k = 0; k < profile.size(); ++k)
    EXPECT_NEAR(run.moments[k].displacement, fine.moments[k].displacement, 0.15 * um) << k;
}

// Trap 10: a change of input is a step boundary wherever it falls.
TEST(Simulator, ACoolantThatIsSwitchedOffForAMinuteIsSeen) {
  std::vector<ProfileRow> profile{
      {.time = 7200.0, .inputs = {.speed = 6000 * rpm}},
      {.time = 7260.0, .inputs = {.speed = 6000 * rpm, .coolant_on = false}},
      {.time = 7320.0, .inputs = {.speed = 6000 * rpm}}};
  const auto run = Simulator(base_spindle()).simulate(profile);
  ASSERT_EQ(run.moments.size(), 3u);
  EXPECT_GT(run.moments[1].bearings[0].outer_ring_temperature,
            run.moments[0].bearings[0].outer_ring_temperature + 0.1);
}

// Whatever the steps around it: 11 K were lost in one row by a model that did not end its steps
// there.
TEST(Simulator, ASwitchOfTheCoolantEndsAStepWhereverItFalls) {
  const auto ring_after = [](double longest) {
    model::Model m = base_spindle();
    m.spindle->step = longest;
    const std::vector<ProfileRow> profile{
        {.time = 7217.3, .inputs = {.speed = 6000 * rpm}},
        {.time = 7277.3, .inputs = {.speed = 6000 * rpm, .coolant_on = false}}};
    return Simulator(m).simulate(profile).moments.back().bearings[0].outer_ring_temperature;
  };
  EXPECT_NEAR(ring_after(unset), ring_after(5.0), 0.01);
}

TEST(Simulator, HeatOfADriveWarmsTheShaftEnd) {
  model::Model m = base_spindle();
  m.spindle->sensors = {{.name = "end",
                         .part = model::ThermometerPlace::Part::shaft,
                         .position = 365 * mm,
                         .radius = 29 * mm}};
  Report report;
  const Moment without = Simulator(m).steady({.speed = 6000 * rpm}, report);
  const Moment with = Simulator(m, {.drive_heat = 150.0}).steady({.speed = 6000 * rpm}, report);
  EXPECT_NEAR(with.heat.drive, 90.0, 1e-9);
  EXPECT_GT(with.sensors[0], without.sensors[0] + 5.0);
}

// Trap 6: Picard's iteration diverges here.
TEST(Simulator, AColdJumpTo12000RpmConverges) {
  const std::vector<ProfileRow> profile{{.time = 3600.0, .inputs = {.speed = 12000 * rpm}}};
  Simulator simulator(base_spindle());
  const auto run = simulator.simulate(profile);
  ASSERT_TRUE(run.report.converged()) << run.report.message;
  EXPECT_LT(run.report.steps, 300);
  Report report;
  const Moment steady = simulator.steady(profile[0].inputs, report);
  ASSERT_TRUE(report.converged());
  EXPECT_NEAR(run.moments[0].displacement, steady.displacement, 0.01 * steady.displacement);
  EXPECT_GT(run.highest_front_force, 1.1 * steady.front_force);
}

// Trap 9: the air is what is left of a seat.
TEST(Simulator, ARingThatComesLooseConductsThroughTheAirOfItsGap) {
  model::Model tight = base_spindle(), loose = base_spindle();
  loose.spindle->seat.inner_interference = -20 * um;
  Report of_tight, of_loose;
  const Moment a = Simulator(tight).steady({.speed = 6000 * rpm}, of_tight);
  const Moment b = Simulator(loose).steady({.speed = 6000 * rpm}, of_loose);
  ASSERT_TRUE(of_tight.converged() && of_loose.converged());
  EXPECT_TRUE(std::isfinite(b.displacement));
  EXPECT_GT(b.bearings[0].inner_ring_temperature, a.bearings[0].inner_ring_temperature + 0.5);
  // 6 um are loose from 13 664 rpm on: a jump across it, and back.
  const std::vector<ProfileRow> across{{.time = 600.0, .inputs = {.speed = 12000 * rpm}},
                                       {.time = 1200.0, .inputs = {.speed = 15000 * rpm}},
                                       {.time = 1800.0, .inputs = {.speed = 12000 * rpm}}};
  model::Model light = base_spindle(50.0);
  light.spindle->seat.outer_clearance = 30 * um;
  const auto run = Simulator(light).simulate(across);
  ASSERT_TRUE(run.report.converged()) << run.report.message;
  for (const Moment& m : run.moments) EXPECT_TRUE(std::isfinite(m.displacement));
}

// Trap 11.
TEST(Simulator, CoolantWarmsEvenlyFromItsInletToItsOutlet) {
  model::Model m = base_spindle();
  const model::Coolant& c = *m.spindle->coolant;
  const auto at = [](double position) {
    return model::ThermometerPlace{.name = "coolant",
                                   .part = model::ThermometerPlace::Part::coolant,
                                   .position = position,
                                   .radius = unset};
  };
  m.spindle->sensors = {at(unset), at(c.start), at(0.5 * (c.start + c.end)), at(c.end)};
  Report report;
  Inputs inputs{.speed = 6000 * rpm, .coolant_inlet = kelvin(18.5)};
  const Moment on = Simulator(m).steady(inputs, report);
  ASSERT_TRUE(report.converged());
  // All of its heat leaves with it: flow ρ c (T_out - T_in), water near 19 °C.
  const double rise = on.heat.coolant / (c.flow * 998.4 * 4184.0);
  EXPECT_NEAR(on.coolant_outlet - kelvin(18.5), rise, 2e-3 * rise);
  EXPECT_EQ(on.sensors[0], on.coolant_outlet);
  EXPECT_NEAR(on.sensors[1], kelvin(18.5), 1e-9);
  EXPECT_NEAR(on.sensors[2], 0.5 * (on.coolant_outlet + kelvin(18.5)), 1e-9);
  EXPECT_EQ(on.sensors[3], on.coolant_outlet);
  // Standing, it is of one temperature.
  inputs.coolant_on = false;
  const Moment off = Simulator(m).steady(inputs, report);
  ASSERT_TRUE(report.converged());
  EXPECT_EQ(off.heat.coolant, 0.0);
  for (const double t : off.sensors) EXPECT_EQ(t, off.coolant_outlet);
  EXPECT_GT(off.coolant_outlet, kelvin(30));
  m.spindle->coolant.reset();
  m.spindle->sensors.clear();
  EXPECT_TRUE(std::isnan(Simulator(m).steady(inputs, report).coolant_outlet));
}

TEST(Simulator, EachCircuitCarriesItsOwnHeatFromItsOwnInlet) {
  model::Model m = two_circuits();
  m.spindle->circuits[0].channel.inlet_temperature = kelvin(26);
  m.spindle->circuits[0].channel.flow *= 3.0;
  const auto at = [](double position) {
    return model::ThermometerPlace{.name = "coolant",
                                   .part = model::ThermometerPlace::Part::coolant,
                                   .position = position,
                                   .radius = unset};
  };
  const model::Coolant& second = m.spindle->circuits[0].channel;
  m.spindle->sensors = {at(unset), at(second.start + 0.25 * (second.end - second.start))};
  Report report;
  const Moment now =
      Simulator(m).steady({.speed = 6000 * rpm, .coolant_inlet = kelvin(18)}, report);
  ASSERT_TRUE(report.converged()) << report.message;
  ASSERT_EQ(now.circuits.size(), 2u);
  EXPECT_EQ(now.circuits[0].inlet, kelvin(18));
  EXPECT_EQ(now.circuits[1].inlet, kelvin(26));
  double sum = 0.0;
  for (std::size_t k = 0; k < 2; ++k) {
    // V ρ c (T_out - T_in) with water between 18 and 27 °C.
    const double expected = m.spindle->channels()[k].flow * 997.8 * 4182.0 *
                            (now.circuits[k].outlet - now.circuits[k].inlet);
    EXPECT_NEAR(now.circuits[k].heat, expected, 3e-3 * std::abs(expected));
    sum += now.circuits[k].heat;
  }
  EXPECT_GT(now.circuits[0].heat, 100.0);
  EXPECT_NEAR(now.heat.coolant, sum, 1e-4 * sum);
  EXPECT_NEAR(now.heat.stored, 0.0, 1e-3 * sum);
  EXPECT_EQ(now.sensors[0], now.coolant_outlet);
  EXPECT_NEAR(now.sensors[1],
              now.circuits[1].inlet + 0.25 * (now.circuits[1].outlet - now.circuits[1].inlet),
              1e-9);
}

TEST(Simulator, ACircuitWithoutItsOwnInletFollowsTheFirstOne) {
  Report report;
  const Moment now =
      Simulator(two_circuits()).steady({.speed = 6000 * rpm, .coolant_inlet = kelvin(18)}, report);
  ASSERT_TRUE(report.converged());
  EXPECT_EQ(now.circuits[1].inlet, kelvin(18));
}

TEST(Simulator, AChannelInTwoHalvesOfMuchFlowCoolsAsTheWholeDoes) {
  // The outlet then is as cold as the inlet; the film of a shorter channel is a little higher.
  model::Model whole = base_spindle(), halves = two_circuits();
  whole.spindle->coolant->flow = halves.spindle->coolant->flow =
      halves.spindle->circuits[0].channel.flow = 30.0 / 60000.0;
  Report report;
  const Moment one = Simulator(whole).steady({.speed = 6000 * rpm}, report);
  ASSERT_TRUE(report.converged());
  const Moment two = Simulator(halves).steady({.speed = 6000 * rpm}, report);
  ASSERT_TRUE(report.converged());
  EXPECT_NEAR(two.heat.coolant, one.heat.coolant, 2e-3 * one.heat.coolant);
  EXPECT_NEAR(two.displacement, one.displacement, 2e-3 * one.displacement);
}

TEST(Simulator, AWarmCircuitHeatsASpindleAtRest) {
  model::Model m = two_circuits();
  m.spindle->circuits[0].channel.inlet_temperature = kelvin(35);
  Report report;
  const Moment now = Simulator(m).steady({}, report);
  ASSERT_TRUE(report.converged());
  EXPECT_LT(now.circuits[1].heat, -10.0);
  EXPECT_LT(now.circuits[1].outlet, kelvin(35));
  EXPECT_GT(now.circuits[0].heat, 10.0);
}

TEST(Simulator, CircuitsThatOverlapAreRefused) {
  model::Model m = two_circuits();
  m.spindle->circuits[0].channel.start -= 5 * mm;
  EXPECT_THROW(Simulator{m}, std::invalid_argument);
  m.spindle->coolant.reset();
  EXPECT_THROW(Simulator{m}, std::invalid_argument);
}

TEST(Simulator, AScrewedFlangeConductsByItsForceInSeriesWithTheMachine) {
  model::Model screwed = base_spindle(), given = screwed;
  const model::Seat& seat = screwed.spindle->seat;
  const model::ScrewedJoint joint{.screws = 8, .screw_force = 5000.0, .area = 0.02};
  screwed.spindle->housing.flange_joint = joint;
  screwed.spindle->housing.flange_conductance = 60.0;
  // Brecher et al. 2021, eq. 4, at 2 MPa between two faces of iron, and air of 3 Ra.
  const double spots =
      std::pow(2e6 / seat.hardness, 0.93) * seat.slope * 48.0 / (0.46 * seat.roughness * 2.0);
  const double film = spots + 0.027 / (3.0 * seat.roughness);
  given.spindle->housing.flange_conductance = 1.0 / (1.0 / 60.0 + 1.0 / (film * joint.area));
  Report report;
  Simulator simulator(screwed);
  const Moment a = simulator.steady({.speed = 6000 * rpm}, report);
  const Moment b = Simulator(given).steady({.speed = 6000 * rpm}, report);
  ASSERT_TRUE(report.converged());
  EXPECT_GT(a.heat.machine, 5.0);
  EXPECT_NEAR(a.heat.machine, b.heat.machine, 1e-9 * a.heat.machine);
  EXPECT_NEAR(a.displacement, b.displacement, 1e-9 * b.displacement);
}

TEST(Simulator, SurfacesAndJointsCarryTheHeatOfTheBalance) {
  model::Model m = two_circuits();
  m.spindle->circuits[0].channel.inlet_temperature = kelvin(26);
  m.spindle->housing.flange_joint = {.screws = 8, .screw_force = 5000.0, .area = 0.02};
  Report report;
  Simulator simulator(m);
  const Moment now = simulator.steady({.speed = 6000 * rpm}, report);
  ASSERT_TRUE(report.converged());
  double air = 0.0, machine = 0.0;
  std::vector<double> coolant;
  for (const SurfaceState& s : simulator.surfaces()) {
    EXPECT_GT(s.area, 0.0) << s.name;
    EXPECT_GT(s.conductance, 0.0) << s.name;
    if (s.name == "nose" || s.name == "shaft_rear" || s.name == "housing" ||
        s.name == "housing_ends")
      air += s.heat;
    if (s.name == "flange") {
      machine = s.heat;
      EXPECT_DOUBLE_EQ(s.pressure, 2 * MPa);
      EXPECT_DOUBLE_EQ(s.area, 0.02);
    }
    if (s.name == "coolant" || s.name == "rear_jacket") coolant.push_back(s.heat);
    if (s.name == "shoulders") {
      EXPECT_EQ(s.conductance, 8000.0);
      EXPECT_TRUE(std::isnan(s.pressure) && std::isnan(s.heat));
    }
  }
  EXPECT_NEAR(air, now.heat.air, 1e-6 * now.heat.air);
  EXPECT_NEAR(machine, now.heat.machine, 1e-6 * now.heat.machine);
  ASSERT_EQ(coolant.size(), 2u);
  for (std::size_t k = 0; k < 2; ++k)
    EXPECT_NEAR(coolant[k], now.circuits[k].heat, 1e-3 * std::abs(now.circuits[k].heat));
}

// Trap 12: against another place of the housing the same run is another curve.
TEST(Simulator, DisplacementIsThatAgainstTheFlange) {
  const auto steady_at = [](double flange) {
    model::Model m = base_spindle();
    m.spindle->coolant.reset();
    m.spindle->housing.flange_conductance = 0.0;  // its place then matters to no temperature
    m.spindle->housing.flange = flange;
    for (const double place : {120, 160, 200, 240, 280})
      m.spindle->sensors.push_back({.name = "housing", .position = place * mm, .radius = 70 * mm});
    Report report;
    Moment moment = Simulator(m).steady({.speed = 6000 * rpm}, report);
    EXPECT_TRUE(report.converged());
    return moment;
  };
  const Moment near = steady_at(120 * mm), far = steady_at(280 * mm);
  const std::vector<double>& t = near.sensors;
  const double rise = 0.125 * (t[0] + 2.0 * (t[1] + t[2] + t[3]) + t[4]) - kelvin(20);
  const double iron = 160 * mm * 10.5 * per_million_K * rise;
  EXPECT_NEAR(far.displacement - near.displacement, iron, 0.02 * iron);
}

TEST(Simulator, ThermalRunawayHasItsName) {
  model::Model m = base_spindle(2500.0);
  m.lubricant = friction::Lubricant(400.0 * mm2_per_s, 60.0 * mm2_per_s);
  m.law_values = {4.0, 0.004, 0.33};
  m.spindle->coolant.reset();
  m.spindle->lubricant_conductance = 0.0;
  m.spindle->seat.outer_conductance = 20.0;
  Report report;
  (void)Simulator(m).steady({.speed = 14000 * rpm}, report);
  EXPECT_EQ(report.status, Status::thermal_runaway) << name(report.status);
  std::vector<ProfileRow> profile{{.time = 4 * 3600.0, .inputs = {.speed = 14000 * rpm}}};
  EXPECT_EQ(Simulator(m).simulate(profile).report.status, Status::thermal_runaway);
}

}  // namespace
}  // namespace raceway::spindle
