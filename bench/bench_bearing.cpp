#include <benchmark/benchmark.h>
#include <tbb/global_control.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <stdexcept>
#include <string>
#include <vector>

#include "bearing/arrangement_equilibrium.h"
#include "bearing/bearing_equilibrium.h"
#include "bearing/ring_newton.h"
#include "bearing/solve_many.h"
#include "bearing/thrust_start.h"
#include "bench/counted.h"
#include "bench/limit_kernel.h"

namespace raceway::limit {

void do_operations(bearing::InstructionSet set, const Operations& each, long count) {
  switch (set) {
    case bearing::InstructionSet::sse2:
      return do_sse2(each, count);
    case bearing::InstructionSet::avx2:
      return do_avx2(each, count);
    case bearing::InstructionSet::avx512:
      return do_avx512(each, count);
  }
}

}  // namespace raceway::limit

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

/// A load too light for its speed under inner control: all ways are searched and none leads to a
/// balance.
void without_balance(benchmark::State& state) {
  const EquilibriumOptions options{.race_control = RaceControl::inner, .tilt = Tilt::free};
  const OperatingPoint point{.speed = 20000 * rpm, .axial_load = 200, .radial_load = 150};
  SolveReport report;
  for (auto _ : state) {
    report = solve_bearing_equilibrium(spindle_bearing(), point, options).report;
    benchmark::DoNotOptimize(report);
  }
  if (report.status != SolveStatus::no_equilibrium) state.SkipWithError("a balance was found");
  state.SetItemsProcessed(state.iterations());
  state.counters["iterations"] = report.iterations;
}
BENCHMARK(without_balance)->Name("solve/inner_without_balance")->Unit(benchmark::kMillisecond);

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

/// How a batch is made up.
struct Many {
  InstructionSet set = best_instruction_set();
  std::size_t threads = 1;
  std::size_t points = 1024;  ///< results stay in the cache, as a caller's pieces do
  int balls = 20;
};

void run_many(benchmark::State& state, const OperatingPoint& point,
              const EquilibriumOptions& options, const Many& many) {
  const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, many.threads);
  BearingGeometry geometry = spindle_bearing().geometry();
  geometry.ball_count = many.balls;
  const Bearing made(geometry, steel(), steel());
  const std::vector<OperatingPoint> points = points_like(point, many.points);
  std::vector<BearingEquilibrium> results(points.size());
  for (auto _ : state) {
    solve_many(made, points, results, options, many.set);
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
  const bool is_thrust = std::string(name) == "thrust";
  const std::string base = std::string("solve/") + name + (is_thrust ? "/batch" : "/batch_cold");
  const auto add = [&](const std::string& suffix, const Many& many) {
    auto* const made =
        benchmark::RegisterBenchmark((base + suffix).c_str(), run_many, point, options, many);
    if (many.threads > 1) made->UseRealTime();
  };
  add("", {});
  add("_2_threads", {.threads = 2, .points = 8192});
  for (const InstructionSet set : {InstructionSet::sse2, InstructionSet::avx2})
    if (available(set)) add("_" + std::string(bearing::name(set)), {.set = set});
}

/// What Newton's method computes for `point`, counted in its own code, per ball and step.
template <class C>
limit::Operations operations(const OperatingPoint& point, const EquilibriumOptions& options) {
  using limit::Counted;
  RingPoint<double> ring = unloaded_point(spindle_bearing(), options);
  set_operating_point(ring, spindle_bearing(), point, options);
  const BallCircle circle = ball_circle(spindle_bearing(), point);
  ThrustStart<double> start;
  if (!thrust_start(options.race_control, ring.ball, ring.free, point.axial_load / circle.count,
                    start))
    throw std::runtime_error("no thrust start");
  RingNewton<Counted> newton;
  copy_lanes(newton.point, 0, ring, 0);
  newton.resize(static_cast<std::size_t>(circle.used()));
  for (Counted& q : newton.trial_ring) q = 0.0;
  newton.trial_ring[0] = start.axial_displacement;
  for (auto& x : newton.trial_balls) x = {start.ball_centre.axial, start.ball_centre.radial};
  newton.begin(0);
  const NewtonLimits limits{.tolerance = options.tolerance, .steps = 40};
  // The first step is left out: there all balls are alike, and computed once.
  const auto pass = [&] {
    return newton.pass<BallModel::outer_control, C>(circle, limits).converged;
  };
  (void)pass();
  Counted::roots = Counted::divisions = Counted::products = Counted::sums = 0;
  long steps = 0;
  for (bool converged = false; !converged && steps < 40; ++steps) converged = pass();
  const long balls = steps * circle.used();
  return {.roots = Counted::roots / balls,
          .divisions = Counted::divisions / balls,
          .fused = std::max(Counted::products, Counted::sums) / balls};
}

