#include <benchmark/benchmark.h>
#include <tbb/global_control.h>
#include <tbb/parallel_for.h>

#include <array>
#include <atomic>
#include <cmath>
#include <mutex>

#include "effects/catalogue.h"
#include "friction/contact/balanced_equilibrium.h"
#include "friction/contact/contact_friction.h"
#include "friction/contact/many_contacts.h"
#include "friction/stribeck_table.h"
#include "model/base_laws.h"
#include "model/prediction.h"

namespace {

using namespace raceway;

model::Model spindle_model(bool with_spin) {
  model::Model model{.name = "7014",
                     .bearing = bearing::Bearing({.ball_count = 20,
                                                  .ball_diameter = 11.906 * mm,
                                                  .pitch_diameter = 90 * mm,
                                                  .contact_angle = 25 * degree,
                                                  .inner_conformity = 0.52,
                                                  .outer_conformity = 0.52,
                                                  .static_load_rating = 43000},
                                                 bearing::steel(), bearing::steel()),
                     .lubricant = friction::Lubricant(22 * mm2_per_s, 4.8 * mm2_per_s),
                     .law = friction::FrictionLaw::palmgren,
                     .law_values = {1.5, 0.001, 0.33},
                     .effects = {},
                     .solver = {},
                     .rig = {},
                     .free = {}};
  if (with_spin) model.effects.push_back({effects::find("spin-friction"), {0.06}});
  return model;
}

friction::TableAxes axes_of_1000_points(bool radial) {
  friction::TableAxes axes;
  for (int i = 1; i <= 20; ++i) axes.speed.push_back(600.0 * i * rpm);
  for (int i = 1; i <= 10; ++i) axes.axial_load.push_back(150.0 * i);
  for (int i = 0; i < 5; ++i) axes.temperature.push_back(kelvin(30.0 + 10.0 * i));
  axes.radial_load = {radial ? 50.0 : 0.0};
  return axes;
}

/// A table with contact angles and the spin torque, on one core.
void table_of_1000_points(benchmark::State& state, bool radial) {
  const tbb::global_control one_core(tbb::global_control::max_allowed_parallelism, 1);
  const model::Model model = spindle_model(true);
  const friction::TableAxes axes = axes_of_1000_points(radial);
  double iterations = 0.0, residual = 0.0;
  for (auto _ : state) {
    iterations = residual = 0.0;
    const auto table = friction::build_stribeck_table(
        axes, {"inner_contact_angle_deg"}, [&](auto points, auto out) {
          std::vector<model::FrictionPrediction> p(points.size());
          model::predict_sweep(model, points, p, true);
          for (std::size_t i = 0; i < p.size(); ++i) {
            out[i].status = p[i].report.status;
            out[i].friction_moment = p[i].torque;
            out[i].columns[0] = p[i].equilibrium->balls[0].inner_contact_angle;
            iterations += p[i].report.iterations;
            residual = std::fmax(residual, p[i].report.residual);
          }
        });
    benchmark::DoNotOptimize(table.friction_moment.data());
  }
  state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(axes.size()));
  state.counters["iterations"] = iterations / static_cast<double>(axes.size());
  state.counters["residual"] = residual;
}
BENCHMARK_CAPTURE(table_of_1000_points, thrust, false)
    ->Name("table/1000_thrust")
    ->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(table_of_1000_points, combined, true)
    ->Name("table/1000_combined")
    ->Unit(benchmark::kMillisecond);

