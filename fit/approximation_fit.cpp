#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "fit/approximation_loop.h"
#include "fit/thinned_record.h"
#include "fit/verdict_text.h"

namespace raceway::fit {
namespace {

std::shared_ptr<const Subject> informed(const Subject& subject, const Record& record) {
  subject.require(record);
  std::unique_ptr<Subject> knows = subject.informed_by(record);
  return knows ? std::shared_ptr<const Subject>(std::move(knows))
               : std::shared_ptr<const Subject>(subject.with_values({}));
}

Recorded means_of_record(const Subject& subject, const Record& record) {
  return recorded(subject, for_search(std::make_shared<const Record>(record)), usual_width(record));
}

void require_readings(const Approximation& a, const Recorded& on, const Record& record) {
  if (on.means.list.size() < 2 * a.names.size())
    throw std::invalid_argument(
        fmt::format("{}: {} readings at different minutes for {} free parameters: too few",
                    record.source, on.means.list.size(), a.names.size()));
}

/// Of predictions with their mean taken off [SI]: the zero of a reading is arbitrary.
double rms_about_mean(const Subject& subject, const Record& record) {
  const std::vector<double> predicted = predict(subject, record);
  const std::span<const double> read = record.values(*subject.measured().front().channel);
  double sum = 0.0, square = 0.0, count = 0.0;
  for (std::size_t k = 0; k < read.size(); ++k)
    if (const double e = predicted[k] - read[k]; std::isfinite(e)) {
      sum += e;
      square += e * e;
      count += 1.0;
    }
  return std::sqrt(std::max(0.0, square / count - sum * sum / (count * count)));
}

Calibration calibration_of(const Subject& before, const Approximation& on_means,
                           const Recorded& means, const Record& record) {
  Recorded rows, whole = means;
  whole.record = std::make_shared<const Record>(record);
  const Approximation fit = refined(on_means, whole, rows);
  const ApproximationErrors errors = errors_of(fit, rows);
  const Measured of = before.measured().front();
  Calibration result{.subject = fitted(fit), .parameters = fit.parameters};
  const auto count = static_cast<Eigen::Index>(fit.parameters.size());
  result.correlation = Eigen::MatrixXd::Constant(count, count, unset);
  for (Eigen::Index i = 0; i < count; ++i) {
    Parameter& p = result.parameters[static_cast<std::size_t>(i)];
    p.std = std::sqrt(errors.covariance(i, i));
    p.identifiable = std::isfinite(p.std) || p.at_bound != Bound::none;
    for (Eigen::Index j = 0; j < count; ++j)
      result.correlation(i, j) =
          errors.covariance(i, j) / std::sqrt(errors.covariance(i, i) * errors.covariance(j, j));
    if (p.at_bound != Bound::none)
      result.messages.push_back(
          fmt::format("{} = {} ends at a bound", p.name, with_unit(p.value, p.unit, 4)));
  }
  result.rows = static_cast<int>(rows.means.size());
  result.degrees_of_freedom = result.rows - static_cast<int>(count);
  result.channels = {{.channel = of.channel,
                      .rmse_before = rms_about_mean(before, record),
                      .rmse_after = rms_about_mean(*result.subject, record)}};
  result.iterations = fit.fit.iterations;
  result.status = fit.fit.values.allFinite() ? FitStatus::converged : FitStatus::failed;
  result.correlation_time = errors.correlation_time;
  result.rms_held_out = fit.rms_held_out / rows.means.list.front().weight;
  if (std::isfinite(result.rms_held_out))
    result.messages.push_back(fmt::format("on parts of the record that no fit saw it errs by {}",
                                          reading_text(*of.channel, result.rms_held_out)));
  return result;
}

}  // namespace

Calibration calibrate_approximation(const Subject& subject, const Record& record) {
  const auto of = informed(subject, record);
  const Recorded on = means_of_record(*of, record);
  if (on.means.size() == 0)
    throw std::invalid_argument(record.source + ": nothing was read that the model predicts");
  Approximation fit = approximate(of, on, of->free());
  require_fit(fit);
  require_readings(fit, on, record);
  hold_out(fit, on);
  return calibration_of(*of, fit, on, record);
}

AddResult add_approximation(const Subject& subject, std::span<const std::string> ids,
                            const Record& record) {
  if (ids.empty()) throw std::invalid_argument("no effect to add");
  const auto of = informed(subject, record);
  (void)of->with_candidates(ids);  // what cannot be added is said before anything is fitted
  const Recorded on = means_of_record(*of, record);
  const std::vector<Candidate> all = of->candidates();
  std::vector<const Candidate*> chosen;
  for (const std::string& id : ids)
    for (const Candidate& c : all)
      if (c.id == id) chosen.push_back(&c);
  Approximation base = approximate(of, on, of->free());
  require_fit(base);
  require_readings(base, on, record);
  hold_out(base, on);
  Approximation with = approximate_with(base, on, chosen);
  hold_out(with, on);
  AddResult result{.calibration = calibration_of(*of, with, on, record)};
  const Measured channel = of->measured().front();
  const double weight = on.means.list.front().weight;
  ChannelGain& gain = result.channels.emplace_back();
  gain.before =
      compare(predict(*fitted(base), record), record, channel, static_cast<int>(base.names.size()));
  gain.after = compare(predict(*result.calibration.subject, record), record, channel,
                       static_cast<int>(with.names.size()));
  result.refits = {refit_of(base, on), refit_of(with, on)};
  result.refits.back().subject = result.calibration.subject;
  gain.noise.rms = gain.before.noise.rms;
  gain.tolerance = channel.tolerance;
  gain.rmse_held_out_before = base.rms_held_out / weight;
  gain.rmse_held_out_after = with.rms_held_out / weight;
  result.hold_out.push_back({.variable = "time",
                             .rmse_before = {gain.rmse_held_out_before},
                             .rmse_after = {gain.rmse_held_out_after}});
  result.messages = result.calibration.messages;
  for (const Candidate* c : chosen)
    if (c->of_reading)
      result.messages.push_back(fmt::format(
          "{} cleans this record: it is carried neither to another one nor to a control", c->id));
  if (std::isfinite(channel.tolerance) && base.rms_held_out <= 1.0)
    result.reason = fmt::format(
        "without it the model errs by {} on parts held out, within the tolerance of {}: what is "
        "missing does not matter",
        reading_text(*channel.channel, gain.rmse_held_out_before),
        reading_text(*channel.channel, channel.tolerance));
  else if (!(with.rms_held_out < base.rms_held_out))
    result.reason = fmt::format("on parts held out the error does not fall ({} without, {} with)",
                                reading_text(*channel.channel, gain.rmse_held_out_before),
                                reading_text(*channel.channel, gain.rmse_held_out_after));
  result.refused = !result.reason.empty();
  return result;
}

}  // namespace raceway::fit