/// The same arithmetic as a batch_cold of `point`, without dependencies.
template <class C>
void run_limit(benchmark::State& state, const OperatingPoint& point,
               const EquilibriumOptions& options, InstructionSet set) {
  const limit::Operations each = operations<C>(point, options);
  const std::vector<OperatingPoint> points = points_like(point, 1024);
  std::vector<BearingEquilibrium> results(points.size());
  solve_many(spindle_bearing(), points, results, options);
  long passes = 0;
  double residual = 0.0;
  for (const BearingEquilibrium& e : results) {
    passes += e.report.iterations + 1;
    residual = std::fmax(residual, e.report.residual);
  }
  const long lanes = set == InstructionSet::avx512 ? 8 : set == InstructionSet::avx2 ? 4 : 2;
  const long balls = passes * ball_circle(spindle_bearing(), point).used();
  for (auto _ : state) limit::do_operations(set, each, balls / lanes);
  state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(points.size()));
  state.counters["iterations"] =
      static_cast<double>(passes) / static_cast<double>(points.size()) - 1.0;
  state.counters["residual"] = residual;
  state.counters["square_roots"] = static_cast<double>(each.roots);
  state.counters["divisions"] = static_cast<double>(each.divisions);
  state.counters["fused_multiply_adds"] = static_cast<double>(each.fused);
}

const bool registered = [] {
  for (const InstructionSet set :
       {best_instruction_set(), InstructionSet::sse2, InstructionSet::avx2}) {
    if (!available(set)) continue;
    const std::string suffix =
        set == best_instruction_set() ? "" : "_" + std::string(bearing::name(set));
    benchmark::RegisterBenchmark(("limit/5dof_20_balls" + suffix).c_str(),
                                 run_limit<Coordinates<0, 1, 4>>, combined, free_tilt, set);
    benchmark::RegisterBenchmark(("limit/thrust" + suffix).c_str(), run_limit<Coordinates<0>>,
                                 thrust, locked, set);
  }
  register_many("thrust", thrust, locked);
  register_many("locked_20_balls", combined, locked);
  register_many("5dof_20_balls", combined, free_tilt);
  register_many("5dof_20_balls_oblique", oblique, free_tilt);
  // How cost grows.
  for (const std::size_t points : {1u, 8u, 64u, 512u, 4096u, 32768u})
    benchmark::RegisterBenchmark(("grow/points_" + std::to_string(points)).c_str(), run_many,
                                 combined, free_tilt, Many{.points = points});
  for (const int balls : {8, 12, 16, 20, 23})
    benchmark::RegisterBenchmark(("grow/balls_" + std::to_string(balls)).c_str(), run_many,
                                 combined, free_tilt, Many{.points = 1024, .balls = balls});
  return true;
}();

enum class Start { cold, neighbour, predicted };

/// b + (b - a), as a start: displacement, outer angles and loads.
void extrapolate(const BearingEquilibrium& a, const BearingEquilibrium& b, BearingEquilibrium& to) {
  to = b;
  to.displacement += b.displacement - a.displacement;
  const auto balls = to.balls.reset(static_cast<int>(b.balls.size()), Symmetry::mirror);
  for (std::size_t k = 0; k < balls.size(); ++k) {
    const BallEquilibrium x = a.balls[k], y = b.balls[k];
    balls[k].outer_contact_angle = 2.0 * y.outer_contact_angle - x.outer_contact_angle;
    balls[k].outer_load = 2.0 * y.outer_load - x.outer_load;
  }
}

/// A row of a table: 100 speeds to 12 000 rpm, one solve at a time.
void sweep(benchmark::State& state, Start start) {
  constexpr int speeds = 100;
  std::vector<BearingEquilibrium> found(speeds);
  BearingEquilibrium guess;
  for (auto _ : state) {
    OperatingPoint p = combined;
    for (std::size_t i = 0; i < speeds; ++i) {
      p.speed = 120.0 * static_cast<double>(i + 1) * rpm;
      if (start == Start::cold || i == 0) {
        found[i] = solve_bearing_equilibrium(spindle_bearing(), p, free_tilt);
        continue;
      }
      const bool predict = start == Start::predicted && i > 1;
      if (predict) extrapolate(found[i - 2], found[i - 1], guess);
      found[i] = solve_bearing_equilibrium(spindle_bearing(), p, free_tilt,
                                           predict ? guess : found[i - 1]);
    }
    benchmark::DoNotOptimize(found.data());
  }
  double steps = 0.0, residual = 0.0;
  for (const BearingEquilibrium& e : found) {
    if (!e.report.converged()) state.SkipWithError("not converged");
    steps += e.report.iterations;
    residual = std::fmax(residual, e.report.residual);
  }
  state.SetItemsProcessed(speeds * state.iterations());
  state.counters["iterations"] = steps / speeds;
  state.counters["residual"] = residual;
}
BENCHMARK_CAPTURE(sweep, cold, Start::cold)->Name("sweep/100_speeds/scalar_cold");
BENCHMARK_CAPTURE(sweep, neighbour, Start::neighbour)->Name("sweep/100_speeds/scalar_neighbour");
BENCHMARK_CAPTURE(sweep, predicted, Start::predicted)->Name("sweep/100_speeds/scalar_predicted");

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
  state.counters["iterations"] = iterations / 40;
  state.counters["residual"] = residual;
  state.counters["load_error"] = load_error;
}
BENCHMARK_CAPTURE(displacement_curve, warm, true)->Name("arrangement/40_speeds/warm");
BENCHMARK_CAPTURE(displacement_curve, cold, false)->Name("arrangement/40_speeds/cold");

}  // namespace