/// A table as the command makes it, without the file: 100 speeds, 50 axial and 4 radial loads, 50
/// temperatures.
void table_of_a_million(benchmark::State& state, std::size_t threads) {
  const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, threads);
  const model::Model model = spindle_model(true);
  friction::TableAxes axes;
  for (int i = 1; i <= 100; ++i) axes.speed.push_back(120.0 * i * rpm);
  for (int i = 1; i <= 50; ++i) axes.axial_load.push_back(30.0 * i);
  for (int i = 0; i < 50; ++i) axes.temperature.push_back(kelvin(20.0 + i));
  axes.radial_load = {0.0, 5.0, 10.0, 15.0};
  std::atomic<long> steps = 0;
  double residual = 0.0;
  std::mutex lock;
  for (auto _ : state) {
    steps = 0;
    const auto table = friction::build_stribeck_table(
        axes, {"inner_contact_angle_deg"}, [&](auto points, auto out) {
          std::vector<model::FrictionPrediction> p(points.size());
          model::predict_sweep(model, points, p, true);
          long part = 0;
          double worst = 0.0;
          for (std::size_t i = 0; i < p.size(); ++i) {
            out[i].status = p[i].report.status;
            out[i].friction_moment = p[i].torque;
            if (p[i].equilibrium)
              out[i].columns[0] = p[i].equilibrium->balls[0].inner_contact_angle;
            part += p[i].report.iterations;
            worst = std::fmax(worst, p[i].report.residual);
          }
          steps += part;
          const std::lock_guard guard(lock);
          residual = std::fmax(residual, worst);
        });
    benchmark::DoNotOptimize(table.friction_moment.data());
  }
  state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(axes.size()));
  state.counters["iterations"] = static_cast<double>(steps) / static_cast<double>(axes.size());
  state.counters["residual"] = residual;
}
BENCHMARK_CAPTURE(table_of_a_million, one, 1)->Name("table/1e6")->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(table_of_a_million, two, 2)
    ->Name("table/1e6_2_threads")
    ->Unit(benchmark::kMillisecond)
    ->UseRealTime();

/// A million points of the contact law, without writing the file.
void contact_table_of_a_million(benchmark::State& state) {
  const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, 2);
  const model::Model model = model::with_law(spindle_model(false), friction::FrictionLaw::contact);
  for (auto _ : state)
    tbb::parallel_for(0, 1000000 / 256, [&](int piece) {
      std::vector<bearing::OperatingPoint> given(256);
      std::vector<model::FrictionPrediction> p(256);
      for (int i = 0; i < 256; ++i) {
        const int k = 256 * piece + i;
        given[static_cast<std::size_t>(i)] = {.speed = 120.0 * (1 + k % 100) * rpm,
                                              .axial_load = 30.0 * (1 + k / 100 % 50),
                                              .radial_load = 5.0 * (k / 5000 % 4),
                                              .temperature = kelvin(20.0 + k / 20000)};
      }
      model::predict_sweep(model, given, p, true);
      benchmark::DoNotOptimize(p.data());
    });
  state.SetItemsProcessed(state.iterations() * 1000000);
}
BENCHMARK(contact_table_of_a_million)
    ->Name("table/1e6_contact")
    ->Unit(benchmark::kMillisecond)
    ->UseRealTime();

void laws_only(benchmark::State& state) {
  const model::Model model = spindle_model(false);
  const bearing::OperatingPoint point{.speed = 10000 * rpm, .axial_load = 600};
  for (auto _ : state) benchmark::DoNotOptimize(model::predict_friction(model, point).torque);
  state.SetItemsProcessed(state.iterations());
}
BENCHMARK(laws_only)->Name("friction/palmgren");

/// Friction of the contacts of one point in balance, without the balance. Next to the time the
/// largest |torque change| of a thousandth more speed off that of half as much [1]: its smoothness.
struct ContactPoint {
  bearing::BearingEquilibrium equilibrium;
  friction::contact::OilState oil;
  double speed, temperature;
};

std::vector<ContactPoint> contact_points(const bearing::Bearing& bearing, double radial_load) {
  const friction::Lubricant lubricant(22 * mm2_per_s, 4.8 * mm2_per_s);
  std::vector<ContactPoint> points;
  for (const double n : {100.0, 1000.0, 3000.0, 6000.0, 10000.0, 16000.0})
    for (const double celsius : {25.0, 40.0, 60.0})
      points.push_back(
          {bearing::solve_bearing_equilibrium(
               bearing, {.speed = n * rpm, .axial_load = 800, .radial_load = radial_load}),
           friction::contact::oil_state(lubricant, {}, kelvin(celsius)), n * rpm, kelvin(celsius)});
  return points;
}

void contacts(benchmark::State& state, double radial_load) {
  const model::Model model = spindle_model(false);
  const std::vector<ContactPoint> points = contact_points(model.bearing, radial_load);
  const friction::contact::ContactLaw law;
  double sum = 0.0;
  for (auto _ : state) {
    sum = 0.0;
    for (const ContactPoint& p : points)
      sum += friction::contact::bearing_friction(model.bearing, p.equilibrium,
                                                 bearing::RaceControl::outer, p.speed, p.oil, law)
                 .moment();
    benchmark::DoNotOptimize(sum);
  }
  state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(points.size()));
  state.counters["us_per_point"] = benchmark::Counter(
      static_cast<double>(points.size()) * 1e-6,
      benchmark::Counter::kIsIterationInvariantRate | benchmark::Counter::kInvert);
  state.counters["torque_Nmm"] = sum / N_mm / static_cast<double>(points.size());
}
BENCHMARK_CAPTURE(contacts, thrust, 0.0)->Name("contact/thrust");
BENCHMARK_CAPTURE(contacts, combined, 300.0)->Name("contact/combined");

