#include <benchmark/benchmark.h>
#include <tbb/global_control.h>

#include <cmath>
#include <stdexcept>
#include <string>
#include <variant>

#include "fit/diagnose.h"
#include "fit/response.h"
#include "io/data_file.h"
#include "io/model_file.h"

namespace {

using namespace raceway;

/// 120 rows of a rig with a hidden effect.
struct Rig {
  fit::Model model;
  fit::DataSet data;
};

Rig read_rig() {
  const std::string folder = RACEWAY_SOURCE_DIR "/tests/hidden_effect/rigs/dev-03/";
  io::ModelFile file = io::read_model(folder + "model.toml");
  io::Measurement data = io::read_measurement(folder + "train.csv", file.model.rig);
  return {std::move(file.model), std::get<fit::DataSet>(std::move(data))};
}

void diagnose(benchmark::State& state, bool pairs) {
  const tbb::global_control one_core(tbb::global_control::max_allowed_parallelism, 1);
  const Rig rig = read_rig();
  fit::DiagnoseOptions options;
  options.pairs = pairs;
  for (auto _ : state) {
    const fit::Diagnosis d = fit::diagnose(rig.model, rig.data, options);
    benchmark::DoNotOptimize(&d);
  }
  state.SetItemsProcessed(state.iterations());
  state.counters["rows"] = static_cast<double>(rig.data.rows.size());
}
BENCHMARK_CAPTURE(diagnose, pairs, true)->Name("diagnose/120_rows")->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(diagnose, singles, false)
    ->Name("diagnose/120_rows_singles")
    ->Unit(benchmark::kMillisecond);

/// One evaluation of 120 rows of measured displacement, at four preloads, with a parameter that
/// moves every balance: what a fit does some thirty times.
void displacement_response(benchmark::State& state) {
  const fit::Model model =
      io::read_model(RACEWAY_SOURCE_DIR "/data/spindles/two_against_one.toml").model;
  fit::DataSet data;
  data.quantity = fit::Quantity::axial_displacement;
  for (const double preload : {300.0, 600.0, 900.0, 1200.0})
    for (int i = 1; i <= 30; ++i)
      data.rows.push_back(
          {.point = {.speed = 10000.0 / 30.0 * i * rpm, .axial_load = 0.0}, .preload = preload});
  const fit::Response response = fit::model_response(model, data, {"contact_angle_deg"});
  Eigen::VectorXd x = response.start();
  double sum = 0.0;
  for (auto _ : state) {
    x[0] = x[0] < 25.0 ? 25.1 : 24.9;
    sum += response.readings(x).sum();
  }
  benchmark::DoNotOptimize(sum);
  if (!std::isfinite(sum)) state.SkipWithError("a row has no balance");
  state.counters["rows"] = static_cast<double>(data.rows.size());
}
BENCHMARK(displacement_response)
    ->Name("displacement_response/120_rows")
    ->Unit(benchmark::kMicrosecond);

}  // namespace
