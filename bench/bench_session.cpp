#include <benchmark/benchmark.h>

#include <cmath>
#include <string>
#include <vector>

#include "files/catalogue_file.h"
#include "files/model_file.h"
#include "files/spindle_record.h"
#include "files/subject.h"
#include "loop/loop.h"
#include "model/prediction.h"
#include "session/solve_states.h"
#include "tests/places.h"

namespace {

using namespace raceway;

struct Silent final : session::Messages {
  void hear(const record::Note&) override {}
};

constexpr std::size_t states = 100000;

files::ModelFile model_of(friction::FrictionLaw law) {
  const auto rows = files::read_catalogues();
  return files::parse_model(files::new_model_text(files::find_bearing(rows, "S 6014 C"), law),
                            "model");
}

double speed_rpm(std::size_t i) { return 0.12 * static_cast<double>(i); }

/// The states as the library predicts them, in pieces that its callers take.
void predict_sweep(benchmark::State& state, friction::FrictionLaw law) {
  const files::ModelFile file = model_of(law);
  constexpr std::size_t piece = 256;
  std::vector<bearing::OperatingPoint> points(states);
  for (std::size_t i = 0; i < states; ++i)
    points[i] = {.speed = speed_rpm(i) * rpm, .axial_load = 500.0};
  double sum = 0.0;
  for (auto _ : state) {
    for (std::size_t first = 0; first < states; first += piece) {
      const std::size_t count = std::min(piece, states - first);
      std::vector<model::FrictionPrediction> predictions(count);
      model::predict_sweep(file.model, std::span(points).subspan(first, count), predictions, true);
      sum += predictions.front().torque;
    }
    benchmark::DoNotOptimize(sum);
  }
  state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(states));
}
BENCHMARK_CAPTURE(predict_sweep, palmgren, friction::FrictionLaw::palmgren)
    ->Name("session/predict_sweep_palmgren")
    ->Unit(benchmark::kMillisecond)
    ->UseRealTime();
BENCHMARK_CAPTURE(predict_sweep, contact, friction::FrictionLaw::contact)
    ->Name("session/predict_sweep_contact")
    ->Unit(benchmark::kMillisecond)
    ->UseRealTime();

/// The same as Python and C ask for them, with every column.
void solve_states(benchmark::State& state, friction::FrictionLaw law) {
  const files::ModelFile file = model_of(law);
  std::vector<double> speeds(states), loads(states, 500.0);
  for (std::size_t i = 0; i < states; ++i) speeds[i] = speed_rpm(i);
  const auto array = [](const std::vector<double>& values) {
    return session::NumberArray{reinterpret_cast<const char*>(values.data()), {sizeof(double)}};
  };
  Silent silent;
  std::size_t lost = 0;
  for (auto _ : state) {
    const session::SolvedStates solved = session::solve_states(
        silent, file,
        {.shape = {states}, .speed_rpm = array(speeds), .axial_load_N = array(loads)});
    lost += solved.status.front() != bearing::SolveStatus::converged;
    benchmark::DoNotOptimize(solved.values.data());
  }
  state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(states));
  state.counters["without_balance"] = static_cast<double>(lost);
}
BENCHMARK_CAPTURE(solve_states, palmgren, friction::FrictionLaw::palmgren)
    ->Name("session/solve_states_palmgren")
    ->Unit(benchmark::kMillisecond)
    ->UseRealTime();
BENCHMARK_CAPTURE(solve_states, contact, friction::FrictionLaw::contact)
    ->Name("session/solve_states_contact")
    ->Unit(benchmark::kMillisecond)
    ->UseRealTime();

/// The diagnosis of a record of data/spindles: 480 rows, six channels, some 35 effects, with pairs
/// where single effects do not suffice.
void diagnose_spindle(benchmark::State& state, const std::string& name) {
  const std::string folder = tests::source_dir() + ("/data/spindles/" + name);
  const files::ModelFile file = files::read_model(folder + "/model.toml");
  const auto subject = files::make_subject(file.model);
  const record::Record record =
      files::read_spindle_record(folder + "/train.csv", *file.model.spindle);
  int tried = 0;
  for (auto _ : state) tried = loop::diagnose(*subject, record, {}).candidates_tried;
  state.SetItemsProcessed(state.iterations());
  state.counters["candidates"] = tried;
}
BENCHMARK_CAPTURE(diagnose_spindle, clean, "clean")
    ->Name("session/diagnose_spindle/clean")
    ->Unit(benchmark::kMillisecond)
    ->MeasureProcessCPUTime();
BENCHMARK_CAPTURE(diagnose_spindle, drive, "drive")
    ->Name("session/diagnose_spindle/drive")
    ->Unit(benchmark::kMillisecond)
    ->MeasureProcessCPUTime();

}  // namespace
