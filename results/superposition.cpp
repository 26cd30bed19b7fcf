#include "results/superposition.h"

#include <fmt/format.h>

#include <cmath>
#include <utility>
#include <vector>

#include "correction/simulation.h"
#include "record/channel.h"
#include "spindle/record_rows.h"

namespace raceway::results {
namespace {

spindle::Inputs in_row(spindle::Inputs inputs, const spindle::Inputs& of_programme) {
  inputs.speed = of_programme.speed;
  inputs.axial_load = of_programme.axial_load;
  inputs.radial_load = of_programme.radial_load;
  return inputs;
}

/// The programme with a column of zeros for each load that the correction goes by and it lacks.
record::Record with_loads_of(const correction::Model& correction, record::Record programme) {
  for (const record::Channel* c : correction::inputs_of(correction))
    if (!programme.has(*c) && (*c == record::axial_load || *c == record::radial_load))
      programme.set(*c, std::vector<double>(programme.rows(), 0.0));
  return programme;
}

}  // namespace

Superposition superposition(const model::Model& model, const correction::Model& correction,
                            const record::Record& programme, const spindle::Inputs& inputs,
                            const std::atomic<bool>* cancelled) {
  const std::span<const double> speed = programme.values(record::speed);
  std::vector<spindle::ProfileRow> profile = spindle::profile_of(programme);
  const double begin = profile.front().time;
  for (spindle::ProfileRow& row : profile) {
    row.time -= begin;
    row.inputs = in_row(inputs, row.inputs);
  }
  spindle::Simulator simulator(model);
  simulator.stop_on(cancelled);
  const spindle::Run run = simulator.simulate(profile);
  Superposition result{.report = run.report};
  if (!run.report.converged()) return result;
  const record::Record known = with_loads_of(correction, programme);
  const correction::Series series(known);
  std::vector<double> predicted(series.rows());
  correction::simulate(correction, series, predicted);
  double squares = 0.0;
  result.rows = predicted.size();
  for (std::size_t k = 0; k < predicted.size(); ++k) {
    const double u = run.moments[k].displacement, error = predicted[k] - u;
    result.time.push_back(run.moments[k].time);
    result.speed.push_back(speed[k]);
    result.simulated.push_back(u);
    squares += error * error;
    result.lowest = std::fmin(result.lowest, u);
    result.highest = std::fmax(result.highest, u);
    if (std::abs(error) <= result.largest) continue;  // false for the first, a NaN
    result.largest = std::abs(error);
    result.time_of_largest = run.moments[k].time;
  }
  result.rms = std::sqrt(squares / static_cast<double>(result.rows));
  result.corrected = std::move(predicted);
  return result;
}

record::Record trial_programme(double fastest) {
  constexpr double half_hour = 1800.0, row = 60.0;  // [s]
  std::vector<double> time{0.0}, speed{0.0};
  double begin = 0.0;
  for (const double share : {0.5, 1.0, 0.0, 0.7, 0.3, 1.0, 0.0, 0.5}) {
    for (double t = row; t <= half_hour; t += row) {
      time.push_back(begin + t);
      speed.push_back(share * fastest);
    }
    begin += half_hour;
  }
  record::Record programme{.settings_hold = record::SettingsHold::until_row};
  programme.set(record::time, std::move(time));
  programme.set(record::speed, std::move(speed));
  return programme;
}

std::string superposition_text(const Superposition& s) {
  constexpr double one_hour = 3600.0;
  return fmt::format(
      "RMS {:.3g} um, largest {:.3g} um (after {:.2f} h); the displacement varies by {:.3g} um",
      s.rms / um, s.largest / um, s.time_of_largest / one_hour, (s.highest - s.lowest) / um);
}

}  // namespace raceway::results
