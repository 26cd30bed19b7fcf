#include "spindle/step_response.h"

#include <fmt/format.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <stdexcept>

namespace raceway::spindle {
namespace {

/// Rows of one speed, from `from` on [s]; the first at `from` itself where that is 0.
void add_step_rows(std::vector<ProfileRow>& profile, double from, const StepOptions& options,
                   double speed) {
  ProfileRow row{.time = from, .inputs = options.inputs};
  row.inputs.speed = speed;
  if (from == 0.0) profile.push_back(row);
  const auto rows = static_cast<int>(std::round(options.duration / options.row));
  for (int k = 1; k <= rows; ++k) {
    row.time = from + k * options.row;
    profile.push_back(row);
  }
}

/// From the end of a step, by rows of a spindle that stands since `begin` [s].
CoolDown cool_down_of(const StepResponse& step, std::span<const Moment> moments, double begin) {
  CoolDown down;
  std::vector<double> time, left, way;
  for (const Moment& m : moments) {
    time.push_back(m.time - begin);
    left.push_back(m.thermal_displacement());
    way.push_back(step.end - left.back());
  }
  down.fit = fit_step(time, way);
  const StepFit& fit = step.fit;
  down.one = fit_decay(time, left, std::array{fit.one.gain}).front();
  if (std::isnan(fit.slow.gain)) return down;
  const std::vector<double> two = fit_decay(time, left, std::array{fit.fast.gain, fit.slow.gain});
  down.fast = two[0];
  down.slow = two[1];
  return down;
}

/// Powers, forces and status of a run.
StepResponse response_of(const Run& run, double speed) {
  StepResponse step{.speed = speed, .status = run.report.status, .message = run.report.message};
  if (!step.converged()) {
    if (step.message.empty()) step.message = words(step.status);
    return step;
  }
  const Moment &first = run.moments.front(), &last = run.moments.back();
  step.power_start = first.heat.friction;
  step.power_end = last.heat.friction;
  step.front_force = first.front_force;
  step.highest_force = run.highest_front_force;
  for (const Moment& m : run.moments) step.time.push_back(m.time);
  return step;
}

StepResponse step_of(const Run& run, double speed) {
  StepResponse step = response_of(run, speed);
  if (!step.converged()) return step;
  step.kinematic = run.moments.back().kinematic_displacement;
  step.end = run.moments.back().thermal_displacement();
  for (const Moment& m : run.moments) step.displacement.push_back(m.thermal_displacement());
  step.fit = fit_step(step.time, step.displacement);
  return step;
}

/// From a settled spindle. What is there at once is no lag, in the warm sets as they are.
StepResponse load_step_of(const Run& run, double speed, const Moment& unloaded) {
  StepResponse step = response_of(run, speed);
  if (!step.converged()) return step;
  const double at_once = run.moments.front().displacement;
  step.kinematic = at_once - unloaded.displacement;
  step.end = run.moments.back().displacement - at_once;
  for (const Moment& m : run.moments) step.displacement.push_back(m.displacement - at_once);
  step.fit = fit_step(step.time, step.displacement);
  return step;
}

Inputs with_load(Inputs inputs, Stepped stepped, double load) {
  (stepped == Stepped::radial_load ? inputs.radial_load : inputs.axial_load) = load;
  return inputs;
}

// In the time of one row of a step from rest: a load heats the balls themselves, within minutes.
constexpr double rows_of_loads = 4.0;

/// All loads at one speed, and how the spindle settles when the largest has gone.
LoadSteps loads_at(Simulator& simulator, Stepped stepped, double speed,
                   std::span<const double> loads, const StepOptions& options) {
  LoadSteps result{.stepped = stepped, .speed = speed};
  StepOptions at = options;
  at.row /= rows_of_loads;
  at.inputs.speed = speed;
  Report report;
  const Moment unloaded = simulator.steady(at.inputs, report);
  const State start = report.converged() ? simulator.state() : State{};
  const auto largest = std::max_element(
      loads.begin(), loads.end(), [](double a, double b) { return std::abs(a) < std::abs(b); });
  for (auto load = loads.begin(); load != loads.end(); ++load) {
    Run run{.report = report};
    std::vector<ProfileRow> profile;
    StepOptions loaded = at;
    loaded.inputs = with_load(at.inputs, stepped, *load);
    add_step_rows(profile, 0.0, loaded, speed);
    if (report.converged()) run = simulator.simulate(profile, &start);
    StepResponse step = load_step_of(run, speed, unloaded);
    step.stepped = stepped;
    step.load = *load;
    if (load == largest && step.converged()) {
      profile.clear();
      add_step_rows(profile, run.end.time, at, speed);
      const Run back = simulator.simulate(profile, &run.end);
      std::vector<double> time, left;
      for (const Moment& m : back.moments) {
        time.push_back(m.time - run.end.time);
        left.push_back(m.displacement - unloaded.displacement);
      }
      if (back.report.converged())
        result.unloaded = fit_decay(time, left, std::array{step.fit.one.gain}).front();
    }
    result.steps.push_back(std::move(step));
  }
  return result;
}

void check_step_options(std::span<const double> speeds, const StepOptions& options) {
  for (const double speed : speeds)
    if (!(speed > 0.0) || !std::isfinite(speed))
      throw std::invalid_argument(
          fmt::format("speed = {:.6g} rpm: must be above 0 rpm for a step", speed / rpm));
  if (!(options.row > 0.0) || !(options.duration >= 3.0 * options.row))
    throw std::invalid_argument(fmt::format(
        "duration {:.6g} s with a row every {:.6g} s: a step response needs at least three rows",
        options.duration, options.row));
}

}  // namespace

StepResponses step_responses(const model::Model& model, std::span<const double> speeds,
                             const StepOptions& options) {
  check_step_options(speeds, options);
  StepResponses result;
  result.steps.resize(speeds.size());
  const auto fastest =
      static_cast<std::size_t>(std::max_element(speeds.begin(), speeds.end()) - speeds.begin());
  Simulator simulator(model);
  simulator.stop_on(options.cancelled);
  tbb::parallel_for(std::size_t{0}, speeds.size(), [&](std::size_t k) {
    Simulator own = simulator;
    std::vector<ProfileRow> profile;
    add_step_rows(profile, 0.0, options, speeds[k]);
    const Run run = own.simulate(profile);
    result.steps[k] = step_of(run, speeds[k]);
    if (!options.cool_down || k != fastest || !run.report.converged()) return;
    profile.clear();
    add_step_rows(profile, run.end.time, options, 0.0);
    const Run down = own.simulate(profile, &run.end);
    if (!down.report.converged()) return;
    result.cool_down = cool_down_of(result.steps[k], down.moments, run.end.time);
  });
  return result;
}

std::vector<LoadSteps> load_step_responses(const model::Model& model, Stepped stepped,
                                           std::span<const double> speeds,
                                           std::span<const double> loads,
                                           const StepOptions& options) {
  check_step_options(speeds, options);
  if (std::adjacent_find(loads.begin(), loads.end(), std::greater_equal<>()) != loads.end())
    throw std::invalid_argument("the load steps must be in ascending order, without duplicates");
  for (const double load : loads)
    if (load == 0.0 || !std::isfinite(load))
      throw std::invalid_argument(
          fmt::format("load = {:.6g} N: a load step needs a finite load other than 0", load));
  std::vector<LoadSteps> result(speeds.size());
  Simulator simulator(model);
  simulator.stop_on(options.cancelled);
  tbb::parallel_for(std::size_t{0}, speeds.size(), [&](std::size_t k) {
    Simulator own = simulator;
    result[k] = loads_at(own, stepped, speeds[k], loads, options);
  });
  return result;
}

std::vector<LagAt> at_loads(const LoadSteps& loads) {
  std::vector<LagAt> points;
  for (const StepResponse& step : loads.steps)
    if (step.converged() && std::isfinite(step.fit.one.gain))
      points.push_back({step.load, step.fit.one.gain, step.fit.one.time_constant});
  return points;
}

std::vector<LagAt> at_powers(std::span<const StepResponse> steps, WhichLag which) {
  std::vector<LagAt> points;
  for (const StepResponse& step : steps) {
    const Lag& lag = which == WhichLag::one    ? step.fit.one
                     : which == WhichLag::fast ? step.fit.fast
                                               : step.fit.slow;
    if (step.converged() && std::isfinite(lag.gain))
      points.push_back({step.power_end, lag.gain, lag.time_constant});
  }
  return points;
}

bool need_two(std::span<const StepResponse> steps) {
  bool needed = false;
  for (const StepResponse& step : steps) {
    if (!step.converged()) continue;
    if (std::isnan(step.fit.slow.gain)) return false;
    needed = needed || step.fit.two_needed;
  }
  return needed;
}

}  // namespace raceway::spindle
