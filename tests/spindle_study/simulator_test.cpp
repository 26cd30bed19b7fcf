#include "tests/spindle_study/simulator.h"

#include <gmock/gmock.h>

#include <cmath>

#include "tests/spindle_study/base_spindle.h"
#include "tests/spindle_study/reference.h"

namespace spindle_study {
namespace {

// Of another program, at the bars of its cases.
TEST(SpindleStudySimulator, SteadyStatesOfTheReferenceAreMet) {
  for (const Compared& f : steady_states()) EXPECT_TRUE(f.good()) << line(f);
}

// The convergence case has 2 % of displacement between 483 and 3640 cells.
TEST(SpindleStudySimulator, FinerCellsMoveTheDisplacementByLessThanOnePercent) {
  const Inputs in{.time = 0.0, .speed = 6000.0 * rpm};
  Simulator usual(base_spindle()), finer(base_spindle(), {}, 0.75 * fine_cells);
  usual.settle(in);
  finer.settle(in);
  EXPECT_GE(usual.cells(), 1500u);
  EXPECT_NEAR(usual.reading().displacement / finer.reading().displacement, 1.0, 0.01);
}

TEST(SpindleStudySimulator, StoredHeatIsHeatInLessHeatOut) {
  Simulator s(base_spindle(), {.motor = 100.0});
  s.advance({.time = 1800.0, .speed = 8000.0 * rpm});
  s.advance({.time = 3600.0, .speed = 0.0, .coolant_on = false});
  EXPECT_LT(s.balance_error(), 1e-6);
}

TEST(SpindleStudySimulator, HalvedStepsMoveAStartUpByLessThanATenthOfAMicron) {
  const Inputs in{.time = 1200.0, .speed = 6000.0 * rpm};
  Simulator usual(base_spindle()), halved(base_spindle());
  usual.advance(in);
  halved.advance(in, 15.0);
  EXPECT_NEAR(usual.reading().displacement, halved.reading().displacement, 0.1e-6);
}

TEST(SpindleStudySimulator, NothingMovesAtRestAtOneTemperature) {
  Simulator s(base_spindle());
  s.advance({.time = 3600.0});
  EXPECT_NEAR(s.reading().displacement, 0.0, 1e-12);
}

TEST(SpindleStudySimulator, HeatLeavesAtTheSteadyState) {
  Simulator s(base_spindle(), {.outer_seat = 0.3});
  const Inputs in{.time = 0.0, .speed = 4000.0 * rpm};
  s.settle(in);
  const Balance b = s.heat(in);
  double out = 0.0;
  for (const auto& [name, watts] : b.out) out += watts;
  EXPECT_NEAR(out / b.in, 1.0, 1e-4);
}

}  // namespace
}  // namespace spindle_study
