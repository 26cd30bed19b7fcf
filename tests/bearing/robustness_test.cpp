// A part of bench/robustness small enough for every test run: 20 000 points of the same domain.

#include <gtest/gtest.h>

#include <ostream>

#include "tests/bearing/random_case.h"

namespace raceway::bearing {
namespace {

struct Part {
  RaceControl race_control;
  std::uint64_t seed;
  int points;
};

void PrintTo(const Part& part, std::ostream* out) { *out << part.points << " points"; }

class Robustness : public testing::TestWithParam<Part> {};

TEST_P(Robustness, EveryPointConvergesOrHasNoEquilibrium) {
  const auto sizes = tests::catalogue_sizes();
  const int points = GetParam().points;
  int converged = 0, without = 0;
  for (int index = 0; index < points; ++index) {
    const auto c = robustness::make_case(sizes, GetParam().race_control, GetParam().seed,
                                         static_cast<std::uint64_t>(index));
    const auto solved =
        solve_bearing_equilibrium(Bearing(c.geometry, steel(), steel()), c.point, c.options);
    if (solved.report.converged()) {
      ++converged;
      EXPECT_LE(solved.report.recovered_load_error, 1e-9) << "case " << index;
    } else {
      ++without;
      EXPECT_EQ(solved.report.status, SolveStatus::no_equilibrium)
          << "case " << index << ": " << name(solved.report.status);
    }
  }
  RecordProperty("converged", converged);
  RecordProperty("no_equilibrium", without);
  // Nothing ends without a status, and most loads of the domain can be carried.
  EXPECT_EQ(converged + without, points);
  EXPECT_GT(converged, points / 2);
}

// Inner control proves many a `no_equilibrium`, which takes long, so it gets fewer points.
INSTANTIATE_TEST_SUITE_P(
    Domain, Robustness,
    testing::Values(Part{RaceControl::outer, 1, 8000}, Part{RaceControl::outer, 2, 8000},
                    Part{RaceControl::inner, 1, 2000}, Part{RaceControl::inner, 2, 2000}),
    [](const auto& part) {
      return std::string(part.param.race_control == RaceControl::outer ? "Outer" : "Inner") +
             "Control" + std::to_string(part.param.seed);
    });

}  // namespace
}  // namespace raceway::bearing
