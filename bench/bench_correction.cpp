#include <benchmark/benchmark.h>
#include <tbb/global_control.h>

#include <cmath>
#include <random>
#include <string>

#include "correction/correction_subject.h"
#include "correction/identify.h"
#include "files/correction_file.h"
#include "files/series_file.h"
#include "loop/loop.h"
#include "record/series_channel.h"
#include "tests/places.h"

namespace {

using namespace raceway;
using record::Channel;

/// A model of data/corrections with its record of a day, a row every 30 s.
struct Machine {
  correction::Model model;
  record::Record data;
};

Machine read_machine(const std::string& name) {
  const std::string folder = tests::source_dir() + "/data/corrections/" + name + "/";
  correction::Model model = files::read_correction(folder + "correction.toml").models.front();
  record::Record data = files::read_series(folder + "train.csv", {model.displacement}, {});
  return {std::move(model), std::move(data)};
}

void verdict(benchmark::State& state, const std::string& name, bool pairs) {
  const tbb::global_control one_core(tbb::global_control::max_allowed_parallelism, 1);
  const Machine machine = read_machine(name);
  const correction::CorrectionSubject subject(machine.model);
  verdict::DiagnoseOptions options;
  options.pairs = pairs;
  for (auto _ : state) {
    const verdict::Diagnosis d = loop::diagnose(subject, machine.data, options);
    benchmark::DoNotOptimize(&d);
  }
  state.SetItemsProcessed(state.iterations());
  state.counters["rows"] = static_cast<double>(machine.data.rows());
}

double speed_at(double time) {
  constexpr double speeds[] = {4000, 9000, 0, 6500, 2000, 0, 8000, 3000};
  return speeds[static_cast<std::size_t>(time / 7200.0) % 8];
}

/// Bodies of a spindle that follow its speed, and a room that swings; 34 h of them. The front
/// bearing and the room move it.
Machine made_machine(double step) {
  constexpr double duration = 34.0 * 3600.0;
  constexpr std::array bodies{std::pair{"front", 900.0}, std::pair{"rear", 1500.0},
                              std::pair{"motor", 600.0}, std::pair{"base", 9000.0}};
  Machine machine;
  std::vector<double> time, speed, room, displacement;
  std::vector<std::vector<double>> temperature(bodies.size());
  std::vector<double> now(bodies.size(), 20.0);
  std::mt19937_64 random(1);
  std::normal_distribution<double> noise(0.0, 0.3);
  double slow = 0.0, fast = 0.0;
  for (double t = 0.0; t <= duration; t += step) {
    time.push_back(t);
    speed.push_back(speed_at(t) * rpm);
    room.push_back(kelvin(20.0 + 2.0 * std::sin(t / 14000.0)));
    const double heat = 25.0 * std::pow(speed_at(t) / 10000.0, 1.3);
    for (std::size_t b = 0; b < bodies.size(); ++b) {
      now[b] += (20.0 + heat - now[b]) * -std::expm1(-step / bodies[b].second);
      temperature[b].push_back(kelvin(now[b]));
    }
    slow += (5.0 * (now[0] - 20.0) - slow) * -std::expm1(-step / 5400.0);
    fast += (3.0 * (now[0] - 20.0) - fast) * -std::expm1(-step / 900.0);
    displacement.push_back((slow + fast - 1.5 * (celsius(room.back()) - 20.0) + noise(random)) *
                           um);
  }
  const auto set = [&](const std::string& name, std::vector<double> values) {
    machine.data.set(*record::series_channel(name), std::move(values));
  };
  machine.data.set(record::time, std::move(time));
  machine.data.set(record::speed, std::move(speed));
  for (std::size_t b = 0; b < bodies.size(); ++b)
    set(std::string(bodies[b].first) + "_temperature_C", std::move(temperature[b]));
  set("ambient_temperature_C", std::move(room));
  set("displacement_z_um", std::move(displacement));
  machine.model.displacement = record::series_channel("displacement_z_um");
  machine.model.tolerance = 1.0 * um;
  machine.model.measured_std = 0.3 * um;
  for (const char* name : {"front", "ambient"}) {
    const Channel* const column = record::series_channel(std::string(name) + "_temperature_C");
    machine.model.channels.push_back(
        {.name = name, .input = {.columns = {column}}, .sections = {{1e-6, 3000.0}}});
  }
  return machine;
}

void identify(benchmark::State& state, double step) {
  const tbb::global_control one_core(tbb::global_control::max_allowed_parallelism, 1);
  const Machine machine = made_machine(step);
  double error = 0.0;
  for (auto _ : state) {
    const correction::Identification found = correction::identify(machine.model, machine.data);
    error = found.rms_held_out;
    if (!found.converged()) state.SkipWithError("not converged");
  }
  state.SetItemsProcessed(state.iterations());
  state.counters["rows"] = static_cast<double>(machine.data.rows());
  state.counters["held_out_um"] = error / um;
}

const bool registered = [] {
  const auto add = [](const std::string& name, auto run) {
    benchmark::RegisterBenchmark(name.c_str(), run)->Unit(benchmark::kMillisecond);
  };
  for (const int step : {30, 10, 3, 1})
    add("identify/34h_at_" + std::to_string(step) + "s",
        [=](benchmark::State& state) { identify(state, step); });
  add("verdict/24h_singles", [](benchmark::State& state) { verdict(state, "ambient", false); });
  add("verdict/24h_two_effects_singles",
      [](benchmark::State& state) { verdict(state, "power", false); });
  add("verdict/24h_pairs", [](benchmark::State& state) { verdict(state, "power", true); });
  return true;
}();

}  // namespace
