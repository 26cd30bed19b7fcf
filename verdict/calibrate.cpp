#include "verdict/calibrate.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <stdexcept>

#include "verdict/detail/weighed.h"
#include "verdict/identifiability.h"
#include "verdict/verdict_text.h"

namespace raceway::verdict {

namespace {

/// The common scatter of the readings of a channel, beside their own deviations, that brings χ²
/// down to the degrees of freedom [SI]; 0 where it is below. [PauleMandel1982]
double excess_scatter(const Eigen::VectorXd& errors, const Eigen::VectorXd& std, double freedom) {
  const auto chi_square = [&](double excess) {
    return (errors.array().square() / (std.array().square() + excess * excess)).sum();
  };
  if (freedom < 1.0 || chi_square(0.0) <= freedom) return 0.0;
  double low = 0.0, high = errors.norm();  // there χ² is below 1
  for (int iteration = 0; iteration < 60; ++iteration) {
    const double middle = 0.5 * (low + high);
    (chi_square(middle) > freedom ? low : high) = middle;
  }
  return high;
}

/// By what standard errors are widened: against known noise where the misfit exceeds it, otherwise
/// by the misfit itself.
double error_factor(double misfit, bool noise_known, Calibration& result) {
  const int freedom = result.degrees_of_freedom;
  if (freedom < 1) {
    if (noise_known) return 1.0;
    result.messages.push_back(record::note::not_identifiable(
        "there are as many rows as parameters, so there are no standard errors"));
    return unset;
  }
  const double reduced = misfit / freedom;
  if (!noise_known) return std::sqrt(reduced);
  result.reduced_chi_square = reduced;
  const double factor = fit::widening(misfit, freedom);
  if (factor > 1.0)
    result.messages.push_back(record::note::misfit(fmt::format(
        "the misfit exceeds the noise of the data (chi2/dof = {:.3g}): the standard errors are "
        "multiplied by {:.3g}. They do not include the influence of a missing effect",
        reduced, factor)));
  return factor;
}

/// How likely the readings are under the fit.
fit::Likelihood likelihood_of_fit(double misfit, const fit::Observations& observed,
                                  const fit::Whitening& whitening, bool noise_known,
                                  const Calibration& result) {
  const auto readings = static_cast<int>(observed.size());
  const int moved = readings - result.degrees_of_freedom;
  if (noise_known) return likelihood_of(misfit, whitening, moved);
  // Channels that weigh alike each by itself are not as likely as they can be together.
  if (result.channels.size() != 1) return {.readings = readings, .parameters = moved};
  return fit::likelihood_of_alike(result.channels.front().rmse_after, readings, moved);
}

void tell_bounds(Calibration& result) {
  for (const record::Parameter& p : result.parameters)
    if (p.at_bound != record::Bound::none)
      result.messages.push_back(record::note::at_bound(
          fmt::format("{} is at its {} bound, {}: the data prefer a value beyond it, or an effect "
                      "is missing in the model",
                      p.name, p.at_bound == record::Bound::lower ? "lower" : "upper",
                      with_unit(p.value, p.unit, 5)),
          {.key = p.name}));
}

/// The error of every channel at these readings.
void set_errors(const fit::Observations& observed, const Eigen::VectorXd& readings,
                double ChannelError::*rmse, Calibration& result) {
  result.channels.resize(observed.channels.size());
  for (std::size_t c = 0; c < observed.channels.size(); ++c) {
    result.channels[c].channel = observed.channels[c].channel;
    result.channels[c].readings = static_cast<int>(observed.size(c));
    result.channels[c].*rmse =
        fit::rms(observed.of(c, Eigen::VectorXd(readings - observed.measured)));
  }
}

/// Puts the values of a fit into the parameters that moved, and says what they are worth.
void take_fit(const fit::Response& response, const fit::ResponseFit& fit,
              const fit::Observations& observed, const fit::Whitening& whitening, bool noise_known,
              Calibration& result) {
  result.status = fit.converged ? fit::FitStatus::converged : fit::FitStatus::failed;
  result.iterations = fit.iterations;
  if (!fit.converged) {
    result.messages.push_back(record::note::not_converged(
        "the fit did not converge: no two sets of start values lead to the same minimum"));
    return;
  }
  std::size_t moved = 0;
  for (record::Parameter& p : result.parameters) {
    if (p.held) continue;
    const record::Parameter fitted = fit.fitted(response, moved++);
    p.value = fitted.value;
    p.at_bound = fitted.at_bound;
    if (p.at_bound != record::Bound::none)
      p.value = p.at_bound == record::Bound::lower ? p.lower : p.upper;
  }
  result.degrees_of_freedom = static_cast<int>(observed.size()) - static_cast<int>(moved);
  set_errors(observed, fit.prediction, &ChannelError::rmse_after, result);
  tell_bounds(result);
  for (const ChannelError& c : result.channels)
    if (c.rmse_after > c.rmse_before)
      result.messages.push_back(
          record::note::misfit(fmt::format("the RMS error of {} rises, {:.4g} -> {}, because the "
                                           "fit weights each reading by its noise",
                                           c.channel->words, c.rmse_before / c.channel->factor,
                                           reading_text(*c.channel, c.rmse_after, 4))));
  result.likelihood = likelihood_of_fit(fit.misfit, observed, whitening, noise_known, result);
  result.error_factor = error_factor(fit.misfit, noise_known, result);
  const Eigen::MatrixXd jacobian = whitening(fit.slope);
  estimate_errors(jacobian, result.error_factor, result);
  append(result.messages, unusual_values(result.parameters));
}

/// Fits again with the common scatter that explains a misfit beyond the declared deviations, until
/// that stays the same: without it a model that misses something would be bent to the few quietest
/// rows, and be far too sure of its parameters.
fit::ResponseFit fit_with_excess(const fit::Response& response, fit::ResponseFit fit,
                                 Weighed& weighed, Calibration& result) {
  const fit::Observations& observed = weighed.problem.observed;
  fit::Whitening& whitening = weighed.whitening;
  const fit::Whitening declared = whitening;
  const std::size_t channels = observed.channels.size();
  std::vector<double> excess(channels, 0.0);
  const auto share =
      static_cast<double>(response.parameters.size()) / static_cast<double>(observed.size());
  double chi_square = unset;
  for (int round = 0; round < 50 && fit.converged; ++round) {
    const Eigen::VectorXd errors = fit.prediction - observed.measured;
    chi_square = declared(errors).squaredNorm();
    std::vector<fit::Whitening> parts;
    bool settled = true;
    for (std::size_t c = 0; c < channels; ++c) {
      const Eigen::VectorXd std = observed.of(c, declared.std());
      const double before = excess[c];
      excess[c] = excess_scatter(observed.of(c, errors), std,
                                 static_cast<double>(observed.size(c)) * (1.0 - share));
      settled = settled && std::abs(excess[c] - before) <= 1e-6 * excess[c];
      parts.emplace_back((std.array().square() + excess[c] * excess[c]).sqrt().matrix(),
                         fit::RowOrder{}, 0.0, 0.0);
    }
    if (settled) break;
    whitening = fit::Whitening(parts);
    const Eigen::VectorXd x = fit.values;
    fit =
        fit::fit_response(response, whitening, observed.measured, {x, 0.8 * x, 1.25 * x, 0.5 * x});
  }
  for (std::size_t c = 0; c < channels; ++c)
    if (excess[c] > 0.0) {
      weighed.by_misfit = true;
      result.messages.push_back(record::note::misfit(
          fmt::format("the misfit exceeds the standard deviations of the rows (chi2/dof = {:.3g}): "
                      "the fit adds {} to each standard deviation, so the weights become more "
                      "equal and the standard errors larger",
                      chi_square / (static_cast<double>(observed.size()) * (1.0 - share)),
                      reading_text(*observed.channels[c].channel, excess[c]))));
    }
  return fit;
}

std::vector<record::NamedValue> named_values(const std::vector<record::Parameter>& parameters) {
  std::vector<record::NamedValue> values;
  for (const record::Parameter& p : parameters) values.push_back({p.name, p.value});
  return values;
}

/// The parameters as a fit takes them: inside their bounds.
std::vector<record::Parameter> starting(const fit::Subject& subject, Calibration& result) {
  std::vector<record::Parameter> parameters = fit::find_parameters(subject, subject.free());
  for (record::Parameter& p : parameters) {
    p.value = std::clamp(p.start, p.lower, p.upper);
    if (p.value != p.start)
      result.messages.push_back(record::note::at_bound(
          fmt::format("{} = {} is outside its bounds: the fit starts at {}", p.name,
                      with_unit(p.start, p.unit, 5), with_unit(p.value, p.unit, 5)),
          {.key = p.name}));
  }
  return parameters;
}

std::vector<std::string> names_of_moving(const Calibration& result) {
  std::vector<std::string> names;
  for (const record::Parameter& p : result.parameters)
    if (!p.held) names.push_back(p.name);
  return names;
}

/// A fit, and what it was made of.
struct Fitted {
  Calibration calibration{};
  Weighed weighed{};
  fit::Response response{};
  fit::ResponseFit fit{};
};

/// Nothing moves: the readings of the model as it stands.
void take_as_it_is(const Fitted& at, const fit::Subject& started, Calibration& result) {
  const fit::Observations& observed = at.weighed.problem.observed;
  result.subject = started.with_values({});
  result.status = fit::FitStatus::nothing_to_fit;
  result.degrees_of_freedom = static_cast<int>(observed.size());
  const auto size = static_cast<Eigen::Index>(result.parameters.size());
  result.correlation = Eigen::MatrixXd::Constant(size, size, unset);
  const Eigen::VectorXd readings = at.response.readings({});
  set_errors(observed, readings, &ChannelError::rmse_after, result);
  const fit::Whitening& whitening = at.weighed.whitening;
  const double misfit = whitening(Eigen::VectorXd(observed.measured - readings)).squaredNorm();
  result.likelihood =
      likelihood_of_fit(misfit, observed, whitening, at.weighed.noise_known, result);
}

/// A fit of the parameters that are not held; `weighed` is its own.
Fitted fit_once(const fit::Subject& started, const std::optional<Evidence>& evidence,
                Weighed weighed, Calibration result) {
  const std::vector<std::string> moving = names_of_moving(result);
  Fitted made{.weighed = std::move(weighed)};
  const fit::Problem& problem = made.weighed.problem;
  const fit::Observations& observed = problem.observed;
  fit::Response& response = made.response =
      fit::response_of(started, problem.record, observed, moving, problem.prepared);
  if (moving.empty()) {
    take_as_it_is(made, started, result);
    made.calibration = std::move(result);
    return made;
  }
  response.find_affine_form();
  const bool known =
      evidence && moving == evidence->problem.base && problem.record == evidence->problem.record;
  const Eigen::VectorXd x = response.start();
  made.fit = known ? evidence->base
                   : fit::fit_response(response, made.weighed.whitening, observed.measured,
                                       {x, 0.8 * x, 1.25 * x, 0.5 * x});
  if (made.weighed.as_declared)
    made.fit = fit_with_excess(response, std::move(made.fit), made.weighed, result);
  take_fit(response, made.fit, observed, made.weighed.whitening, made.weighed.noise_known, result);
  if (made.weighed.by_misfit) result.likelihood.deviance = unset;
  result.subject = started.with_values(named_values(result.parameters));
  made.calibration = std::move(result);
  return made;
}

/// The interval of every parameter that moved; none where there are no standard errors.
void profile(Fitted& made) {
  Calibration& result = made.calibration;
  if (!result.converged()) return;
  const bool none = std::isnan(result.error_factor);
  std::size_t moved = 0;
  for (const record::Parameter& p : result.parameters)
    result.profile.push_back(
        p.held || none
            ? fit::ProfileInterval()
            : fit::profile_interval(made.response, made.fit, made.weighed.whitening,
                                    made.weighed.problem.measured(), moved++, result.error_factor));
}

/// The last parameter of a fit that the data could tell at its start and cannot tell where the fit
/// has carried it; null where they hold all.
const record::Parameter* adrift(const Calibration& before, const Calibration& fitted) {
  for (std::size_t k = fitted.parameters.size(); k-- > 0;)
    if (before.parameters[k].identifiable && !fitted.parameters[k].identifiable)
      return &fitted.parameters[k];
  return nullptr;
}

/// Where the data do not hold a parameter, the value that a fit gives it says nothing: it stays at
/// its start, and the others are fitted again.
Calibration fit_moving(const fit::Subject& started, const std::optional<Evidence>& evidence,
                       const Weighed& weighed, Calibration result,
                       const CalibrateOptions& options) {
  for (;;) {
    Fitted made = fit_once(started, evidence, weighed, result);
    Calibration& fitted = made.calibration;
    const record::Parameter* const lost = fitted.converged() ? adrift(result, fitted) : nullptr;
    if (!lost) {
      for (const record::Parameter& p : fitted.parameters)
        if (const std::string needed = p.held ? "" : started.lacks(p.name, *weighed.problem.record);
            !needed.empty())
          fitted.messages.push_back(record::note::not_identifiable(
              fmt::format("the value of {} is uncertain: {} needs {}", p.name, p.name, needed),
              {.key = p.name}));
      if (options.profile) profile(made);
      return std::move(fitted);
    }
    record::Parameter& p =
        result.parameters[static_cast<std::size_t>(lost - fitted.parameters.data())];
    p.held = true;
    p.identifiable = false;
    const std::string carried = with_unit(lost->value, p.unit, 5),
                      held = with_unit(p.value, p.unit, 5);
    if (const std::string needed = started.lacks(p.name, *weighed.problem.record);
        !needed.empty()) {
      result.messages.push_back(
          record::note::not_identifiable(not_identifiable(p, needed), {.key = p.name}));
      continue;
    }
    result.messages.push_back(record::note::not_identifiable(
        lost->at_bound != record::Bound::none
            ? fmt::format("these data do not determine {}: the fit ends at a bound of this "
                          "parameter, {}, so the program keeps it at {}. Check sign and unit "
                          "of the readings",
                          p.name, carried, held)
            : fmt::format(
                  "these data do not determine {}: at the fitted value, {}, its standard error is "
                  "larger than the distance between its bounds, or other parameters change the "
                  "readings in the same way. The program keeps this parameter at {}",
                  p.name, carried, held),
        {.key = p.name}));
  }
}

}  // namespace

Calibration calibrate_by_noise(const fit::Subject& subject, const record::Record& record,
                               const CalibrateOptions& options) {
  subject.require(record);
  Calibration result;
  result.parameters = starting(subject, result);
  const auto started = subject.with_values(named_values(result.parameters));
  const std::optional<Evidence> evidence = evidence_of(*started, record);
  if (evidence)
    result.messages.insert(result.messages.end(), evidence->notes.begin(), evidence->notes.end());
  Weighed weighed = weigh(*started, record, evidence, result.messages);
  const fit::Problem& problem = weighed.problem;
  const fit::Observations& observed = problem.observed;
  result.rows = static_cast<int>(record.rows() - problem.not_predicted.size());
  result.rows_not_predicted = problem.not_predicted;
  const std::size_t count = result.parameters.size();
  if (static_cast<std::size_t>(observed.size()) < count)
    throw std::invalid_argument(
        fmt::format("{}: number of readings that can be predicted: {}, number of free parameters: "
                    "{}. A fit needs at least one reading for each free parameter",
                    record.source, observed.size(), count));
  if (!problem.not_predicted.empty())
    result.messages.push_back(
        record::note::rows_used(fmt::format("{} of {} rows have no prediction and are not used",
                                            problem.not_predicted.size(), record.rows())));
  const auto response_by = [&](const fit::Subject& of, const std::vector<std::string>& names) {
    return fit::response_of(of, problem.record, observed, names, problem.prepared);
  };
  set_errors(observed, response_by(subject, {}).readings({}), &ChannelError::rmse_before, result);
  hold_dependent(
      response_by(*started, started->free()), weighed.whitening,
      [&](const std::string& parameter) { return started->lacks(parameter, *problem.record); },
      result);
  return fit_moving(*started, evidence, weighed, std::move(result), options);
}

Calibration calibration_of(std::shared_ptr<const fit::Subject> fitted,
                           const fit::Response& response, const fit::ResponseFit& fit,
                           const fit::Observations& observed, const Eigen::VectorXd& before,
                           const fit::Whitening& whitening) {
  Calibration result{.subject = std::move(fitted)};
  result.parameters = response.parameters;
  result.rows = static_cast<int>(observed.size());
  set_errors(observed, before, &ChannelError::rmse_before, result);
  take_fit(response, fit, observed, whitening, true, result);
  return result;
}

std::optional<fit::Covariance> covariance_of(const Calibration& calibration) {
  std::vector<Eigen::Index> sure;
  fit::Covariance result;
  for (std::size_t k = 0; k < calibration.parameters.size(); ++k) {
    const record::Parameter& p = calibration.parameters[k];
    if (!std::isfinite(p.std)) continue;
    sure.push_back(static_cast<Eigen::Index>(k));
    result.names.push_back(p.name);
  }
  if (sure.empty()) return std::nullopt;
  const auto size = static_cast<Eigen::Index>(sure.size());
  result.values.resize(size);
  Eigen::VectorXd std(size);
  for (Eigen::Index k = 0; k < size; ++k) {
    const record::Parameter& p =
        calibration.parameters[static_cast<std::size_t>(sure[static_cast<std::size_t>(k)])];
    result.values[k] = p.value;
    std[k] = p.std;
  }
  result.matrix =
      std.asDiagonal() * Eigen::MatrixXd(calibration.correlation(sure, sure)) * std.asDiagonal();
  return result;
}

}  // namespace raceway::verdict
