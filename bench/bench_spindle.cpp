#include <benchmark/benchmark.h>

#include <cmath>
#include <vector>

#include "spindle/spindle.h"
#include "spindle/warm_sets.h"
#include "tests/spindle/base_spindle.h"

namespace {

using namespace raceway;
using namespace raceway::spindle;

/// 8 h, a row a minute: four speeds, a pause, the coolant off for 50 minutes of it.
std::vector<ProfileRow> working_day() {
  std::vector<ProfileRow> profile;
  for (int k = 1; k <= 480; ++k) {
    const double speed = k <= 120 ? 2000 : k <= 240 ? 8000 : k <= 300 ? 0 : k <= 400 ? 6000 : 10000;
    profile.push_back({.time = 60.0 * k,
                       .inputs = {.speed = speed * rpm,
                                  .ambient_temperature = kelvin(20.0 + 2.0 * std::sin(0.01 * k)),
                                  .coolant_on = k <= 330 || k > 380}});
  }
  return profile;
}

model::Model spindle_of(model::Cells cells) {
  model::Model m = base_spindle();
  m.spindle->cells = cells;
  return m;
}

/// Fine cells and steps of 10 s at most.
const std::vector<Moment>& accurate_day() {
  static const std::vector<Moment> moments = [] {
    model::Model m = spindle_of(model::Cells::fine);
    m.spindle->step = 10.0;
    return Simulator(m).simulate(working_day()).moments;
  }();
  return moments;
}

/// Sets solved in both stages of every step; its error against fine cells and short steps.
void day_of(benchmark::State& state, model::Cells cells) {
  const std::vector<ProfileRow> profile = working_day();
  Simulator simulator(spindle_of(cells));
  Run run;
  for (auto _ : state) {
    run = simulator.simulate(profile);
    benchmark::DoNotOptimize(run.moments.data());
  }
  if (!run.report.converged()) {
    state.SkipWithError("not converged");
    return;
  }
  double squares = 0.0;
  for (std::size_t k = 0; k < profile.size(); ++k)
    squares += std::pow(run.moments[k].displacement - accurate_day()[k].displacement, 2);
  state.SetItemsProcessed(state.iterations());
  state.counters["cells"] = static_cast<double>(simulator.cells());
  state.counters["steps"] = run.report.steps;
  state.counters["rms_error_um"] = std::sqrt(squares / static_cast<double>(profile.size())) / um;
  state.counters["energy_error"] = run.report.energy_error;
}
BENCHMARK_CAPTURE(day_of, coarse, model::Cells::coarse)
    ->Name("spindle/day/coarse")
    ->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(day_of, medium, model::Cells::medium)
    ->Name("spindle/day/medium")
    ->Unit(benchmark::kMillisecond);

/// The state that 6000 rpm leads to; its error against fine cells.
void steady_of(benchmark::State& state, model::Cells cells) {
  Simulator simulator(spindle_of(cells));
  Report report;
  Moment moment;
  for (auto _ : state) {
    moment = simulator.steady({.speed = 6000 * rpm}, report);
    benchmark::DoNotOptimize(moment.displacement);
  }
  if (!report.converged()) state.SkipWithError("not converged");
  Report of_fine;
  const Moment fine =
      Simulator(spindle_of(model::Cells::fine)).steady({.speed = 6000 * rpm}, of_fine);
  state.SetItemsProcessed(state.iterations());
  state.counters["cells"] = static_cast<double>(simulator.cells());
  state.counters["rounds"] = report.steps;
  state.counters["error_um"] = (moment.displacement - fine.displacement) / um;
}
BENCHMARK_CAPTURE(steady_of, coarse, model::Cells::coarse)
    ->Name("spindle/steady/coarse")
    ->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(steady_of, medium, model::Cells::medium)
    ->Name("spindle/steady/medium")
    ->Unit(benchmark::kMillisecond);

/// Cells, joints and sets made ready.
void make_of(benchmark::State& state) {
  const model::Model m = spindle_of(model::Cells::medium);
  for (auto _ : state) benchmark::DoNotOptimize(Simulator(m).cells());
  state.SetItemsProcessed(state.iterations());
}
BENCHMARK(make_of)->Name("spindle/make/medium")->Unit(benchmark::kMillisecond);

/// Three bearings at ring temperatures near those before, with friction and forces.
void sets_of(benchmark::State& state) {
  WarmSets sets(base_spindle(), {});
  if (!sets.set_inputs({.speed = 6000 * rpm})) state.SkipWithError("no balance when cold");
  double warm = 0.0;
  for (auto _ : state) {
    warm = warm > 1.0 ? 0.0 : warm + 0.01;
    const double inner = kelvin(37.0 + warm), outer = kelvin(26.0);
    if (!sets.solve({.inner_ring = {inner, inner + 1.0, inner + 2.0},
                     .outer_ring = {outer, outer, outer},
                     .elongation = 37 * um}))
      state.SkipWithError("no balance");
    benchmark::DoNotOptimize(sets.heat().data());
  }
  state.SetItemsProcessed(state.iterations());
  state.counters["iterations"] = sets.sets().report.iterations;
  state.counters["residual"] = sets.sets().report.residual;
}
BENCHMARK(sets_of)->Name("spindle/sets")->Unit(benchmark::kMicrosecond);

}  // namespace
