#include "rig/coast_down.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <span>
#include <stdexcept>

#include "record/median.h"
#include "rig/detail/release.h"
#include "rig/detail/speed_regression.h"
#include "rig/detail/torque_rows.h"

namespace raceway::rig {
namespace {

constexpr std::size_t largest_window = 32;  // blocks; longer windows are averaged to this first
constexpr double gap_limit = 5.0;           // usual spacings, or half a window where that is more

std::string of_run(const std::string& run) { return run.empty() ? "" : "run " + run + ": "; }

/// The first few places of a list, for messages.
std::string places_text(const record::Record& record, const std::vector<std::size_t>& rows) {
  std::string text = record.lines.empty() ? "row" : "line";
  text += rows.size() == 1 ? " " : "s ";
  for (std::size_t i = 0; i < rows.size() && i < 5; ++i)
    text += fmt::format("{}{}", i == 0 ? "" : ", ", record.line(rows[i]));
  if (rows.size() > 5) text += ", ...";
  return text;
}

void check(const record::Record& record, const model::Rig& rig, const CoastDownOptions& options) {
  if (!(rig.inertia > 0.0) || !std::isfinite(rig.inertia))
    throw std::invalid_argument(
        fmt::format("inertia = {} kg m2: must be above 0; the torque of a coast-down is M = -J "
                    "dw/dt (J: inertia, w: angular speed)",
                    rig.inertia));
  if (options.windows < 1 || options.fewest_samples < 5 ||
      !(options.largest_fall > 0.0 && options.largest_fall < 1.0))
    throw std::invalid_argument(
        "coast-down options: windows must be at least 1, fewest_samples at least 5, and "
        "largest_fall between 0 and 1");
  if (record.rows() == 0)
    throw std::invalid_argument(record.source + ": the coast-down record has no samples");
  const auto times = record.values(record::time), speeds = record.values(record::speed);
  for (std::size_t i = 0; i < record.rows(); ++i)
    if (times.empty() || speeds.empty() || !std::isfinite(times[i]) || !std::isfinite(speeds[i]))
      throw std::invalid_argument(fmt::format("{}, {}: time and speed must be finite numbers",
                                              record.source, record.place(i)));
}

/// The rows of every run, runs in the order in which they appear.
std::vector<std::vector<std::size_t>> rows_by_run(const record::Record& record) {
  std::vector<int> runs;
  std::vector<std::vector<std::size_t>> rows;
  for (std::size_t i = 0; i < record.rows(); ++i) {
    const auto known = std::find(runs.begin(), runs.end(), record.run_of(i));
    const auto k = static_cast<std::size_t>(known - runs.begin());
    if (known == runs.end()) {
      runs.push_back(record.run_of(i));
      rows.emplace_back();
    }
    rows[k].push_back(i);
  }
  return rows;
}

/// Turns one run into torques.
class RunRegression {
 public:
  RunRegression(const record::Record& record, const model::Rig& rig,
                const CoastDownOptions& options, std::vector<record::Note>& notes)
      : record_(record), rig_(rig), options_(options), notes_(notes) {
    times_ = record.values(record::time);
    speeds_ = record.values(record::speed);
    std::size_t c = 0;
    for (const record::Channel& channel : record::channels)
      if (channel.is_input()) inputs_[c++] = record.values(channel);
  }

  /// A run that is too short gives no torques, and a note.
  CoastDownRun add(const std::vector<std::size_t>& rows, std::vector<Torque>& torques) {
    summary_ = {};
    const int run = record_.run_of(rows.front());
    if (run >= 0) summary_.run = record_.runs.at(static_cast<std::size_t>(run));
    const std::vector<std::vector<Block>> falls = released(averaged_times(samples_of(rows)));
    std::size_t count = 0;
    for (const std::vector<Block>& fall : falls) count += fall.size();
    const std::size_t aim = std::max(fewest(), count / static_cast<std::size_t>(options_.windows));
    std::vector<std::vector<Block>> parts;
    for (const std::vector<Block>& fall : falls) {
      const std::vector<Block> kept = without_outliers(fall, aim);
      const int samples = static_cast<int>(kept.size());
      if (kept.size() < fewest()) {
        if (falls.size() > 1)
          note("{} samples of one fall of the speed are too few for a torque and are not used ({})",
               samples, record_.place(fall.front().row));
        summary_.samples = std::max(summary_.samples, samples);
        continue;
      }
      summary_.samples += samples;
      cut(kept, aim, parts);
    }
    if (!parts.empty())
      add_torques(parts, torques);
    else if (summary_.samples < options_.fewest_samples)
      note(
          "the run has only {} usable sample{}; a torque needs at least {}, so the run is not used",
          summary_.samples, summary_.samples == 1 ? "" : "s", fewest());
    return summary_;
  }

