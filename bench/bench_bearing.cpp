#include <benchmark/benchmark.h>

#include <algorithm>
#include <memory>
#include <vector>

#include "bearing/arrangement_equilibrium.h"
#include "bearing/bearing_equilibrium.h"

namespace {

using namespace raceway;
using namespace raceway::bearing;

/// 7014 with 20 balls, a spindle bearing under load and at speed.
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

void run(benchmark::State& state, const OperatingPoint& point, const EquilibriumOptions& options,
         bool warm) {
  const Bearing& bearing = spindle_bearing();
  OperatingPoint before = point;
  before.speed *= 0.97;
  const BearingEquilibrium neighbour = solve_bearing_equilibrium(bearing, before, options);
  SolveReport report;
  for (auto _ : state) {
    const BearingEquilibrium e = warm
                                     ? solve_bearing_equilibrium(bearing, point, options, neighbour)
                                     : solve_bearing_equilibrium(bearing, point, options);
    report = e.report;
    benchmark::DoNotOptimize(e.displacement);
  }
  if (!report.converged()) state.SkipWithError("not converged");
  state.SetItemsProcessed(state.iterations());
  state.counters["iterations"] = report.iterations;
  state.counters["residual"] = report.residual;
  state.counters["load_error"] = report.recovered_load_error;
}

constexpr OperatingPoint thrust{.speed = 10000 * rpm, .axial_load = 1000};
constexpr OperatingPoint combined{.speed = 10000 * rpm, .axial_load = 1000, .radial_load = 300};
constexpr OperatingPoint oblique{
    .speed = 10000 * rpm, .axial_load = 1000, .radial_load = 260, .radial_load_z = 150};
constexpr EquilibriumOptions locked{};
constexpr EquilibriumOptions free_tilt{.tilt = Tilt::free};

BENCHMARK_CAPTURE(run, thrust, thrust, locked, false)->Name("solve/thrust/scalar_cold");
BENCHMARK_CAPTURE(run, locked, combined, locked, false)->Name("solve/locked_20_balls/scalar_cold");
BENCHMARK_CAPTURE(run, free, combined, free_tilt, false)->Name("solve/5dof_20_balls/scalar_cold");
BENCHMARK_CAPTURE(run, warm, combined, free_tilt, true)->Name("solve/5dof_20_balls/scalar_warm");
BENCHMARK_CAPTURE(run, oblique, oblique, free_tilt, false)
    ->Name("solve/5dof_20_balls_oblique/scalar_cold");

void make_bearing(benchmark::State& state) {
  const Bearing& b = spindle_bearing();
  for (auto _ : state) {
    Bearing made(b.geometry(), b.balls(), b.rings());
    benchmark::DoNotOptimize(made);
  }
}
BENCHMARK(make_bearing)->Name("bearing/make");

ArrangementDesign two_against_one(Mounting mounting) {
  const auto bearing = std::make_shared<const Bearing>(spindle_bearing());
  return {.front = {{bearing}, {bearing}},
          .rear = {{bearing}},
          .mounting = mounting,
          .preload = PreloadForce{600}};
}

void make_arrangement(benchmark::State& state) {
  const ArrangementDesign design = two_against_one(Mounting::rigid);
  for (auto _ : state) {
    Arrangement made(design);
    benchmark::DoNotOptimize(made);
  }
}
BENCHMARK(make_arrangement)->Name("arrangement/make");

/// Two bearings against one at 40 speeds up to 10 000 rpm.
void displacement_curve(benchmark::State& state, bool warm) {
  const Arrangement arrangement(two_against_one(Mounting::rigid));
  std::vector<ArrangementCondition> conditions(40);
  for (std::size_t i = 0; i < 40; ++i)
    conditions[i].speed = 250.0 * static_cast<double>(i + 1) * rpm;
  std::vector<ArrangementEquilibrium> results(40);
  for (auto _ : state) {
    if (warm) {
      solve_arrangement(arrangement, conditions, results);
    } else {
      for (std::size_t i = 0; i < 40; ++i)
        results[i] = solve_arrangement(arrangement, conditions[i]);
    }
    benchmark::DoNotOptimize(results);
  }
  double iterations = 0.0, residual = 0.0, load_error = 0.0;
  for (const ArrangementEquilibrium& e : results) {
    if (!e.report.converged()) state.SkipWithError("not converged");
    iterations += e.report.iterations;
    residual = std::max(residual, e.report.residual);
    load_error = std::max(load_error, e.report.recovered_load_error);
  }
  state.SetItemsProcessed(40 * state.iterations());
  state.counters["iterations_per_point"] = iterations / 40;
  state.counters["residual"] = residual;
  state.counters["load_error"] = load_error;
}
BENCHMARK_CAPTURE(displacement_curve, warm, true)->Name("arrangement/40_speeds/warm");
BENCHMARK_CAPTURE(displacement_curve, cold, false)->Name("arrangement/40_speeds/cold");

}  // namespace
