#include "spindle/drawn_run.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "tests/spindle/base_spindle.h"

namespace raceway::spindle {
namespace {

/// Three rows for four hours: what happens between them is in the steps alone.
std::vector<ProfileRow> three_rows() {
  return {{.time = 3600, .inputs = {.speed = 8000 * rpm}},
          {.time = 7200, .inputs = {.speed = 3000 * rpm, .coolant_on = false}},
          {.time = 14400, .inputs = {}}};
}

TEST(DrawnRun, IsTheRunAndTheEndsOfItsSteps) {
  Simulator simulator(base_spindle());
  const std::vector<ProfileRow> profile = three_rows();
  const spindle::Run run = simulator.simulate(profile);
  const DrawnRun drawn = drawn_run(simulator, profile, nullptr, run);
  ASSERT_EQ(drawn.rows.size(), run.step_ends.size() + 1);  // the beginning, and rows end steps
  ASSERT_EQ(drawn.moments.size(), drawn.rows.size());
  EXPECT_EQ(drawn.moments.front().time, 0.0);
  for (const Moment& m : run.moments) {
    const auto same = std::find_if(drawn.moments.begin(), drawn.moments.end(),
                                   [&](const Moment& d) { return d.time == m.time; });
    ASSERT_NE(same, drawn.moments.end()) << m.time;
    // Rounding alone: the steps are the same.
    EXPECT_NEAR(same->displacement, m.displacement, 1e-6 * um);
    EXPECT_NEAR(same->front_force, m.front_force, 1e-6);
  }
  double highest = 0.0;
  for (const Moment& m : drawn.moments) highest = std::max(highest, m.front_force);
  EXPECT_NEAR(highest, run.highest_front_force, 1e-6);
}

TEST(DrawnRun, KeepsTheTemperaturesOfTheHighestForceAndOfTheEnd) {
  Simulator simulator(base_spindle());
  const std::vector<ProfileRow> profile = three_rows();
  const spindle::Run run = simulator.simulate(profile);
  const DrawnRun drawn = drawn_run(simulator, profile, nullptr, run, 6);
  ASSERT_EQ(drawn.states.size(), 6u);
  EXPECT_TRUE(std::is_sorted(drawn.states.begin(), drawn.states.end(),
                             [](const State& a, const State& b) { return a.time < b.time; }));
  EXPECT_EQ(drawn.states.back().time, run.end.time);
  for (std::size_t k = 0; k < run.end.temperatures.size(); ++k)
    EXPECT_NEAR(drawn.states.back().temperatures[k], run.end.temperatures[k], 1e-9);
  EXPECT_TRUE(std::any_of(drawn.states.begin(), drawn.states.end(),
                          [&](const State& s) { return s.time == run.time_of_highest_force; }));
}

TEST(DrawnRun, OfOneThatEndedEarlyHasAllStepsBefore) {
  Simulator simulator(base_spindle());
  const std::vector<ProfileRow> profile{{.time = 7200, .inputs = {.speed = 30000 * rpm}}};
  const spindle::Run run = simulator.simulate(profile);
  ASSERT_EQ(run.report.status, Status::thermal_runaway);
  ASSERT_TRUE(run.moments.empty());
  const DrawnRun drawn = drawn_run(simulator, profile, nullptr, run);
  EXPECT_EQ(drawn.moments.size(), run.step_ends.size() + 1);
  EXPECT_EQ(drawn.moments.back().time, run.step_ends.back());
  ASSERT_FALSE(drawn.states.empty());
  EXPECT_EQ(drawn.states.back().time, run.step_ends.back());
}

TEST(DrawnRun, AnEarlyEndIsTheLastMomentOfTheRunAndOfItsPicture) {
  Simulator simulator(base_spindle());
  std::vector<ProfileRow> profile{{.time = 60, .inputs = {.speed = 2000 * rpm}},
                                  {.time = 7200, .inputs = {.speed = 30000 * rpm}},
                                  {.time = 7300, .inputs = {}}};
  spindle::Run run = simulator.simulate(profile);
  ASSERT_EQ(run.report.status, Status::thermal_runaway);
  ASSERT_EQ(run.moments.size(), 1u);
  add_end(simulator, profile, nullptr, run);
  ASSERT_TRUE(run.has_end);
  ASSERT_EQ(run.moments.size(), 2u);
  ASSERT_EQ(profile.size(), 4u);
  EXPECT_EQ(profile[1].time, run.end.time);
  EXPECT_EQ(profile[1].inputs.speed, 30000 * rpm);
  EXPECT_EQ(run.moments[1].time, run.end.time);
  EXPECT_GT(run.moments[1].heat.friction, 10.0 * run.moments[0].heat.friction);
  const DrawnRun drawn = drawn_run(simulator, profile, nullptr, run);
  EXPECT_EQ(drawn.moments.back().time, run.moments[1].time);
  EXPECT_EQ(drawn.moments.back().displacement, run.moments[1].displacement);
  // A run that goes through has no such end.
  std::vector<ProfileRow> quiet{{.time = 60, .inputs = {.speed = 2000 * rpm}}};
  spindle::Run through = simulator.simulate(quiet);
  add_end(simulator, quiet, nullptr, through);
  EXPECT_FALSE(through.has_end);
  EXPECT_EQ(quiet.size(), 1u);
}

TEST(DrawnRun, GoesOnFromAState) {
  Simulator simulator(base_spindle());
  const std::vector<ProfileRow> profile = three_rows();
  const State warm = simulator.simulate(std::span(profile).first(1)).end;
  const auto rest = std::span(profile).subspan(1);
  const spindle::Run run = simulator.simulate(rest, &warm);
  const DrawnRun drawn = drawn_run(simulator, rest, &warm, run);
  EXPECT_EQ(drawn.moments.front().time, warm.time);
  EXPECT_NEAR(drawn.moments.back().displacement, run.moments.back().displacement, 1e-6 * um);
}

}  // namespace
}  // namespace raceway::spindle