/// The balance of one point whose balls no race holds. Next to the time what the last rotations
/// would change of the forces, of the load on a ball [1].
void balanced(benchmark::State& state, double radial_load) {
  const bearing::Bearing bearing = spindle_model(false).bearing;
  const friction::contact::OilState oil = friction::contact::oil_state(
      friction::Lubricant(22 * mm2_per_s, 4.8 * mm2_per_s), {}, kelvin(40));
  constexpr std::array speeds{1000.0, 4000.0, 8000.0, 12000.0, 16000.0};
  double residual = 0.0;
  for (auto _ : state)
    for (const double n : speeds) {
      const auto e = friction::contact::solve_balanced_equilibrium(
          bearing, {.speed = n * rpm, .axial_load = 500, .radial_load = radial_load}, oil, {});
      if (!e.report.converged()) state.SkipWithError("no balance");
      residual = std::fmax(residual, e.report.residual);
    }
  state.counters["us_per_point"] =
      benchmark::Counter(1e-6 * static_cast<double>(state.iterations()) * speeds.size(),
                         benchmark::Counter::kIsRate | benchmark::Counter::kInvert);
  state.counters["residual"] = residual;
}
BENCHMARK_CAPTURE(balanced, thrust, 0.0)->Name("contact/balanced_thrust");
BENCHMARK_CAPTURE(balanced, combined, 300.0)->Name("contact/balanced_combined");

/// The same points side by side; beside the time the largest distance of a torque from that of one
/// at a time [1].
void contacts_in_batch(benchmark::State& state, double radial_load, bearing::InstructionSet set) {
  const model::Model model = spindle_model(false);
  const std::vector<ContactPoint> points = contact_points(model.bearing, radial_load);
  const friction::contact::ContactData data;
  const std::vector<double> values{1.0, 1.0, 0.1, 0.06, 0.0, 0.0};
  std::vector<friction::BearingState<double>> states;
  // As many as a thread takes of a table.
  while (states.size() < 256)
    for (const ContactPoint& p : points) {
      const double temperature = p.temperature;
      states.push_back({.bearing = model.bearing.ball_bearing(),
                        .equilibrium = &p.equilibrium,
                        .lubricant = &model.lubricant,
                        .contact = &data,
                        .speed = p.speed,
                        .temperature = temperature,
                        .kinematic_viscosity = model.lubricant.kinematic_viscosity(temperature)});
    }
  std::vector<friction::contact::ContactResult> results(states.size());
  for (auto _ : state) {
    friction::contact::contact_results(states, values, results, set);
    benchmark::DoNotOptimize(results.data());
  }
  double off = 0.0;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const double one = friction::contact::contact_result(states[i], values).moment();
    off = std::fmax(off, std::abs(results[i].moment() / one - 1.0));
  }
  state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(states.size()));
  state.counters["us_per_point"] = benchmark::Counter(
      static_cast<double>(states.size()) * 1e-6,
      benchmark::Counter::kIsIterationInvariantRate | benchmark::Counter::kInvert);
  state.counters["off"] = off;
}
BENCHMARK_CAPTURE(contacts_in_batch, thrust, 0.0, bearing::best_instruction_set())
    ->Name("contact/thrust_batch");
BENCHMARK_CAPTURE(contacts_in_batch, combined, 300.0, bearing::best_instruction_set())
    ->Name("contact/combined_batch");
BENCHMARK_CAPTURE(contacts_in_batch, thrust_avx2, 0.0, bearing::InstructionSet::avx2)
    ->Name("contact/thrust_batch_avx2");
BENCHMARK_CAPTURE(contacts_in_batch, combined_avx2, 300.0, bearing::InstructionSet::avx2)
    ->Name("contact/combined_batch_avx2");
BENCHMARK_CAPTURE(contacts_in_batch, thrust_sse2, 0.0, bearing::InstructionSet::sse2)
    ->Name("contact/thrust_batch_sse2");
BENCHMARK_CAPTURE(contacts_in_batch, combined_sse2, 300.0, bearing::InstructionSet::sse2)
    ->Name("contact/combined_batch_sse2");

}  // namespace
