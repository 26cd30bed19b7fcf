#include "bearing/solve_many.h"

#include <gtest/gtest.h>
#include <tbb/global_control.h>

#include <bit>
#include <cmath>
#include <cstdint>
#include <ostream>
#include <vector>

#include "tests/bearing/random_case.h"

namespace raceway::bearing {
namespace {

/// Cases of the robustness domain with one tilt, and their bearings.
struct Domain {
  std::vector<Bearing> bearings;
  std::vector<OperatingPoint> points;
  EquilibriumOptions options;

  Domain(RaceControl control, Tilt tilt, std::size_t count)
      : options{.race_control = control, .tilt = tilt} {
    const auto sizes = tests::catalogue_sizes();
    for (std::uint64_t index = 0; points.size() < count; ++index) {
      const auto c = robustness::make_case(sizes, control, 7, index);
      bearings.emplace_back(c.geometry, index % 2 == 0 ? steel() : silicon_nitride(), steel());
      points.push_back(c.point);
      // Neither thrust nor standstill nor a free moment are in that domain.
      if (index % 7 == 0) points.back().radial_load = points.back().radial_load_z = 0.0;
      if (index % 11 == 0) points.back().speed = 0.0;
      if (index % 5 == 0 && tilt == Tilt::free)
        points.back().moment_z = 0.2 * static_cast<double>(index % 3);
    }
  }
  [[nodiscard]] std::vector<BearingCase> cases() const {
    std::vector<BearingCase> all;
    for (std::size_t i = 0; i < points.size(); ++i) all.push_back({&bearings[i], points[i]});
    return all;
  }
};

void expect_equal(const BearingEquilibrium& a, const BearingEquilibrium& b, double tolerance) {
  ASSERT_EQ(a.report.status, b.report.status);
  if (!a.report.converged()) return;
  const double size = a.displacement.head<3>().cwiseAbs().maxCoeff();
  EXPECT_LE((a.displacement - b.displacement).head<3>().cwiseAbs().maxCoeff(), tolerance * size);
  EXPECT_LE((a.stiffness - b.stiffness).cwiseAbs().maxCoeff(),
            tolerance * a.stiffness.cwiseAbs().maxCoeff());
  EXPECT_LE(b.report.recovered_load_error, 1e-9);
  ASSERT_EQ(a.balls.size(), b.balls.size());
  const auto near = [&](double x, double y, double scale) {
    EXPECT_TRUE((std::isnan(x) && std::isnan(y)) || std::abs(x - y) <= tolerance * scale)
        << x << " and " << y;
  };
  double most = 0.0;
  for (const BallEquilibrium& ball : a.balls) most = std::fmax(most, ball.outer_load);
  for (std::size_t k = 0; k < a.balls.size(); ++k) {
    const BallEquilibrium &x = a.balls[k], &y = b.balls[k];
    EXPECT_EQ(x.azimuth, y.azimuth);
    near(x.inner_contact_angle, y.inner_contact_angle, 1.0);
    near(x.outer_contact_angle, y.outer_contact_angle, 1.0);
    near(x.inner_load, y.inner_load, most);
    near(x.outer_load, y.outer_load, most);
    near(x.inner_friction, y.inner_friction, most);
    near(x.outer_friction, y.outer_friction, most);
    near(x.centrifugal_force, y.centrifugal_force, most);
    near(x.gyroscopic_moment, y.gyroscopic_moment, most);
  }
}

std::vector<InstructionSet> available_sets() {
  std::vector<InstructionSet> sets;
  for (const auto set : {InstructionSet::sse2, InstructionSet::avx2, InstructionSet::avx512})
    if (available(set)) sets.push_back(set);
  return sets;
}

struct BatchPart {
  RaceControl control;
  Tilt tilt;
  std::size_t count;
};

void PrintTo(const BatchPart& part, std::ostream* out) { *out << part.count << " points"; }

class SolveMany : public testing::TestWithParam<BatchPart> {};

TEST_P(SolveMany, FindsWhatSingleSolvesFindWithEveryInstructionSet) {
  const Domain domain(GetParam().control, GetParam().tilt, GetParam().count);
  const auto cases = domain.cases();
  std::vector<BearingEquilibrium> single;
  for (const BearingCase& c : cases)
    single.push_back(solve_bearing_equilibrium(*c.bearing, c.point, domain.options));
  for (const InstructionSet set : available_sets()) {
    std::vector<BearingEquilibrium> many(cases.size());
    solve_many(cases, many, domain.options, set);
    for (std::size_t i = 0; i < cases.size(); ++i) {
      SCOPED_TRACE(std::string(name(set)) + ", case " + std::to_string(i));
      expect_equal(single[i], many[i], 1e-8);
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Domain, SolveMany,
                         testing::Values(BatchPart{RaceControl::outer, Tilt::locked, 1500},
                                         BatchPart{RaceControl::outer, Tilt::free, 1500},
                                         BatchPart{RaceControl::inner, Tilt::locked, 120},
                                         BatchPart{RaceControl::inner, Tilt::free, 60}),
                         [](const auto& part) {
                           return std::string(part.param.control == RaceControl::outer ? "Outer"
                                                                                       : "Inner") +
                                  (part.param.tilt == Tilt::free ? "FreeTilt" : "LockedTilt");
                         });

/// All numbers of a result, bit by bit.
std::vector<std::uint64_t> bits(const BearingEquilibrium& e) {
  std::vector<std::uint64_t> all{static_cast<std::uint64_t>(e.report.status),
                                 static_cast<std::uint64_t>(e.report.iterations)};
  const auto add = [&all](double x) { all.push_back(std::bit_cast<std::uint64_t>(x)); };
  for (const double x : e.displacement.reshaped()) add(x);
  for (const double x : e.stiffness.reshaped()) add(x);
  add(e.report.residual);
  add(e.report.recovered_load_error);
  for (const BallEquilibrium& b : e.balls)
    for (const double x : {b.inner_contact_angle, b.outer_contact_angle, b.inner_load, b.outer_load,
                           b.inner_friction, b.outer_friction, b.gyroscopic_moment})
      add(x);
  return all;
}

TEST(SolveManyResult, DependsOnNoOtherPointAndNoNumberOfThreads) {
  for (const RaceControl control : {RaceControl::outer, RaceControl::inner}) {
    const Domain domain(control, Tilt::free, control == RaceControl::outer ? 1200 : 40);
    auto cases = domain.cases();
    for (const InstructionSet set : available_sets()) {
      std::vector<BearingEquilibrium> together(cases.size()), threaded = together;
      {
        const tbb::global_control one(tbb::global_control::max_allowed_parallelism, 1);
        solve_many(cases, together, domain.options, set);
      }
      const tbb::global_control four(tbb::global_control::max_allowed_parallelism, 4);
      solve_many(cases, threaded, domain.options, set);
      for (std::size_t i = 0; i < cases.size(); ++i) {
        SCOPED_TRACE(std::string(name(set)) + ", case " + std::to_string(i));
        ASSERT_EQ(bits(together[i]), bits(threaded[i]));
        if (i % 3 != 0) continue;
        // Alone, and among others than before.
        BearingEquilibrium alone;
        solve_many(std::span(&cases[i], 1), std::span(&alone, 1), domain.options, set);
        ASSERT_EQ(bits(together[i]), bits(alone));
      }
    }
  }
}

const Bearing& spindle_bearing() {
  static const Bearing bearing({.ball_count = 20,
                                .ball_diameter = 11.906 * mm,
                                .pitch_diameter = 90 * mm,
                                .contact_angle = 25 * degree,
                                .inner_conformity = 0.52,
                                .outer_conformity = 0.52},
                               steel(), steel());
  return bearing;
}

TEST(SolveManyResult, HasTheStatusOfASingleSolveWhereThereIsNoBalance) {
  const std::vector<OperatingPoint> points{
      {.speed = 1000},                                        // no load
      {.speed = 1000, .axial_load = -100},                    // pushed backwards
      {.speed = 1000, .radial_load = 100},                    // no thrust
      {.speed = 0, .axial_load = 100, .radial_load_z = 30},   // at rest
      {.speed = 2000, .axial_load = 1, .radial_load = 1000},  // contact lost nearly all round
      {.speed = 2000, .axial_load = 400, .moment_z = 1e4},    // more moment than it can carry
      {.speed = 2000, .axial_load = 400, .radial_load = 100}};
  for (const Tilt tilt : {Tilt::locked, Tilt::free}) {
    const EquilibriumOptions options{.tilt = tilt};
    std::vector<BearingEquilibrium> many(points.size());
    solve_many(spindle_bearing(), points, many, options);
    for (std::size_t i = 0; i < points.size(); ++i) {
      SCOPED_TRACE(i);
      expect_equal(solve_bearing_equilibrium(spindle_bearing(), points[i], options), many[i], 1e-8);
    }
  }
}

TEST(SolveManyResult, IsShownToAVisitorOncePerPoint) {
  std::vector<OperatingPoint> points;
  for (int i = 0; i < 1500; ++i)
    points.push_back({.speed = 0.5 * i, .axial_load = 300.0 + i, .radial_load = 0.1 * (i % 9)});
  std::vector<BearingEquilibrium> results(points.size());
  solve_many(spindle_bearing(), points, results);
  std::vector<int> seen(points.size(), 0);
  visit_equilibria(spindle_bearing(), points, [&](std::size_t i, const BearingEquilibrium& e) {
    ++seen[i];
    EXPECT_EQ(bits(e), bits(results[i]));
  });
  EXPECT_EQ(seen, std::vector<int>(points.size(), 1));
}

TEST(SolveManyInput, IsRefusedAsASingleSolveRefusesIt) {
  std::vector<OperatingPoint> points(3, {.speed = 100, .axial_load = 100});
  std::vector<BearingEquilibrium> results(2);
  EXPECT_THROW(solve_many(spindle_bearing(), points, results), std::invalid_argument);
  results.resize(3);
  points[1].speed = -1.0;
  EXPECT_THROW(solve_many(spindle_bearing(), points, results), std::invalid_argument);
}

}  // namespace
}  // namespace raceway::bearing
