#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <stdexcept>

#include "tolerance/approximation_loop.h"
#include "tolerance/stray_readings.h"
#include "tolerance/thinned_record.h"
#include "verdict/verdict_text.h"

namespace raceway::tolerance {

record::Note stays_note(const record::Parameter& p) {
  return record::note::unknown(
      fmt::format("{} stays at its prior, {} ± {}: the record does not determine it", p.name,
                  verdict::with_unit(p.value, p.unit, 4),
                  verdict::with_unit(p.prior.std, p.unit, 2)),
      {.key = p.name});
}

namespace {

std::shared_ptr<const fit::Subject> informed(const fit::Subject& subject,
                                             const record::Record& record) {
  subject.require(record);
  std::unique_ptr<fit::Subject> knows = subject.informed_by(record);
  return knows ? std::shared_ptr<const fit::Subject>(std::move(knows))
               : std::shared_ptr<const fit::Subject>(subject.with_values({}));
}

Recorded means_of_record(const fit::Subject& subject, const record::Record& record) {
  return recorded(subject, for_search(std::make_shared<const record::Record>(record)),
                  usual_width(record));
}

void require_readings(const Approximation& a, const Recorded& on, const record::Record& record) {
  if (on.means.list.size() < 2 * a.names.size())
    throw std::invalid_argument(
        fmt::format("{}: {} readings are too few for {} free parameters: a fit needs two or more "
                    "for each parameter. Rows that are close in time count as one reading",
                    record.source, on.means.list.size(), a.names.size()));
}

/// Of one channel [SI]; about the mean where its zero says nothing.
double rms_of(std::span<const double> predicted, const fit::Measured& of,
              const record::Record& record) {
  const std::span<const double> read = record.values(*of.channel);
  double sum = 0.0, square = 0.0, count = 0.0;
  for (std::size_t k = 0; k < read.size(); ++k)
    if (const double e = predicted[k] - read[k]; std::isfinite(e)) {
      sum += e;
      square += e * e;
      count += 1.0;
    }
  const double mean = of.any_zero ? sum / count : 0.0;
  return std::sqrt(std::max(0.0, square / count - mean * mean));
}

/// Channels that were read, as places in `channels`.
std::vector<std::size_t> read_channels(const fit::Means& means,
                                       const std::vector<fit::Measured>& channels) {
  std::vector<std::size_t> list;
  for (std::size_t c = 0; c < channels.size(); ++c)
    if (std::any_of(means.list.begin(), means.list.end(),
                    [&](const fit::Means::Mean& mean) { return mean.channel == c; }))
      list.push_back(c);
  return list;
}

/// Of a weighted error of one channel [SI].
double in_SI(double error, const fit::Measured& of, const record::Record& record) {
  const double tolerance = fit::tolerance_of(of, record);
  return std::isfinite(tolerance) ? error * tolerance : error;
}

std::string held_out_text(const Approximation& a, const std::vector<fit::Measured>& channels,
                          const std::vector<std::size_t>& read, const record::Record& record) {
  std::vector<std::string> texts;
  for (const std::size_t c : read)
    texts.push_back(verdict::reading_text(*channels[c].channel,
                                          in_SI(a.channel_held_out.at(c), channels[c], record)) +
                    (read.size() > 1 ? fmt::format(" of {}", channels[c].channel->words) : ""));
  return verdict::joined(texts, "and");
}

/// Error of a channel as it was before a fit, on the means that are held out, about the mean of
/// their run where its zero says nothing [SI].
double held_out_before(const fit::Subject& before, const Approximation& a, const Recorded& on,
                       std::size_t channel, const fit::Measured& of) {
  const std::vector<double> predicted = fit::predict(before, *on.record);
  std::map<int, std::vector<double>> by_run;
  for (std::size_t i = 0; i < a.held_out.size(); ++i) {
    const fit::Means::Mean& mean = on.means.list[i];
    if (mean.channel != channel || std::isnan(a.held_out[i])) continue;
    double sum = 0.0;
    for (const Eigen::Index place : mean.places) sum += predicted[static_cast<std::size_t>(place)];
    const auto row = static_cast<std::size_t>(mean.places.front()) % on.record->rows();
    by_run[on.record->run_of(row)].push_back(sum / static_cast<double>(mean.places.size()) -
                                             mean.measured);
  }
  double square = 0.0, count = 0.0;
  for (const auto& [run, errors] : by_run) {
    const auto size = static_cast<double>(errors.size());
    const double zero =
        of.any_zero ? std::accumulate(errors.begin(), errors.end(), 0.0) / size : 0.0;
    for (const double e : errors) square += (e - zero) * (e - zero);
    count += size;
  }
  return std::sqrt(square / count);
}

/// What to say where the model was better before the fit, on parts that the fit did not see.
std::string better_before(const fit::Subject& before, const Approximation& a, const Recorded& on,
                          const std::vector<fit::Measured>& channels,
                          const std::vector<std::size_t>& read) {
  constexpr double as_good = 1.005;
  std::vector<std::string> texts;
  for (const std::size_t c : read) {
    const double was = held_out_before(before, a, on, c, channels[c]),
                 now = in_SI(a.channel_held_out.at(c), channels[c], *on.record);
    if (now > as_good * was)
      texts.push_back(verdict::reading_text(*channels[c].channel, was) +
                      (read.size() > 1 ? fmt::format(" of {}", channels[c].channel->words) : ""));
  }
  if (texts.empty()) return {};
  return fmt::format(", but before the fit the error was {}: the record does not improve the model",
                     verdict::joined(texts, "and"));
}

verdict::Calibration calibration_of(const fit::Subject& before, const Approximation& on_means,
                                    const Recorded& means, const record::Record& record) {
  Recorded rows, whole = means;
  whole.record = std::make_shared<const record::Record>(record);
  const Approximation fit = refined(on_means, whole, rows);
  const ApproximationErrors errors = errors_of(fit, rows);
  const std::vector<fit::Measured> channels = before.measured();
  verdict::Calibration result{.subject = fitted(fit), .parameters = fit.parameters};
  const auto count = static_cast<Eigen::Index>(fit.parameters.size());
  result.correlation = Eigen::MatrixXd::Constant(count, count, unset);
  for (Eigen::Index i = 0; i < count; ++i) {
    record::Parameter& p = result.parameters[static_cast<std::size_t>(i)];
    p.std = std::sqrt(errors.covariance(i, i));
    p.identifiable = std::isfinite(p.std) || p.at_bound != record::Bound::none;
    for (Eigen::Index j = 0; j < count; ++j)
      result.correlation(i, j) =
          errors.covariance(i, j) / std::sqrt(errors.covariance(i, i) * errors.covariance(j, j));
    if (p.at_bound != record::Bound::none)
      result.messages.push_back(
          record::note::at_bound(fmt::format("{} = {} is at a bound of its range", p.name,
                                             verdict::with_unit(p.value, p.unit, 4)),
                                 {.key = p.name}));
  }
  const auto told = count + std::ssize(fit.stays);
  result.correlation.conservativeResizeLike(Eigen::MatrixXd::Identity(told, told));
  for (const record::Parameter& p : fit.stays) {
    result.parameters.push_back(p);
    result.messages.push_back(stays_note(p));
  }
  const std::vector<std::size_t> read = read_channels(rows.means, channels);
  result.rows = static_cast<int>(
      std::count_if(rows.means.list.begin(), rows.means.list.end(),
                    [&](const fit::Means::Mean& mean) { return mean.channel == read.front(); }));
  result.likelihood = {.readings = static_cast<int>(rows.means.size()),
                       .parameters = static_cast<int>(count)};
  result.degrees_of_freedom = result.likelihood.degrees_of_freedom();
  const std::vector<double> earlier = fit::predict(before, record),
                            later = fit::predict(*result.subject, record);
  for (const std::size_t c : read) {
    const auto of_channel = [&](const std::vector<double>& all) {
      return std::span(all).subspan(c * record.rows(), record.rows());
    };
    result.channels.push_back(
        {.channel = channels[c].channel,
         .rmse_before = rms_of(of_channel(earlier), channels[c], record),
         .rmse_after = rms_of(of_channel(later), channels[c], record),
         .readings = static_cast<int>(
             std::count_if(rows.means.list.begin(), rows.means.list.end(),
                           [&](const fit::Means::Mean& mean) { return mean.channel == c; }))});
  }
  result.iterations = fit.fit.iterations;
  result.status = fit.fit.values.allFinite() ? fit::FitStatus::converged : fit::FitStatus::failed;
  result.correlation_time = errors.correlation_time;
  if (!std::isfinite(fit.rms_held_out)) return result;
  result.rms_held_out =
      in_SI(fit.channel_held_out.at(read.front()), channels[read.front()], record);
  result.messages.push_back(record::note::misfit(
      fmt::format("the held-out error is {}{}", held_out_text(fit, channels, read, record),
                  better_before(before, on_means, means, channels, read))));
  return result;
}

}  // namespace

verdict::Calibration calibrate_approximation(const fit::Subject& subject,
                                             const record::Record& whole) {
  const WithoutStrays without = without_strays(subject, whole);
  const record::Record& record = *without.record;
  const auto of = informed(subject, record);
  const Recorded on = means_of_record(*of, record);
  if (on.means.size() == 0)
    throw std::invalid_argument(record.source +
                                ": the record has no column that the model predicts");
  Approximation fit = approximate(of, on, of->free());
  require_fit(fit);
  require_readings(fit, on, record);
  hold_out(fit, on);
  verdict::Calibration result = calibration_of(*of, fit, on, record);
  result.messages.insert(result.messages.begin(), without.notes.begin(), without.notes.end());
  return result;
}

verdict::AddResult add_approximation(const fit::Subject& subject, std::span<const std::string> ids,
                                     const record::Record& whole) {
  if (ids.empty()) throw std::invalid_argument("no effect to add");
  const WithoutStrays without = without_strays(subject, whole);
  const record::Record& record = *without.record;
  const auto of = informed(subject, record);
  (void)of->with_candidates(ids);  // what cannot be added is said before anything is fitted
  const Recorded on = means_of_record(*of, record);
  const std::vector<fit::Candidate> all = of->candidates();
  std::vector<const fit::Candidate*> chosen;
  for (const std::string& id : ids)
    for (const fit::Candidate& c : all)
      if (c.id == id) chosen.push_back(&c);
  Approximation base = approximate(of, on, of->free());
  require_fit(base);
  require_readings(base, on, record);
  hold_out(base, on);
  Approximation with = approximate_with(base, on, chosen);
  hold_out(with, on);
  verdict::AddResult result{.calibration = calibration_of(*of, with, on, record)};
  const std::vector<fit::Measured> channels = of->measured();
  const std::vector<std::size_t> read = read_channels(on.means, channels);
  const std::vector<double> before = fit::predict(*fitted(base), record),
                            after = fit::predict(*result.calibration.subject, record);
  fit::HoldOut& parts = result.hold_out.emplace_back();
  parts.variable = "time";
  for (const std::size_t c : read) {
    const fit::Measured& channel = channels[c];
    const auto of_channel = [&](const std::vector<double>& values) {
      return std::span(values).subspan(c * record.rows(), record.rows());
    };
    verdict::ChannelGain& gain = result.channels.emplace_back();
    gain.before =
        verdict::compare(of_channel(before), record, channel, static_cast<int>(base.names.size()));
    gain.after =
        verdict::compare(of_channel(after), record, channel, static_cast<int>(with.names.size()));
    gain.noise.rms = gain.before.noise.rms;
    gain.tolerance = fit::tolerance_of(channel, record);
    gain.rmse_held_out_before = in_SI(base.channel_held_out.at(c), channel, record);
    gain.rmse_held_out_after = in_SI(with.channel_held_out.at(c), channel, record);
    parts.rmse_before.push_back(gain.rmse_held_out_before);
    parts.rmse_after.push_back(gain.rmse_held_out_after);
  }
  result.refits = {refit_of(base, on), refit_of(with, on)};
  result.refits.back().subject = result.calibration.subject;
  result.messages = result.calibration.messages;
  result.messages.insert(result.messages.begin(), without.notes.begin(), without.notes.end());
  for (const fit::Candidate* c : chosen)
    if (c->of_reading)
      result.messages.push_back(record::note::limits(
          fmt::format("{} only removes a disturbance from this record. The program uses this "
                      "effect neither for another record nor in a machine control",
                      c->id)));
  const bool within = std::all_of(
      result.channels.begin(), result.channels.end(),
      [](const verdict::ChannelGain& gain) { return gain.rmse_held_out_before <= gain.tolerance; });
  if (within) {
    std::vector<std::string> tolerances;
    for (const verdict::ChannelGain& gain : result.channels)
      tolerances.push_back(verdict::reading_text(gain.channel(), gain.tolerance));
    result.reason = fmt::format(
        "without the effect the held-out error is {}, which is within the tolerance of {}: the "
        "model needs no further effect",
        held_out_text(base, channels, read, record), verdict::joined(tolerances, "and"));
  } else if (!(with.rms_held_out < base.rms_held_out)) {
    result.reason = fmt::format(
        "the held-out error does not fall ({} without the effect, {} with it)",
        held_out_text(base, channels, read, record), held_out_text(with, channels, read, record));
  }
  result.refused = !result.reason.empty();
  return result;
}

}  // namespace raceway::tolerance
