#include "spindle/warm_start.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "record/spindle_channel.h"

namespace raceway::spindle {
namespace {

constexpr double warm_by = 2.0;         // above what a run from cold has [K]
constexpr std::size_t fewest_warm = 2;  // thermometers, where the model has as many
constexpr double nearer = 0.5;          // than a cold start, of the rms error
constexpr double counts_anew = 0.25;    // of the displacement that the past gives
constexpr std::array hours_before{0.25, 0.5, 1.0, 2.0, 4.0, 8.0};

/// Rises of the thermometers in the first row [K]; NaN of one that was not read.
std::vector<double> first_rises(const model::Model& model, const record::Record& run, double room) {
  std::vector<double> rises;
  for (const model::ThermometerPlace& sensor : model.spindle->sensors)
    rises.push_back(run.value(record::sensor_channel(sensor.name), 0) - room);
  return rises;
}

double rms_difference(std::span<const double> read, std::span<const double> said) {
  double square = 0.0, count = 0.0;
  for (std::size_t k = 0; k < read.size(); ++k) {
    if (!std::isfinite(read[k])) continue;
    square += std::pow(read[k] - said[k], 2);
    count += 1.0;
  }
  return std::sqrt(square / std::max(count, 1.0));
}

/// Speeds that may have been before [rad/s].
std::vector<double> speeds_before(std::span<const ProfileRow> profile) {
  double sum = 0.0, highest = 0.0;
  for (const ProfileRow& row : profile) {
    sum += row.inputs.speed;
    highest = std::max(highest, row.inputs.speed);
  }
  std::vector<double> list{profile.front().inputs.speed, sum / static_cast<double>(profile.size()),
                           highest};
  std::sort(list.begin(), list.end());
  list.erase(std::unique(list.begin(), list.end()), list.end());
  std::erase_if(list, [](double speed) { return !(speed > 0.0); });
  return list;
}

/// The spindle at these inputs, at each of the hours.
Run past_of(Simulator& simulator, const Inputs& inputs, std::span<const double> at) {
  std::vector<ProfileRow> rows;
  for (const double h : at) rows.push_back({.time = 3600.0 * h, .inputs = inputs});
  return simulator.simulate(rows);
}

}  // namespace

std::string WarmStart::statement() const {
  return fmt::format(
      "the thermometers are up to {:.2g} K above the room temperature in the first row: the "
      "simulation starts warm, as after {:.2g} h at {:.0f} rpm{}",
      rise, duration / 3600.0, inputs.speed / rpm,
      zeroed ? ", and the zero of the displacement follows from the fit to the readings" : "");
}

std::optional<WarmStart> find_warm_start(const model::Model& model, const record::Record& run,
                                         std::span<const ProfileRow> profile) {
  if (profile.empty() || !std::isfinite(profile.front().inputs.ambient_temperature)) return {};
  const double room = profile.front().inputs.ambient_temperature;
  const std::vector<double> rises = first_rises(model, run, room);
  const auto rises_of = [&](const Moment& moment) {
    std::vector<double> said = moment.sensors;
    for (double& t : said) t -= room;
    return said;
  };
  // What a run from cold has in its first row.
  Simulator simulator(model);
  const Run from_cold = simulator.simulate(profile.first(1));
  if (from_cold.moments.empty()) return {};
  const std::vector<double> cold = rises_of(from_cold.moments.front());
  std::size_t count = 0;
  WarmStart found;
  for (std::size_t k = 0; k < rises.size(); ++k) {
    count += rises[k] - cold[k] > warm_by ? 1 : 0;
    found.rise = std::fmax(found.rise, rises[k]);
  }
  if (count == 0 || count < std::min(fewest_warm, rises.size())) return {};
  double least = nearer * rms_difference(rises, cold), moved = unset;
  for (const double speed : speeds_before(profile)) {
    Inputs inputs = profile.front().inputs;
    inputs.speed = speed;
    const Run past = past_of(simulator, inputs, hours_before);
    for (std::size_t k = 0; k < past.moments.size(); ++k) {
      const double error = rms_difference(rises, rises_of(past.moments[k]));
      if (!(error < least)) continue;
      least = error;
      moved = past.moments[k].displacement;
      found.inputs = inputs;
      found.duration = 3600.0 * hours_before[k];
    }
  }
  if (std::isnan(found.duration)) return {};
  const double read = run.value(record::axial_displacement, 0);
  found.zeroed = std::abs(read) < counts_anew * std::abs(moved);
  return found;
}

State state_after(Simulator& simulator, const WarmStart& past,
                  std::span<const ProfileRow> profile) {
  State state = past_of(simulator, past.inputs, std::array{past.duration / 3600.0}).end;
  // As a run from cold begins: at 0 s, or one step before its first row.
  const double step = profile.size() > 1 ? profile[1].time - profile[0].time : 1.0;
  state.time = std::min(0.0, profile.front().time - step);
  return state;
}

}  // namespace raceway::spindle
