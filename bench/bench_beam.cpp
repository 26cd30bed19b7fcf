#include <benchmark/benchmark.h>
#include <tbb/global_control.h>

#include <memory>
#include <vector>

#include "spindle/loaded_shaft.h"
#include "spindle/modes.h"

namespace {

using namespace raceway;
using namespace raceway::spindle;

/// The spindle shaft of the reference cases, 375 mm, on three bearings of 15 degrees, two in front.
struct BenchShaft {
  std::vector<double> places{60 * mm, 90 * mm, 290 * mm};
  model::ShaftBody body;
  bearing::Arrangement sets;

  BenchShaft() : sets(design()) {
    const double sections[][2] = {{50, 104}, {50, 70}, {180, 82}, {20, 70}, {75, 60}};
    for (const auto& [length, diameter] : sections)
      body.segments.push_back({.length = length * mm, .diameter = diameter * mm, .bore = 36 * mm});
  }
  static bearing::ArrangementDesign design() {
    const auto b = std::make_shared<const bearing::Bearing>(
        bearing::BearingGeometry{.ball_count = 20,
                                 .ball_diameter = 11.9 * mm,
                                 .pitch_diameter = 90 * mm,
                                 .contact_angle = 15 * degree,
                                 .inner_conformity = 0.52,
                                 .outer_conformity = 0.52},
        bearing::steel(), bearing::steel());
    return {.front = {{b}, {b}}, .rear = {{b}}, .preload = bearing::PreloadForce{300.0}};
  }
  [[nodiscard]] Beam beam(int elements) const { return {body, places, {.elements = elements}}; }
  [[nodiscard]] std::vector<Spring> springs(double speed) const {
    const bearing::ArrangementCondition condition{.speed = speed};
    return bearing_springs(sets, places,
                           bearings_in_set(sets, condition, solve_arrangement(sets, condition)));
  }
};

const BenchShaft& bench_shaft() {
  static const BenchShaft shaft;
  return shaft;
}

/// Lowest modes at one speed, the springs at hand. `twist` makes them anisotropic.
void modes_of(benchmark::State& state, int elements, double twist) {
  const Beam beam = bench_shaft().beam(elements);
  std::vector<Spring> springs = bench_shaft().springs(8000 * rpm);
  for (Spring& s : springs) s.z.radial *= twist;
  Modes found;
  for (auto _ : state) {
    found = find_modes(beam, springs, 8000 * rpm);
    benchmark::DoNotOptimize(found.modes.data());
  }
  if (!found.converged()) state.SkipWithError("not converged");
  state.counters["elements"] = static_cast<double>(beam.elements());
  state.counters["f1_Hz"] = found.modes.empty() ? 0.0 : found.modes[0].frequency / (2.0 * pi);
}
BENCHMARK_CAPTURE(modes_of, 100, 100, 1.0)->Name("beam/modes/100_elements");
BENCHMARK_CAPTURE(modes_of, 400, 400, 1.0)->Name("beam/modes/400_elements");
BENCHMARK_CAPTURE(modes_of, anisotropic, 100, 0.8)->Name("beam/modes/100_elements_anisotropic");

/// 40 speeds to 20 000 rpm, sets and modes at each.
void campbell_of(benchmark::State& state, std::size_t threads) {
  const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, threads);
  const Beam beam = bench_shaft().beam(100);
  std::vector<Modes> found;
  for (auto _ : state) {
    std::vector<double> speeds;
    std::vector<std::vector<Spring>> springs;
    for (int i = 1; i <= 40; ++i) {
      speeds.push_back(500 * i * rpm);
      springs.push_back(bench_shaft().springs(speeds.back()));
    }
    found = campbell(beam, speeds, springs);
    benchmark::DoNotOptimize(found.data());
  }
  for (const Modes& m : found)
    if (!m.converged()) state.SkipWithError("not converged");
}
BENCHMARK_CAPTURE(campbell_of, one, 1)
    ->Name("beam/campbell_40_speeds")
    ->Unit(benchmark::kMillisecond);

/// The elastic shaft and three bearings in five degrees of freedom under 1 kN at the nose.
void loaded_shaft(benchmark::State& state) {
  const Beam beam = bench_shaft().beam(75);
  LoadedShaft bent;
  for (auto _ : state) {
    bent = solve_loaded_shaft(beam, bench_shaft().sets, bench_shaft().places, {.speed = 8000 * rpm},
                              {.radial = 1000.0});
    benchmark::DoNotOptimize(bent.position);
  }
  if (!bent.report.converged()) state.SkipWithError("not converged");
  state.counters["iterations"] = bent.report.iterations;
  state.counters["residual"] = bent.report.residual;
}
BENCHMARK(loaded_shaft)->Name("beam/loaded_shaft_1_kN");

}  // namespace
