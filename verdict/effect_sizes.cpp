#include "verdict/effect_sizes.h"

#include <fmt/format.h>

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <utility>

#include "algebra/detail/decompositions.h"
#include "fit/distributions.h"
#include "fit/profile_interval.h"
#include "fit/row_order.h"
#include "fit/subspace.h"
#include "verdict/search.h"
#include "verdict/verdict_text.h"

namespace raceway::verdict {

namespace {

constexpr double plausible_factor = 3.0;
constexpr double seen_within_blocks = 6.63;  // of -2 ln L: 1 % of one parameter
constexpr double collinear = 1e-9;           // of a squared length

/// Where the parameters of a member begin.
std::size_t begin_of(const fit::Problem& problem, const Explanation& e, std::size_t member) {
  std::size_t at = problem.base.size();
  for (const std::size_t k : e.members) {
    if (k == member) break;
    at += problem.candidates[k].candidate.parameters.size();
  }
  return at;
}

/// One column for each block of rows that may be an undeclared run, or for each run where the data
/// do not show by how much runs differ: 1 at its readings.
Eigen::MatrixXd block_offsets(const Evidence& evidence) {
  const fit::Problem& problem = evidence.problem;
  const fit::Observations& observed = problem.observed;
  std::vector<Eigen::VectorXd> offsets;
  for (std::size_t c = 0; c < observed.channels.size(); ++c) {
    const fit::RowOrder order = fit::row_order(*problem.record, observed.rows(c));
    const bool of_runs = order.has_runs && evidence.noise[c].unknown_runs;
    const std::vector<bool>& new_block = of_runs ? order.new_run : order.new_block;
    for (std::size_t i = 0; i < new_block.size(); ++i) {
      if (new_block[i]) offsets.emplace_back(Eigen::VectorXd::Zero(observed.size()));
      offsets.back()[observed.first[c] + static_cast<Eigen::Index>(i)] = 1.0;
    }
  }
  Eigen::MatrixXd columns(observed.size(), static_cast<Eigen::Index>(offsets.size()));
  for (std::size_t k = 0; k < offsets.size(); ++k)
    columns.col(static_cast<Eigen::Index>(k)) = offsets[k];
  return columns;
}

std::vector<double> list(const Eigen::VectorXd& v) { return {v.data(), v.data() + v.size()}; }

/// Over all blockings, of each channel; with the ends of an input's range held out or not.
std::vector<double> held_out_errors_of(const Evidence& evidence, const fit::Response& response,
                                       const fit::ResponseFit& fit,
                                       const std::vector<fit::Blocking>& blockings,
                                       bool within_range) {
  const fit::Observations& observed = evidence.problem.observed;
  if (!response.readings || blockings.empty()) return {};
  std::vector<double> result(observed.channels.size(), 0.0);
  for (const fit::Blocking& b : blockings) {
    Eigen::VectorXd errors =
        fit::held_out_errors(response, fit, observed.measured, evidence.std(), b);
    if (within_range && b.ordered)
      for (Eigen::Index i = 0; i < errors.size(); ++i)
        if (const int block = b.block[static_cast<std::size_t>(i)];
            block == 0 || block == b.blocks - 1)
          errors[i] = observed.measured[i] - fit.prediction[i];
    for (std::size_t c = 0; c < result.size(); ++c)
      result[c] += observed.of(c, errors).squaredNorm() / static_cast<double>(observed.size(c));
  }
  for (double& square : result) square = std::sqrt(square / static_cast<double>(blockings.size()));
  return result;
}

}  // namespace

bool is_plausible(const record::Parameter& p, double factor) {
  const double margin = std::isfinite(p.std) ? 2.0 * p.std : 0.0;
  const double neutral = std::isnan(p.neutral) ? 0.0 : p.neutral;
  const auto limit = [&](double given, double bound) {  // without a range met in practice any size
    return (std::isnan(given) ? bound : given) - neutral;
  };
  double low = limit(p.plausible_lower, p.lower);
  double high = limit(p.plausible_upper, p.upper);
  // Little of an effect is not implausible; a shape has no neutral value to be near to.
  if (!std::isnan(p.neutral)) {
    low = std::min(low, 0.0);
    high = std::max(high, 0.0);
  }
  const double value = p.value - neutral;
  return value - margin <= (high > 0.0 ? high * factor : high / factor) &&
         value + margin >= (low > 0.0 ? low / factor : low * factor);
}

std::string correction_text(const fit::Problem& problem, const Explanation& e, std::size_t member) {
  const fit::Candidate& c = problem.candidates[member].candidate;
  std::vector<double> values;
  for (std::size_t j = 0; j < c.parameters.size(); ++j)
    values.push_back(e.fit.values[static_cast<Eigen::Index>(begin_of(problem, e, member) + j)]);
  return problem.subject->correction(c.id, values);
}

std::vector<record::Parameter> sizes_of(const fit::Problem& problem, const Explanation& e,
                                        std::size_t member) {
  std::vector<record::Parameter> sizes;
  const fit::Candidate& c = problem.candidates[member].candidate;
  const std::size_t begin = begin_of(problem, e, member);
  for (std::size_t j = 0; j < c.parameters.size(); ++j) {
    record::Parameter p = c.parameters[j];
    const auto at = static_cast<Eigen::Index>(begin + j);
    p.name = c.short_name(j);
    p.value = e.fit.values[at];
    p.std = e.fit.standard_errors[at];
    if (e.fit.at_bound[begin + j])
      p.at_bound =
          p.value - p.lower <= p.upper - p.value ? record::Bound::lower : record::Bound::upper;
    // Physics may go beyond what was published of it; a datum is wrong by what people get wrong.
    p.plausible = is_plausible(p, c.datum.empty() ? plausible_factor : 1.0);
    sizes.push_back(std::move(p));
  }
  return sizes;
}

bool sizes_plausible(const fit::Problem& problem, const Explanation& e) {
  for (const std::size_t k : e.members)
    if (!sizes_of(problem, e, k)[problem.candidates[k].candidate.size].plausible) return false;
  return true;
}

std::string size_text(const fit::Problem& problem, const Explanation& e) {
  std::vector<std::string> texts;
  for (const std::size_t k : e.members) {
    const record::Parameter s = sizes_of(problem, e, k)[problem.candidates[k].candidate.size];
    std::string text = fmt::format("{} = {:.3g}", s.name, s.value);
    if (std::isfinite(s.std)) text += fmt::format(" +- {:.2g}", s.std);
    if (s.unit != "1") text += " " + s.unit;
    texts.push_back(std::move(text));
  }
  return joined(texts, "and");
}

record::Interval size_interval(const Evidence& evidence, const Explanation& e, std::size_t member) {
  if (e.elastic) return {};
  const fit::Problem& problem = evidence.problem;
  const fit::ProfileInterval found = fit::profile_interval(
      e.response, e.fit, evidence.whitening, problem.measured(),
      begin_of(problem, e, member) + problem.candidates[member].candidate.size);
  return {found.lower, found.upper};
}

double chance_of_block_offsets(const Evidence& evidence, const Explanation& e, std::size_t member) {
  const fit::Problem& problem = evidence.problem;
  const Eigen::MatrixXd offsets = block_offsets(evidence);
  if (offsets.cols() == 0 || e.elastic) return unset;
  const auto size = static_cast<Eigen::Index>(begin_of(problem, e, member) +
                                              problem.candidates[member].candidate.size);
  const Eigen::MatrixXd slope = evidence.whitening(e.fit.slope);
  const double neutral = problem.candidates[member].size().neutral;
  const Eigen::VectorXd change = slope.col(size);
  const Eigen::VectorXd without =
      e.fit.residual + (e.fit.values[size] - (std::isnan(neutral) ? 0.0 : neutral)) * change;
  const auto columns = slope.cols(), blocks = offsets.cols();
  Eigen::MatrixXd others(slope.rows(), columns - 1 + blocks);
  others << slope.leftCols(size), slope.rightCols(columns - size - 1), evidence.whitening(offsets);
  Eigen::MatrixXd both(slope.rows(), 2);
  both << change, without;
  /// Gain of the change, and the square that it leaves, beside the first `count` other columns.
  const auto gain_beside = [&](Eigen::Index count) {
    const Eigen::MatrixXd left = fit::project_off(others.leftCols(count), both);
    const double length = left.col(0).squaredNorm();
    const double gain = length > collinear * change.squaredNorm()
                            ? std::pow(left.col(0).dot(left.col(1)), 2) / length
                            : 0.0;
    return std::pair{gain, left.col(1).squaredNorm() - gain};
  };
  const auto [gain, left] = gain_beside(columns - 1);
  const auto [within, left_by_blocks] = gain_beside(columns - 1 + blocks);
  if (within > seen_within_blocks) return 0.0;
  // One step of the zero, from some block on, may do as well.
  if (problem.observed.channels.size() == 1) {
    Eigen::VectorXd step = Eigen::VectorXd::Zero(slope.rows());
    for (Eigen::Index b = blocks - 1; b > 0; --b) {
      step += others.col(columns - 1 + b);
      both.col(0) = step;
      if (gain_beside(columns - 1).first >= gain - within_reach) return 1.0;
    }
  }
  // The first offset and the change itself are fitted.
  const auto degrees = static_cast<double>(blocks - 2);
  if (!(degrees > 0.0)) return 1.0;
  return fit::f_above(1.0, degrees, gain / std::max(1.0, (left - left_by_blocks) / degrees));
}

std::vector<record::Parameter> base_with(const Evidence& evidence, const Explanation& e) {
  std::vector<record::Parameter> base;
  for (std::size_t k = 0; k < evidence.problem.base.size(); ++k) {
    const auto at = static_cast<Eigen::Index>(k);
    record::Parameter p = evidence.response.parameters[k];
    p.start = evidence.base.values[at];
    p.value = e.fit.values[at];
    p.std = e.fit.standard_errors[at];
    base.push_back(std::move(p));
  }
  return base;
}

std::vector<record::Parameter> base_alone(const Evidence& evidence) {
  std::vector<record::Parameter> base;
  const fit::Likelihood likelihood = likelihood_of(evidence, evidence.base);
  const double factor = fit::widening(likelihood.chi_square, likelihood.degrees_of_freedom());
  for (std::size_t k = 0; k < evidence.problem.base.size(); ++k) {
    record::Parameter p = evidence.base.fitted(evidence.response, k);
    p.start = p.value;
    p.std *= factor;
    base.push_back(std::move(p));
  }
  return base;
}

fit::Likelihood likelihood_of(const Evidence& evidence, const fit::ResponseFit& fit) {
  return likelihood_of(fit.misfit, evidence.whitening, static_cast<int>(fit.values.size()));
}

Correlation correlation_of(const std::vector<record::Parameter>& parameters,
                           const fit::ResponseFit& fit) {
  const auto count = static_cast<Eigen::Index>(parameters.size());
  Eigen::MatrixXd covariance = Eigen::MatrixXd::Constant(count, count, unset);
  std::vector<Eigen::Index> free;
  for (Eigen::Index k = 0; k < count; ++k)
    if (!fit.at_bound[static_cast<std::size_t>(k)]) free.push_back(k);
  if (!free.empty()) {
    const Eigen::MatrixXd moving = algebra::pseudo_inverse(fit.tangent.transpose() * fit.tangent);
    covariance(free, free) = moving;
  }
  return correlation_of(parameters, covariance);
}

Correlation correlation_of(const std::vector<record::Parameter>& parameters,
                           const Eigen::MatrixXd& covariance) {
  Correlation result;
  for (const record::Parameter& p : parameters) result.names.push_back(p.name);
  const Eigen::VectorXd std = covariance.diagonal().cwiseSqrt();
  result.matrix = covariance.cwiseQuotient(std * std.transpose());
  for (Eigen::Index k = 0; k < std.size(); ++k)
    if (std[k] > 0.0) result.matrix(k, k) = 1.0;
  return result;
}

std::vector<double> held_out(const Evidence& evidence, const fit::Response& response,
                             const fit::ResponseFit& fit,
                             const std::vector<fit::Blocking>& blockings) {
  return held_out_errors_of(evidence, response, fit, blockings, false);
}

std::vector<double> held_out_within_range(const Evidence& evidence, const fit::Response& response,
                                          const fit::ResponseFit& fit,
                                          const std::vector<fit::Blocking>& blockings) {
  return held_out_errors_of(evidence, response, fit, blockings, true);
}

ExplainedReadings explained_readings(const Evidence& evidence, const Explanation& e) {
  const fit::Problem& problem = evidence.problem;
  const auto without = [&](const std::vector<std::size_t>& members) {
    Eigen::VectorXd x = e.fit.values;
    for (const std::size_t k : members) {
      const fit::Candidate& c = problem.candidates[k].candidate;
      for (std::size_t j = 0; j < c.parameters.size(); ++j)
        if (!std::isnan(c.parameters[j].neutral))
          x[static_cast<Eigen::Index>(begin_of(problem, e, k) + j)] = c.parameters[j].neutral;
    }
    return e.response.at(x);
  };
  const Eigen::VectorXd& total = e.fit.prediction;
  ExplainedReadings result{.total = list(total), .base = list(without(e.members))};
  for (const std::size_t k : e.members)
    result.effects.push_back(
        {problem.candidates[k].id(), list(Eigen::VectorXd(total - without({k})))});
  return result;
}

}  // namespace raceway::verdict
