#include <benchmark/benchmark.h>

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

}  // namespace