 private:
  [[nodiscard]] std::size_t fewest() const {
    return static_cast<std::size_t>(options_.fewest_samples);
  }

  template <typename... Arguments>
  void note(fmt::format_string<Arguments...> text, Arguments&&... arguments) {
    notes_.push_back(record::note::left_out(
        of_run(summary_.run) + fmt::format(text, std::forward<Arguments>(arguments)...),
        {.key = "run_id"}));
  }

  std::vector<Block> samples_of(const std::vector<std::size_t>& rows) {
    std::vector<Block> samples;
    std::vector<std::size_t> slow;
    double last_time = -std::numeric_limits<double>::infinity();
    for (const std::size_t i : rows) {
      if (times_[i] < last_time)
        throw std::invalid_argument(
            fmt::format("{}, {}: time_s = {} goes back within {} (the row before has {})",
                        record_.source, record_.place(i), times_[i],
                        summary_.run.empty() ? "the record" : "run " + summary_.run, last_time));
      last_time = times_[i];
      if (!(speeds_[i] > 0.0 && speeds_[i] >= rig_.minimum_speed)) {
        slow.push_back(i);
        continue;
      }
      Block& b = samples.emplace_back(Block{.time = times_[i], .speed = speeds_[i], .row = i});
      for (std::size_t c = 0; c < input_count; ++c)
        b.inputs[c] = inputs_[c].empty() ? unset : inputs_[c][i];
    }
    if (!slow.empty())
      note("{} sample{} at standstill or below {:.4g} rpm {} not used ({})", slow.size(),
           slow.size() == 1 ? "" : "s", rig_.minimum_speed / rpm, slow.size() == 1 ? "is" : "are",
           places_text(record_, slow));
    return samples;
  }

  /// One sample for each time.
  std::vector<Block> averaged_times(const std::vector<Block>& samples) {
    std::vector<Block> distinct;
    std::vector<std::size_t> shared;  // rows of times with more than one sample
    std::size_t count = 0;
    for (std::size_t first = 0, last = 0; first < samples.size(); first = last) {
      while (last < samples.size() && samples[last].time == samples[first].time) ++last;
      const auto alike = std::span(samples).subspan(first, last - first);
      distinct.push_back(averaged(alike, alike.size()).front());
      distinct.back().row = samples[first].row;
      if (alike.size() < 2) continue;
      shared.push_back(samples[first].row);
      count += alike.size();
    }
    if (!shared.empty())
      note(
          "{} samples have only {} different time{}, so samples of the same time are averaged "
          "(first in {})",
          count, shared.size(), shared.size() == 1 ? "" : "s", record_.place(shared.front()));
    return distinct;
  }

  /// The samples after each release.
  std::vector<std::vector<Block>> released(const std::vector<Block>& samples) {
    const ReleaseOptions options{.fewest = fewest(),
                                 .windows = static_cast<std::size_t>(options_.windows),
                                 .largest_fall = options_.largest_fall};
    std::vector<std::vector<Block>> falls;
    for (const std::span<const Block> start : starts(samples)) {
      const std::size_t driven = samples_before_release(start, options);
      if (driven < start.size())
        falls.emplace_back(start.begin() + static_cast<std::ptrdiff_t>(driven), start.end());
      if (driven == 0) continue;
      summary_.before_release += static_cast<int>(driven);
      note(
          "{} sample{} before the release of the shaft {} not used ({} to {}): the speed falls "
          "freely after {:.6g} s, from {:.5g} rpm",
          driven, driven == 1 ? "" : "s", driven == 1 ? "is" : "are",
          record_.place(start.front().row), record_.line(start[driven - 1].row),
          start[driven - 1].time, start[driven - 1].speed / rpm);
    }
    return falls;
  }

  std::vector<Block> without_outliers(const std::vector<Block>& samples, std::size_t aim) {
    if (samples.size() < fewest()) return samples;
    const std::vector<bool> outlier =
        find_outliers(samples, std::clamp<std::size_t>(aim, 2 * fewest(), 64));
    std::vector<std::size_t> rows;
    std::vector<Block> kept;
    for (std::size_t i = 0; i < samples.size(); ++i) {
      if (outlier[i])
        rows.push_back(samples[i].row);
      else
        kept.push_back(samples[i]);
    }
    if (!rows.empty())
      note("{} outlier{} of the speed curve {} not used ({})", rows.size(),
           rows.size() == 1 ? "" : "s", rows.size() == 1 ? "is" : "are",
           places_text(record_, rows));
    summary_.outliers += static_cast<int>(rows.size());
    return kept;
  }

