#include "fit/calibrate.h"

#include <fmt/format.h>

#include <algorithm>
#include <boost/math/distributions/chi_squared.hpp>
#include <cmath>
#include <optional>
#include <stdexcept>

#include "fit/approximation_loop.h"
#include "fit/identifiability.h"
#include "fit/verdict_text.h"

namespace raceway::fit {

namespace {

constexpr double beyond_chance = 0.01;  // of a misfit against the noise

/// Readings, what they are weighed by, and whether that is their noise.
struct Weighed {
  Problem problem{};
  Whitening whitening{};
  bool noise_known = false;
  bool as_declared = false;  ///< by declared deviations alone, which may not be all of the noise
};

/// All rows of a record that can be predicted, without candidates.
Problem plain_problem(const Subject& subject, const Record& record) {
  Problem problem;
  problem.subject = subject.with_values({});
  std::vector<std::size_t> order = order_of_rows(record);
  if (subject.has_memory())
    for (std::size_t i = 0; i < order.size(); ++i) order[i] = i;
  problem.record = std::make_shared<const Record>(record.picked(order));
  problem.rows = std::move(order);
  problem.prepared = subject.prepare(*problem.record);
  const std::vector<double> predicted = predict(subject, *problem.record);
  problem.observed = observe(subject.measured(), *problem.record, predicted);
  std::vector<std::size_t> read;
  for (std::size_t c = 0; c < problem.observed.channels.size(); ++c)
    if (problem.observed.size(c) > 0) read.push_back(c);
  if (read.size() < problem.observed.channels.size())
    problem.observed = problem.observed.only(read);
  const std::vector<Measured>& channels = problem.observed.channels;
  for (std::size_t i = 0; i < problem.rows.size(); ++i)
    for (std::size_t c = 0; c < channels.size(); ++c)
      if (std::isfinite(problem.record->value(*channels[c].channel, i)) &&
          !std::isfinite(predicted[problem.observed.place[c] * problem.rows.size() + i]))
        problem.not_predicted.push_back(problem.rows[i]);
  std::sort(problem.not_predicted.begin(), problem.not_predicted.end());
  return problem;
}

/// Where the data cannot tell their noise: declared deviations, or all readings of a channel alike.
void weigh_plainly(Weighed& weighed, std::vector<std::string>& messages) {
  const Problem& problem = weighed.problem;
  std::vector<Whitening> parts;
  weighed.noise_known = true;
  for (std::size_t c = 0; c < problem.observed.channels.size(); ++c) {
    const ChannelReadings readings = readings_of(*problem.record, problem.observed, c);
    if (readings.std.size() > 0) {
      parts.emplace_back(readings.std, RowOrder{}, 0.0, 0.0);
      continue;
    }
    weighed.noise_known = false;
    if (const record::Column* const some =
            problem.record->deviation_of(*problem.observed.channels[c].channel);
        some &&
        std::any_of(some->values.begin(), some->values.end(), [](double s) { return s > 0.0; }))
      messages.emplace_back("not every row has a standard deviation: all rows weigh the same");
    const double size = readings.measured.size() > 0 ? rms(readings.measured) : 1.0;
    parts.emplace_back(Eigen::VectorXd::Constant(readings.measured.size(), size > 0.0 ? size : 1.0),
                       RowOrder{}, 0.0, 0.0);
  }
  weighed.whitening = Whitening(parts);
  weighed.as_declared = weighed.noise_known;
}

/// The noise that a thinned record has shown, on all of its rows.
void weigh_as(const Evidence& evidence, const Response& response, Weighed& weighed) {
  const Problem& problem = weighed.problem;
  const Eigen::VectorXd size =
      floored(weighed.problem.observed, response.readings(evidence.base.values), 1.0);
  std::vector<Whitening> parts;
  for (std::size_t c = 0; c < problem.observed.channels.size(); ++c)
    parts.push_back(whitening_of(evidence.noise[c],
                                 readings_of(*problem.record, problem.observed, c),
                                 problem.observed.of(c, size)));
  weighed.whitening = Whitening(parts);
  weighed.noise_known = true;
}

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

/// Nothing where the data cannot carry a diagnosis.
std::optional<Evidence> evidence_of(const Subject& subject, const Record& record) {
  try {
    return gather_evidence(subject, record, {.screened = false});
  } catch (const std::invalid_argument&) {
    return std::nullopt;
  }
}

/// By what standard errors are widened: against known noise where the misfit exceeds it, otherwise
/// by the misfit itself.
double error_factor(double misfit, bool noise_known, Calibration& result) {
  const int freedom = result.degrees_of_freedom;
  if (freedom < 1) {
    if (noise_known) return 1.0;
    result.messages.emplace_back("as many rows as parameters: no standard errors");
    return unset;
  }
  const double reduced = misfit / freedom;
  if (!noise_known) return std::sqrt(reduced);
  result.reduced_chi_square = reduced;
  const double p = boost::math::cdf(
      boost::math::complement(boost::math::chi_squared(static_cast<double>(freedom)), misfit));
  if (p >= beyond_chance) return 1.0;
  result.messages.push_back(fmt::format(
      "the misfit exceeds the noise of the data (chi2/dof = {:.3g}): standard errors are widened "
      "by {:.3g}, and do not cover what a missing effect does to the values",
      reduced, std::sqrt(reduced)));
  return std::sqrt(reduced);
}

void tell_bounds(Calibration& result) {
  for (const Parameter& p : result.parameters)
    if (p.at_bound != Bound::none)
      result.messages.push_back(fmt::format(
          "{} ends at its {} bound, {}: the data want it beyond, or the model lacks something",
          p.name, p.at_bound == Bound::lower ? "lower" : "upper", with_unit(p.value, p.unit, 5)));
}

/// The error of every channel at these readings.
void set_errors(const Observations& observed, const Eigen::VectorXd& readings,
                double ChannelError::*rmse, Calibration& result) {
  result.channels.resize(observed.channels.size());
  for (std::size_t c = 0; c < observed.channels.size(); ++c) {
    result.channels[c].channel = observed.channels[c].channel;
    result.channels[c].*rmse = rms(observed.of(c, Eigen::VectorXd(readings - observed.measured)));
  }
}

/// Puts the values of a fit into the parameters that moved, and says what they are worth.
void take_fit(const Response& response, const ResponseFit& fit, const Observations& observed,
              const Whitening& whitening, bool noise_known, Calibration& result) {
  result.status = fit.converged ? FitStatus::converged : FitStatus::failed;
  result.iterations = fit.iterations;
  if (!fit.converged) {
    result.messages.emplace_back(
        "the fit did not converge: no minimum was reached from two starts");
    return;
  }
  std::size_t moved = 0;
  for (Parameter& p : result.parameters) {
    if (p.held) continue;
    const Parameter fitted = fit.fitted(response, moved++);
    p.value = fitted.value;
    p.at_bound = fitted.at_bound;
    if (p.at_bound != Bound::none) p.value = p.at_bound == Bound::lower ? p.lower : p.upper;
  }
  result.degrees_of_freedom = static_cast<int>(observed.size()) - static_cast<int>(moved);
  set_errors(observed, fit.prediction, &ChannelError::rmse_after, result);
  tell_bounds(result);
  for (const ChannelError& c : result.channels)
    if (c.rmse_after > c.rmse_before)
      result.messages.push_back(fmt::format(
          "the RMS error of {} rises, {:.4g} -> {}: readings are weighed by their noise, not all "
          "alike",
          c.channel->words, c.rmse_before / c.channel->factor,
          reading_text(*c.channel, c.rmse_after, 4)));
  const double factor = error_factor(fit.misfit, noise_known, result);
  const Eigen::MatrixXd jacobian = whitening(fit.slope);
  estimate_errors(jacobian, factor, result);
}

/// Fits again with the common scatter that explains a misfit beyond the declared deviations, until
/// that stays the same: without it a model that misses something would be bent to the few quietest
/// rows, and be far too sure of its parameters.
ResponseFit fit_with_excess(const Response& response, const Observations& observed, ResponseFit fit,
                            Whitening& whitening, Calibration& result) {
  const Whitening declared = whitening;
  const std::size_t channels = observed.channels.size();
  std::vector<double> excess(channels, 0.0);
  const auto share =
      static_cast<double>(response.parameters.size()) / static_cast<double>(observed.size());
  double chi_square = unset;
  for (int round = 0; round < 50 && fit.converged; ++round) {
    const Eigen::VectorXd errors = fit.prediction - observed.measured;
    chi_square = declared(errors).squaredNorm();
    std::vector<Whitening> parts;
    bool settled = true;
    for (std::size_t c = 0; c < channels; ++c) {
      const Eigen::VectorXd std = observed.of(c, declared.std());
      const double before = excess[c];
      excess[c] = excess_scatter(observed.of(c, errors), std,
                                 static_cast<double>(observed.size(c)) * (1.0 - share));
      settled = settled && std::abs(excess[c] - before) <= 1e-6 * excess[c];
      parts.emplace_back((std.array().square() + excess[c] * excess[c]).sqrt().matrix(), RowOrder{},
                         0.0, 0.0);
    }
    if (settled) break;
    whitening = Whitening(parts);
    const Eigen::VectorXd x = fit.values;
    fit = fit_response(response, whitening, observed.measured, {x, 0.8 * x, 1.25 * x, 0.5 * x});
  }
  for (std::size_t c = 0; c < channels; ++c)
    if (excess[c] > 0.0)
      result.messages.push_back(
          fmt::format("misfit exceeds the standard deviations of the rows (chi2/dof = {:.3g}); {} "
                      "were added to "
                      "each, by which weights are evened out and standard errors are widened",
                      chi_square / (static_cast<double>(observed.size()) * (1.0 - share)),
                      reading_text(*observed.channels[c].channel, excess[c])));
  return fit;
}

std::vector<NamedValue> named_values(const std::vector<Parameter>& parameters) {
  std::vector<NamedValue> values;
  for (const Parameter& p : parameters) values.push_back({p.name, p.value});
  return values;
}

/// The parameters as a fit takes them: inside their bounds.
std::vector<Parameter> starting(const Subject& subject, Calibration& result) {
  std::vector<Parameter> parameters = find_parameters(subject, subject.free());
  for (Parameter& p : parameters) {
    p.value = std::clamp(p.start, p.lower, p.upper);
    if (p.value != p.start)
      result.messages.push_back(fmt::format("{} = {} is outside its bounds: the fit starts at {}",
                                            p.name, with_unit(p.start, p.unit, 5),
                                            with_unit(p.value, p.unit, 5)));
  }
  return parameters;
}

/// The readings and their weights; `evidence` where a diagnosis could be made.
Weighed weigh(const Subject& subject, const Record& record, const std::optional<Evidence>& evidence,
              std::vector<std::string>& messages) {
  if (evidence && evidence->rows() + evidence->problem.not_predicted.size() == record.rows())
    return {evidence->problem, evidence->whitening, true};
  Weighed weighed{.problem = plain_problem(subject, record)};
  if (evidence && evidence->noise.size() == weighed.problem.observed.channels.size())
    weigh_as(*evidence,
             response_of(subject, weighed.problem.record, weighed.problem.observed,
                         evidence->problem.base, weighed.problem.prepared),
             weighed);
  else
    weigh_plainly(weighed, messages);
  return weighed;
}

std::vector<std::string> names_of_moving(const Calibration& result) {
  std::vector<std::string> names;
  for (const Parameter& p : result.parameters)
    if (!p.held) names.push_back(p.name);
  return names;
}

/// A fit of the parameters that are not held; `weighed` is its own.
Calibration fit_once(const Subject& started, const std::optional<Evidence>& evidence,
                     Weighed weighed, Calibration result) {
  const Problem& problem = weighed.problem;
  const Observations& observed = problem.observed;
  const std::vector<std::string> moving = names_of_moving(result);
  Response response = response_of(started, problem.record, observed, moving, problem.prepared);
  if (moving.empty()) {
    result.subject = started.with_values({});
    result.status = FitStatus::nothing_to_fit;
    result.degrees_of_freedom = static_cast<int>(observed.size());
    const auto size = static_cast<Eigen::Index>(result.parameters.size());
    result.correlation = Eigen::MatrixXd::Constant(size, size, unset);
    set_errors(observed, response.readings({}), &ChannelError::rmse_after, result);
    return result;
  }
  response.find_affine_form();
  const bool made =
      evidence && moving == evidence->problem.base && problem.record == evidence->problem.record;
  const Eigen::VectorXd x = response.start();
  ResponseFit fit = made ? evidence->base
                         : fit_response(response, weighed.whitening, observed.measured,
                                        {x, 0.8 * x, 1.25 * x, 0.5 * x});
  if (weighed.as_declared)
    fit = fit_with_excess(response, observed, std::move(fit), weighed.whitening, result);
  take_fit(response, fit, observed, weighed.whitening, weighed.noise_known, result);
  result.subject = started.with_values(named_values(result.parameters));
  return result;
}

/// The last parameter of a fit that the data could tell at its start and cannot tell where the fit
/// has carried it; null where they hold all.
const Parameter* adrift(const Calibration& before, const Calibration& fitted) {
  for (std::size_t k = fitted.parameters.size(); k-- > 0;)
    if (before.parameters[k].identifiable && !fitted.parameters[k].identifiable)
      return &fitted.parameters[k];
  return nullptr;
}

/// Where the data do not hold a parameter, the value that a fit gives it says nothing: it stays at
/// its start, and the others are fitted again.
Calibration fit_moving(const Subject& started, const std::optional<Evidence>& evidence,
                       const Weighed& weighed, Calibration result) {
  for (;;) {
    Calibration fitted = fit_once(started, evidence, weighed, result);
    const Parameter* const lost = fitted.converged() ? adrift(result, fitted) : nullptr;
    if (!lost) {
      for (const Parameter& p : fitted.parameters)
        if (const std::string needed = p.held ? "" : started.lacks(p.name, *weighed.problem.record);
            !needed.empty())
          fitted.messages.push_back(
              fmt::format("{} needs {}: its value says little", p.name, needed));
      return fitted;
    }
    Parameter& p = result.parameters[static_cast<std::size_t>(lost - fitted.parameters.data())];
    p.held = true;
    p.identifiable = false;
    const std::string carried = with_unit(lost->value, p.unit, 5),
                      held = with_unit(p.value, p.unit, 5);
    if (const std::string needed = started.lacks(p.name, *weighed.problem.record);
        !needed.empty()) {
      result.messages.push_back(not_identifiable(p, needed));
      continue;
    }
    result.messages.push_back(
        lost->at_bound != Bound::none
            ? fmt::format("{} is not fixed by these data: a fit carries it to its bound, {}; it is "
                          "held at {}. Do sign and unit of the readings agree with the model?",
                          p.name, carried, held)
            : fmt::format(
                  "{} is not fixed by these data: a fit carries it to {}, where a change as "
                  "large as its range is lost in the noise; it is held at {}",
                  p.name, carried, held));
  }
}

}  // namespace

Calibration calibrate(const Subject& subject, const Record& record) {
  if (subject.approximates()) return calibrate_approximation(subject, record);
  subject.require(record);
  Calibration result;
  result.parameters = starting(subject, result);
  const auto started = subject.with_values(named_values(result.parameters));
  const std::optional<Evidence> evidence = evidence_of(*started, record);
  if (evidence)
    result.messages.insert(result.messages.end(), evidence->notes.begin(), evidence->notes.end());
  Weighed weighed = weigh(*started, record, evidence, result.messages);
  const Problem& problem = weighed.problem;
  const Observations& observed = problem.observed;
  result.rows = static_cast<int>(record.rows() - problem.not_predicted.size());
  result.rows_not_predicted = problem.not_predicted;
  const std::size_t count = result.parameters.size();
  if (static_cast<std::size_t>(observed.size()) < count)
    throw std::invalid_argument(fmt::format(
        "{}: {} rows can be predicted, {} parameters are free: at least as many rows as parameters "
        "are needed",
        record.source, observed.size(), count));
  if (!problem.not_predicted.empty())
    result.messages.push_back(fmt::format("{} of {} rows have no prediction and are not used",
                                          problem.not_predicted.size(), record.rows()));
  const auto response_by = [&](const Subject& of, const std::vector<std::string>& names) {
    return response_of(of, problem.record, observed, names, problem.prepared);
  };
  set_errors(observed, response_by(subject, {}).readings({}), &ChannelError::rmse_before, result);
  hold_dependent(
      response_by(*started, started->free()), weighed.whitening,
      [&](const std::string& parameter) { return started->lacks(parameter, *problem.record); },
      result);
  return fit_moving(*started, evidence, weighed, std::move(result));
}

Calibration calibration_of(std::shared_ptr<const Subject> fitted, const Response& response,
                           const ResponseFit& fit, const Observations& observed,
                           const Eigen::VectorXd& before, const Whitening& whitening) {
  Calibration result{.subject = std::move(fitted)};
  result.parameters = response.parameters;
  result.rows = static_cast<int>(observed.size());
  set_errors(observed, before, &ChannelError::rmse_before, result);
  take_fit(response, fit, observed, whitening, true, result);
  return result;
}

std::optional<Covariance> covariance_of(const Calibration& calibration) {
  std::vector<Eigen::Index> sure;
  Covariance result;
  for (std::size_t k = 0; k < calibration.parameters.size(); ++k) {
    const Parameter& p = calibration.parameters[k];
    if (!std::isfinite(p.std)) continue;
    sure.push_back(static_cast<Eigen::Index>(k));
    result.names.push_back(p.name);
  }
  if (sure.empty()) return std::nullopt;
  const auto size = static_cast<Eigen::Index>(sure.size());
  result.values.resize(size);
  Eigen::VectorXd std(size);
  for (Eigen::Index k = 0; k < size; ++k) {
    const Parameter& p =
        calibration.parameters[static_cast<std::size_t>(sure[static_cast<std::size_t>(k)])];
    result.values[k] = p.value;
    std[k] = p.std;
  }
  result.matrix =
      std.asDiagonal() * Eigen::MatrixXd(calibration.correlation(sure, sure)) * std.asDiagonal();
  return result;
}

}  // namespace raceway::fit
