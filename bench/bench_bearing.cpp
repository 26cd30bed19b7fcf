#include <benchmark/benchmark.h>

#include <cmath>
#include <string>
#include <vector>

#include <tbb/global_control.h>

#include "bearing/bearing_equilibrium.h"
#include "bearing/solve_many.h"

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

/// Points like `point`, the loads and the speed each varied by a tenth.
std::vector<OperatingPoint> points_like(const OperatingPoint& point, std::size_t count) {
  std::vector<OperatingPoint> points(count, point);
  for (std::size_t i = 0; i < count; ++i) {
    const auto vary = [&](std::size_t step) {
      return 0.9 + 0.2 * static_cast<double>(i * step % count) / static_cast<double>(count);
    };
    points[i].speed *= vary(7);
    points[i].axial_load *= vary(11);
    points[i].radial_load *= vary(13);
    points[i].radial_load_z *= vary(13);
  }
  return points;
}

void run_many(benchmark::State& state, const OperatingPoint& point,
              const EquilibriumOptions& options, InstructionSet set, std::size_t threads) {
  if (!available(set)) {
    state.SkipWithError("this machine has no such instructions");
    return;
  }
  const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, threads);
  const std::vector<OperatingPoint> points = points_like(point, 4096);
  std::vector<BearingEquilibrium> results(points.size());
  for (auto _ : state) {
    solve_many(spindle_bearing(), points, results, options, set);
    benchmark::DoNotOptimize(results.data());
  }
  double steps = 0.0, residual = 0.0, load_error = 0.0;
  for (const BearingEquilibrium& e : results) {
    if (!e.report.converged()) state.SkipWithError("not converged");
    steps += e.report.iterations;
    residual = std::fmax(residual, e.report.residual);
    load_error = std::fmax(load_error, e.report.recovered_load_error);
  }
  state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(points.size()));
  state.counters["iterations"] = steps / static_cast<double>(points.size());
  state.counters["residual"] = residual;
  state.counters["load_error"] = load_error;
}

void register_many(const char* name, const OperatingPoint& point,
                   const EquilibriumOptions& options) {
  const std::string base = std::string("solve/") + name + "/batch";
  const auto add = [&](const std::string& suffix, InstructionSet set, std::size_t threads) {
    benchmark::RegisterBenchmark((base + suffix).c_str(), run_many, point, options, set, threads)
        ->UseRealTime();
  };
  const std::string cold = std::string(name) == "thrust" ? "" : "_cold";
  add(cold, best_instruction_set(), 1);
  add(cold + "_2_threads", best_instruction_set(), 2);
  for (const InstructionSet set : {InstructionSet::sse2, InstructionSet::avx2})
    if (available(set)) add(cold + "_" + std::string(bearing::name(set)), set, 1);
}

const bool registered = [] {
  register_many("thrust", thrust, locked);
  register_many("locked_20_balls", combined, locked);
  register_many("5dof_20_balls", combined, free_tilt);
  register_many("5dof_20_balls_oblique", oblique, free_tilt);
  return true;
}();

void make_bearing(benchmark::State& state) {
  const Bearing& b = spindle_bearing();
  for (auto _ : state) {
    Bearing made(b.geometry(), b.balls(), b.rings());
    benchmark::DoNotOptimize(made);
  }
}
BENCHMARK(make_bearing)->Name("bearing/make");

}  // namespace
