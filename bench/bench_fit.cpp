#include <benchmark/benchmark.h>
#include <tbb/global_control.h>

#include <cmath>
#include <memory>
#include <random>
#include <string>
#include <vector>

#include "effects/catalogue.h"
#include "files/data_file.h"
#include "files/model_file.h"
#include "files/subject.h"
#include "loop/loop.h"
#include "model/base_laws.h"
#include "tests/places.h"

namespace {

using namespace raceway;

/// 120 rows of a rig with a hidden effect.
struct Rig {
  model::Model model;
  record::Record data;
};

Rig read_rig(const std::string& name) {
  const std::string folder = tests::source_dir() + "/tests/hidden_effect/rigs/" + name + "/";
  model::Model model = files::read_model(folder + "model.toml").model;
  record::Record data = files::read_record(folder + "train.csv", *files::make_subject(model));
  return {std::move(model), std::move(data)};
}

void add_effect(model::Model& model, std::string_view id, double size) {
  model.effects.push_back({effects::find(id), {size}});
}

/// That rig measured at `rows` random points: what spin friction adds is not in the model, readings
/// scatter by 1 %.
Rig measured_rig(std::size_t rows) {
  Rig rig{read_rig("dev-03").model, {}};
  model::Model truth = rig.model;
  add_effect(truth, "spin-friction", 0.06);
  std::mt19937_64 random(1);
  const auto between = [&](double lower, double upper) {
    return lower + (upper - lower) * std::generate_canonical<double, 53>(random);
  };
  std::vector<double> speed, load, temperature;
  for (std::size_t i = 0; i < rows; ++i) {
    speed.push_back(between(500, 16000) * rpm);
    load.push_back(between(250, 3000));
    temperature.push_back(kelvin(between(25, 65)));
  }
  rig.data.set(record::speed, std::move(speed));
  rig.data.set(record::axial_load, std::move(load));
  rig.data.set(record::radial_load, std::vector<double>(rows, 0.0));
  rig.data.set(record::temperature, std::move(temperature));
  std::normal_distribution<double> scatter(0.0, 0.01);
  std::vector<double> readings = fit::predict(*files::make_subject(truth), rig.data);
  for (double& reading : readings) reading *= 1.0 + scatter(random);
  rig.data.set(record::friction_torque, std::move(readings));
  return rig;
}

/// 72 rows whose torque follows Palmgren's law, of a model with the contact law: what a user meets
/// who begins with `raceway new`.
Rig rig_of_another_law() {
  const model::Model truth = read_rig("dev-03").model;
  Rig rig{model::with_law(truth, friction::FrictionLaw::contact), {}};
  std::vector<double> speed, load, temperature;
  for (const double celsius : {30.0, 45.0, 60.0})
    for (const double force : {200.0, 500.0, 900.0, 1500.0})
      for (const double n : {300.0, 1000.0, 2500.0, 5000.0, 8000.0, 12000.0}) {
        speed.push_back(n * rpm);
        load.push_back(force);
        temperature.push_back(kelvin(celsius));
      }
  const std::size_t rows = speed.size();
  rig.data.set(record::speed, std::move(speed));
  rig.data.set(record::axial_load, std::move(load));
  rig.data.set(record::radial_load, std::vector<double>(rows, 0.0));
  rig.data.set(record::temperature, std::move(temperature));
  std::mt19937_64 random(1);
  std::normal_distribution<double> scatter(0.0, 0.01);
  std::vector<double> readings = fit::predict(*files::make_subject(truth), rig.data);
  for (double& reading : readings) reading *= 1.0 + scatter(random);
  rig.data.set(record::friction_torque, std::move(readings));
  return rig;
}

void diagnose(benchmark::State& state, const Rig& rig, const verdict::DiagnoseOptions& options) {
  const tbb::global_control one_core(tbb::global_control::max_allowed_parallelism, 1);
  const auto subject = files::make_subject(rig.model);
  for (auto _ : state) {
    const verdict::Diagnosis d = loop::diagnose(*subject, rig.data, options);
    benchmark::DoNotOptimize(&d);
  }
  state.SetItemsProcessed(state.iterations());
  state.counters["rows"] = static_cast<double>(rig.data.rows());
}

/// f0, z and the spin friction coefficient; `offset` frees an error of the load as well, which
/// moves the balance of every row.
void calibrate(benchmark::State& state, std::size_t rows, bool offset, std::size_t threads) {
  const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, threads);
  Rig rig = measured_rig(rows);
  add_effect(rig.model, "spin-friction", 0.03);
  rig.model.free.push_back("spin-friction.friction_coefficient");
  if (offset) {
    add_effect(rig.model, "load-offset", 1.0);
    rig.model.free.push_back("load-offset.force_N");
  }
  const auto subject = files::make_subject(rig.model);
  int steps = 0;
  for (auto _ : state) {
    const verdict::Calibration c = loop::calibrate(*subject, rig.data);
    if (!c.converged()) state.SkipWithError("not converged");
    steps = c.iterations;
  }
  state.SetItemsProcessed(state.iterations());
  state.counters["rows"] = static_cast<double>(rows);
  state.counters["iterations"] = steps;
}