  /// Windows of blocks, of which none spans a gap.
  void cut(const std::vector<Block>& kept, std::size_t aim,
           std::vector<std::vector<Block>>& parts) {
    const std::size_t block = std::max<std::size_t>(1, (aim + largest_window - 1) / largest_window);
    const std::size_t most = std::max(fewest(), aim / block);
    const double gap = std::max(gap_limit, 0.5 * static_cast<double>(aim));
    for (const std::span<const Block> samples : segments(kept, gap)) {
      const std::vector<Block> segment = averaged(samples, block);
      const auto cuts = windows(segment, fewest(), most, options_.largest_fall);
      if (cuts.empty())
        note("{} samples between two gaps in time are too few for a torque and are not used ({})",
             segment.size() * block, record_.place(segment.front().row));
      for (const std::span<const Block> part : cuts) parts.emplace_back(part.begin(), part.end());
    }
  }

  void add_torques(const std::vector<std::vector<Block>>& parts, std::vector<Torque>& torques) {
    std::vector<LocalParabola> fits;
    fits.reserve(parts.size());
    for (const std::vector<Block>& part : parts) fits.push_back(local_parabola(part));
    const SpeedNoise noise = speed_noise(fits);
    summary_.speed_noise = noise.std;
    summary_.correlation = noise.correlation;
    std::vector<double> deviations;
    std::vector<std::size_t> driven;
    for (std::size_t w = 0; w < fits.size(); ++w) {
      const std::size_t row = parts[w][parts[w].size() / 2].row;
      const double torque = -rig_.inertia * fits[w].slope;
      if (torque <= 0.0 || !(fits[w].speed > 0.0)) {
        driven.push_back(row);
        continue;
      }
      deviations.push_back(rig_.inertia * slope_deviation(fits[w], noise));
      torques.push_back({fits[w].time, fits[w].speed, torque, deviations.back(),
                         averaged(parts[w], parts[w].size()).front(), row});
    }
    if (!driven.empty())
      note("{} group{} of neighbouring samples without a fall of the speed {} not used ({})",
           driven.size(), driven.size() == 1 ? "" : "s", driven.size() == 1 ? "is" : "are",
           places_text(record_, driven));
    summary_.rows = static_cast<int>(deviations.size());
    if (deviations.empty()) return;
    summary_.torque_std = record::median(deviations);
    note(
        "{} torques from {} speed samples by local regression, M = -J dw/dt with the angular speed "
        "w and the inertia J = {:.6g} kg m2; "
        "median standard deviation of the torques {:.3g} N mm (noise of the speed {:.3g} rpm{})",
        summary_.rows, summary_.samples, rig_.inertia, summary_.torque_std / N_mm, noise.std / rpm,
        noise.correlation > 0.0
            ? fmt::format(", correlation of successive samples {:.2f}", noise.correlation)
            : "");
  }

  const record::Record& record_;
  const model::Rig& rig_;
  const CoastDownOptions& options_;
  std::vector<record::Note>& notes_;
  std::span<const double> times_, speeds_;
  std::array<std::span<const double>, input_count> inputs_;
  CoastDownRun summary_;
};

/// Why no run gives a torque.
std::string no_torque(const record::Record& record, const std::vector<CoastDownRun>& runs,
                      const CoastDownOptions& options) {
  const auto longest = std::max_element(
      runs.begin(), runs.end(),
      [](const CoastDownRun& a, const CoastDownRun& b) { return a.samples < b.samples; });
  if (longest->samples >= options.fewest_samples)
    return record.source + ": the speed never falls, so there is no torque";
  return fmt::format(
      "{}: {}{} samples are too few for a torque, which needs at least {} samples{}", record.source,
      of_run(longest->run), longest->samples, options.fewest_samples,
      runs.size() > 1 ? fmt::format("; none of the {} runs has more", runs.size())
      : longest->before_release > 0
          ? fmt::format("; {} samples before the release are not used", longest->before_release)
          : "");
}

}  // namespace

CoastDownTorque coast_down_torque(const record::Record& coast_down, const model::Rig& rig,
                                  const CoastDownOptions& options) {
  check(coast_down, rig, options);
  CoastDownTorque result;
  result.record.source = coast_down.source;
  result.record.notes = coast_down.notes;
  std::vector<Torque> torques;
  RunRegression regression(coast_down, rig, options, result.record.notes);
  for (const std::vector<std::size_t>& rows : rows_by_run(coast_down))
    result.runs.push_back(regression.add(rows, torques));
  if (torques.empty()) throw std::invalid_argument(no_torque(coast_down, result.runs, options));
  fill(torques, coast_down, result.record);
  return result;
}

}  // namespace raceway::rig
