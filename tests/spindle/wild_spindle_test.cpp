#include "bench/wild_spindle.h"

#include <gtest/gtest.h>

#include <map>
#include <string>

namespace raceway::spindle {
namespace {

// Optimised builds go through 10 000 spindles, others through every thirty-ninth of these. Even
// ones are asked where they lead to, odd ones go through a programme.
#ifdef NDEBUG
constexpr std::uint64_t wild_step = 1;
#else
constexpr std::uint64_t wild_step = 39;  // odd, for both kinds to come
#endif

constexpr std::uint64_t wild_part = 1000;

class Wild : public testing::TestWithParam<std::uint64_t> {};

void expect_steady(Simulator& simulator, const robustness::WildSpindle& w, Report& report) {
  const Moment steady = simulator.steady(w.inputs, report);
  if (report.converged()) {
    EXPECT_TRUE(robustness::finite(steady));
  }
}

void expect_run(Simulator& simulator, const robustness::WildSpindle& w, Report& report) {
  const auto run = simulator.simulate(w.programme);
  report = run.report;
  for (const Moment& m : run.moments) EXPECT_TRUE(robustness::finite(m)) << m.time << " s";
  if (report.converged()) {
    EXPECT_EQ(run.moments.size(), w.programme.size());
    EXPECT_LT(report.energy_error, 1e-8);
  } else {
    EXPECT_LT(run.moments.size(), w.programme.size());
  }
}

TEST_P(Wild, EverySpindleEndsWithAStatusAndWithoutNaN) {
  std::map<std::string, int> ends;
  int runs = 0;
  const std::uint64_t first = GetParam() * wild_part;
  for (std::uint64_t index = first; index < first + wild_part; index += wild_step) {
    SCOPED_TRACE("spindle " + std::to_string(index));
    const robustness::WildSpindle w = robustness::make_wild_spindle(1, index);
    Simulator simulator(w.model, w.condition);
    Report report;
    (index % 2 == 0 ? expect_steady : expect_run)(simulator, w, report);
    ++runs;
    ++ends[std::string(name(report.status))];
    EXPECT_NE(report.status, Status::not_run);
    EXPECT_EQ(report.converged(), report.message.empty());
  }
  for (const auto& [status, count] : ends) RecordProperty(status, count);
  EXPECT_GT(ends["converged"], runs / 3);
  EXPECT_GT(ends["thermal_runaway"], 0);
}

INSTANTIATE_TEST_SUITE_P(Spindles, Wild, testing::Range(std::uint64_t{0}, std::uint64_t{10}));

}  // namespace
}  // namespace raceway::spindle