/// 120 rows of a shaft: 30 speeds at each of four preloads.
record::Record rows_of_a_shaft() {
  std::vector<double> speed, preload;
  for (const double force : {300.0, 600.0, 900.0, 1200.0})
    for (int i = 1; i <= 30; ++i) {
      speed.push_back(10000.0 / 30.0 * i * rpm);
      preload.push_back(force);
    }
  record::Record data;
  const std::size_t rows = speed.size();
  data.set(record::speed, std::move(speed));
  data.set(record::axial_load, std::vector<double>(rows, 0.0));
  data.set(record::radial_load, std::vector<double>(rows, 0.0));
  data.set(record::temperature, std::vector<double>(rows, kelvin(40)));
  data.set(record::preload, std::move(preload));
  return data;
}

/// One evaluation of measured displacement with a parameter that moves every balance: what a fit
/// does some thirty times.
void displacement_response(benchmark::State& state) {
  const auto subject = files::make_subject(
      files::read_model(tests::source_dir() + "/data/spindles/two_against_one.toml").model);
  const record::Record data = rows_of_a_shaft();
  const auto prepared = subject->prepare(data);
  const auto predictor = subject->predictor(data, {"contact_angle_deg"}, prepared);
  std::vector<double> readings(subject->measured().size() * data.rows());
  double angle = 24.9, sum = 0.0;
  for (auto _ : state) {
    angle = angle < 25.0 ? 25.1 : 24.9;
    predictor->readings({&angle, 1}, readings);
    for (const double r : readings) sum += r;
  }
  benchmark::DoNotOptimize(sum);
  if (!std::isfinite(sum)) state.SkipWithError("a row has no balance");
  state.counters["rows"] = static_cast<double>(data.rows());
}

std::string rows_name(std::size_t rows) {
  return rows == 100000 ? "100k_rows" : std::to_string(rows) + "_rows";
}

const bool registered = [] {
  const auto add = [](const std::string& name, auto run) {
    return benchmark::RegisterBenchmark(name.c_str(), run)->Unit(benchmark::kMillisecond);
  };
  const auto of_rig = [&](const std::string& name, const char* rig, bool pairs) {
    add(name, [=](benchmark::State& state) { diagnose(state, read_rig(rig), {.pairs = pairs}); });
  };
  // One hidden effect: no pair is asked for.
  of_rig("diagnose/120_rows", "dev-03", true);
  of_rig("diagnose/120_rows_singles", "dev-03", false);
  // Two hidden effects, and one outside the catalogue: all pairs, then bent laws.
  of_rig("diagnose/120_rows_pairs", "dev-06", true);
  of_rig("diagnose/120_rows_unknown", "dev-07", true);
  add("diagnose/72_rows_wrong_law",
      [](benchmark::State& state) { diagnose(state, rig_of_another_law(), {}); });
  for (const std::size_t rows : {1000u, 10000u, 100000u})
    add("diagnose/" + rows_name(rows),
        [=](benchmark::State& state) { diagnose(state, measured_rig(rows), {}); });
  for (const std::size_t count : {4u, 8u, 16u})
    add("grow/candidates_" + std::to_string(count), [=](benchmark::State& state) {
      verdict::DiagnoseOptions options;
      for (const effects::Description& d : effects::catalogue().first(count))
        options.candidates.emplace_back(d.id);
      diagnose(state, measured_rig(1000), options);
    });
  for (const std::size_t rows : {120u, 1000u, 10000u, 100000u}) {
    const std::string name = "calibrate/" + rows_name(rows);
    add(name, [=](benchmark::State& state) { calibrate(state, rows, false, 1); });
    if (rows == 120 || rows == 10000)
      add(name + "_moved", [=](benchmark::State& state) { calibrate(state, rows, true, 1); });
  }
  add("calibrate/10000_rows_moved_2_threads", [](benchmark::State& state) {
    calibrate(state, 10000, true, 2);
  })->UseRealTime();
  benchmark::RegisterBenchmark("displacement_response/120_rows", displacement_response)
      ->Unit(benchmark::kMicrosecond);
  return true;
}();

}  // namespace
