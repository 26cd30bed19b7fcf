#include "fit/costly_fit.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "fit/least_squares.h"

namespace raceway::fit {
namespace {

constexpr int most_descents = 12;
constexpr int most_attempts = 4;         // of one step, with rising damping
constexpr double far_step = 1.5;         // on the scale of a parameter
constexpr double share_of_value = 0.02;  // of a difference on the scale of logarithms, or
constexpr double share_of_size = 0.2;    // of a typical size
constexpr double endless = std::numeric_limits<double>::infinity();
constexpr double at_the_bound = 1e-4;

bool spans_a_decade(const Parameter& p) {
  return p.lower > 0.0 && std::isfinite(p.upper) && p.upper > 10.0 * p.lower;
}

/// Derivatives that agree with what a step has changed.
void update(Eigen::MatrixXd& slope, const Eigen::VectorXd& step, const Eigen::VectorXd& change) {
  const double length = step.squaredNorm();
  if (length > 0.0 && change.allFinite())
    slope += (change - slope * step) * step.transpose() / length;
}

}  // namespace

CostlyProblem::CostlyProblem(const Subject& subject, const Record& record,
                             const std::shared_ptr<const void>& prepared, const Means& means,
                             const std::vector<std::string>& names)
    : parameters_(find_parameters(subject, names)),
      means_(means),
      predictor_(subject.predictor(record, names, prepared)),
      measured_(means.size()),
      weight_(means.size()),
      all_(subject.measured().size() * record.rows()) {
  for (Eigen::Index i = 0; i < means.size(); ++i) {
    measured_[i] = means.list[static_cast<std::size_t>(i)].measured;
    weight_[i] = means.list[static_cast<std::size_t>(i)].weight;
  }
}

double CostlyProblem::to_scale(std::size_t k, double value) const {
  const Parameter& p = parameters_[k];
  return spans_a_decade(p) ? std::log(value) : value / p.scale;
}

double CostlyProblem::from_scale(std::size_t k, double at) const {
  const Parameter& p = parameters_[k];
  return std::clamp(spans_a_decade(p) ? std::exp(at) : at * p.scale, p.lower, p.upper);
}

double CostlyProblem::unit_of(std::size_t k, double value) const {
  const Parameter& p = parameters_[k];
  return spans_a_decade(p) ? value : p.scale;
}

SeparableFit CostlyProblem::at(const Eigen::VectorXd& values) const {
  predictor_->readings({values.data(), static_cast<std::size_t>(values.size())}, all_);
  SeparableFit fit{.values = values,
                   .at_bound = std::vector<bool>(parameters_.size(), false),
                   .residual = measured_};
  for (Eigen::Index i = 0; i < means_.size(); ++i) {
    const std::vector<Eigen::Index>& places = means_.list[static_cast<std::size_t>(i)].places;
    double sum = 0.0;
    for (const Eigen::Index place : places) sum += all_[static_cast<std::size_t>(place)];
    fit.residual[i] -= sum / static_cast<double>(places.size());
  }
  fit.misfit = weight_.cwiseProduct(fit.residual).squaredNorm();
  for (std::size_t k = 0; k < parameters_.size(); ++k) {
    const Parameter& p = parameters_[k];
    const double here = to_scale(k, values[static_cast<Eigen::Index>(k)]);
    fit.at_bound[k] = (std::isfinite(p.lower) && here <= to_scale(k, p.lower) + at_the_bound) ||
                      (std::isfinite(p.upper) && here >= to_scale(k, p.upper) - at_the_bound);
  }
  return fit;
}

Eigen::VectorXd CostlyProblem::difference(const SeparableFit& here, std::size_t k,
                                          double by) const {
  const auto place = static_cast<Eigen::Index>(k);
  const double from = to_scale(k, here.values[place]);
  for (const double way : {by, -by}) {
    Eigen::VectorXd other = here.values;
    other[place] = from_scale(k, from + way);
    const double went = to_scale(k, other[place]) - from;
    if (std::abs(went) < 0.5 * std::abs(by)) continue;  // beyond a bound
    const Eigen::VectorXd change = here.residual - at(other).residual;
    if (change.allFinite()) return change / went;
  }
  return Eigen::VectorXd::Zero(means_.size());
}

Eigen::MatrixXd CostlyProblem::differences(const SeparableFit& here) const {
  Eigen::MatrixXd slope(means_.size(), here.values.size());
  for (std::size_t k = 0; k < parameters_.size(); ++k)
    slope.col(static_cast<Eigen::Index>(k)) =
        difference(here, k, spans_a_decade(parameters_[k]) ? share_of_value : share_of_size);
  return slope;
}

CostlyFit CostlyProblem::from(const Eigen::VectorXd& start, double settled) const {
  SeparableFit first = at(start);
  if (!std::isfinite(first.misfit)) return {};
  Eigen::MatrixXd slope = differences(first);
  return descend(std::move(first), std::move(slope), true, settled, endless);
}

CostlyFit CostlyProblem::beyond(const CostlyFit& base, const Eigen::VectorXd& initial,
                                const std::vector<std::size_t>& sizes, double settled,
                                double hopeless) const {
  const Eigen::Index known = base.fit.values.size();
  SeparableFit first = base.fit;
  first.values = initial;
  first.values.head(known) = base.fit.values;
  first.at_bound.resize(parameters_.size(), false);
  first.converged = false;
  Eigen::MatrixXd slope = Eigen::MatrixXd::Zero(means_.size(), initial.size());
  for (Eigen::Index k = 0; k < known; ++k)
    slope.col(k) = base.slope.col(k) * unit_of(static_cast<std::size_t>(k), base.fit.values[k]);
  for (const std::size_t k : sizes)
    first.values[static_cast<Eigen::Index>(k)] = parameters_[k].neutral;
  for (const std::size_t k : sizes) {
    const auto place = static_cast<Eigen::Index>(k);
    double by = to_scale(k, initial[place]) - to_scale(k, parameters_[k].neutral);
    constexpr double none = 1e-9;
    if (!(std::abs(by) > none))
      by = spans_a_decade(parameters_[k]) ? 5.0 * share_of_value : share_of_size;
    slope.col(place) = difference(first, k, by);
  }
  return descend(std::move(first), std::move(slope), false, settled, hopeless);
}

CostlyFit CostlyProblem::descend(SeparableFit best, Eigen::MatrixXd slope, bool is_fresh,
                                 double settled, double hopeless) const {
  const Eigen::Index n = best.values.size();
  double damping = 1e-3;
  for (int step = 0; step < most_descents && !best.converged && n > 0; ++step) {
    ++best.iterations;
    Eigen::VectorXd here(n), lower(n), upper(n);
    for (Eigen::Index k = 0; k < n; ++k) {
      const auto place = static_cast<std::size_t>(k);
      const Parameter& p = parameters_[place];
      const double far = spans_a_decade(p) ? far_step : endless;
      here[k] = to_scale(place, best.values[k]);
      lower[k] = std::max(-far, to_scale(place, p.lower) - here[k]);
      upper[k] = std::min(far, to_scale(place, p.upper) - here[k]);
    }
    double fall = 0.0;
    bool better = false;
    for (int attempt = 0; attempt < most_attempts && !better; ++attempt) {
      const LeastSquares problem(weight_.asDiagonal() * slope, weight_.cwiseProduct(best.residual));
      Eigen::VectorXd d = Eigen::VectorXd::Zero(n), values(n), went(n);
      std::vector<int> side(static_cast<std::size_t>(n), 0);
      problem.solve(lower, upper, damping, d, side);
      if (problem.fall(d) <= settled * best.misfit) break;  // nothing more is to be had
      for (Eigen::Index k = 0; k < n; ++k) {
        const auto place = static_cast<std::size_t>(k);
        values[k] = from_scale(place, here[k] + d[k]);
        went[k] = to_scale(place, values[k]) - here[k];
      }
      SeparableFit next = at(values);
      if (std::isfinite(next.misfit)) update(slope, went, best.residual - next.residual);
      if (std::isfinite(next.misfit) && next.misfit < best.misfit) {
        fall = best.misfit - next.misfit;
        next.iterations = best.iterations;
        best = std::move(next);
        damping = std::max(1e-9, 0.2 * damping);
        better = true;
        is_fresh = false;
      } else {
        damping *= 10.0;
      }
    }
    if (better && fall > settled * best.misfit) continue;
    if (is_fresh || best.misfit > hopeless) {
      best.converged = true;
    } else {
      slope = differences(best);
      is_fresh = true;
      damping = 1e-3;
    }
  }
  if (!is_fresh && !(best.misfit > hopeless)) slope = differences(best);
  for (Eigen::Index k = 0; k < n; ++k)
    slope.col(k) /= unit_of(static_cast<std::size_t>(k), best.values[k]);
  return {std::move(best), std::move(slope)};
}

Eigen::VectorXd left_of_block(const CostlyFit& of, const std::vector<Parameter>& parameters,
                              const Means& means, int block) {
  const Eigen::Index n = of.fit.values.size();
  Eigen::VectorXd weight(means.size()), lower(n), upper(n), unit(n);
  for (Eigen::Index i = 0; i < means.size(); ++i) {
    const Means::Mean& mean = means.list[static_cast<std::size_t>(i)];
    weight[i] = mean.block == block ? 0.0 : mean.weight;
  }
  for (Eigen::Index k = 0; k < n; ++k) {
    lower[k] = parameters[static_cast<std::size_t>(k)].lower - of.fit.values[k];
    upper[k] = parameters[static_cast<std::size_t>(k)].upper - of.fit.values[k];
    const double length = weight.cwiseProduct(of.slope.col(k)).norm();
    unit[k] = length > 0.0 ? 1.0 / length : 1.0;
  }
  const LeastSquares problem(weight.asDiagonal() * of.slope * unit.asDiagonal(),
                             weight.cwiseProduct(of.fit.residual));
  Eigen::VectorXd d = Eigen::VectorXd::Zero(n);
  std::vector<int> side(static_cast<std::size_t>(n), 0);
  constexpr double almost_none = 1e-9;
  problem.solve(lower.cwiseQuotient(unit), upper.cwiseQuotient(unit), almost_none, d, side);
  return of.fit.residual - of.slope * unit.cwiseProduct(d);
}

}  // namespace raceway::fit
