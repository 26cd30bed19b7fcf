#include <benchmark/benchmark.h>
#include <tbb/global_control.h>

#include <stdexcept>
#include <string>
#include <variant>

#include "fit/diagnose.h"
#include "io/data_file.h"
#include "io/model_file.h"

namespace {

using namespace raceway;

/// 120 rows of a rig with a hidden effect.
struct Rig {
  fit::Model model;
  fit::DataSet data;
};

Rig read_rig(const std::string& name) {
  const std::string folder = RACEWAY_SOURCE_DIR "/tests/hidden_effect/rigs/" + name + "/";
  io::ModelFile file = io::read_model(folder + "model.toml");
  io::Measurement data = io::read_measurement(folder + "train.csv", file.model.rig);
  return {std::move(file.model), std::get<fit::DataSet>(std::move(data))};
}

void diagnose(benchmark::State& state, const std::string& name, bool pairs) {
  const tbb::global_control one_core(tbb::global_control::max_allowed_parallelism, 1);
  const Rig rig = read_rig(name);
  fit::DiagnoseOptions options;
  options.pairs = pairs;
  for (auto _ : state) {
    const fit::Diagnosis d = fit::diagnose(rig.model, rig.data, options);
    benchmark::DoNotOptimize(&d);
  }
  state.SetItemsProcessed(state.iterations());
  state.counters["rows"] = static_cast<double>(rig.data.rows.size());
}
// One hidden effect: no pair is asked for.
BENCHMARK_CAPTURE(diagnose, usual, "dev-03", true)
    ->Name("diagnose/120_rows")
    ->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(diagnose, singles, "dev-03", false)
    ->Name("diagnose/120_rows_singles")
    ->Unit(benchmark::kMillisecond);
// Two hidden effects, and one outside the catalogue: all pairs, then bent laws.
BENCHMARK_CAPTURE(diagnose, pairs, "dev-06", true)
    ->Name("diagnose/120_rows_pairs")
    ->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(diagnose, unknown, "dev-07", true)
    ->Name("diagnose/120_rows_unknown")
    ->Unit(benchmark::kMillisecond);

}  // namespace
