#include "fit/costly_fit.h"

#include <algorithm>
#include <cmath>
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
constexpr double almost_undamped = 1e-9;
constexpr double far_from_begin = 0.2;  // on the scale of a parameter
constexpr double takes_nothing = 0.9;   // of the misfit without a candidate
constexpr double takes_little = 0.95;   // of the linearised misfit without a candidate

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
  SeparableFit fit{.values = values, .residual = measured_};
  for (Eigen::Index i = 0; i < means_.size(); ++i) {
    const std::vector<Eigen::Index>& places = means_.list[static_cast<std::size_t>(i)].places;
    double sum = 0.0;
    for (const Eigen::Index place : places) sum += all_[static_cast<std::size_t>(place)];
    fit.residual[i] -= sum / static_cast<double>(places.size());
  }
  fit.misfit = weight_.cwiseProduct(fit.residual).squaredNorm();
  find_bounds(fit);
  return fit;
}

void CostlyProblem::find_bounds(SeparableFit& fit) const {
  fit.at_bound.assign(parameters_.size(), false);
  for (std::size_t k = 0; k < parameters_.size(); ++k) {
    const Parameter& p = parameters_[k];
    const double here = to_scale(k, fit.values[static_cast<Eigen::Index>(k)]);
    fit.at_bound[k] = (std::isfinite(p.lower) && here <= to_scale(k, p.lower) + at_the_bound) ||
                      (std::isfinite(p.upper) && here >= to_scale(k, p.upper) - at_the_bound);
  }
}

Eigen::VectorXd CostlyProblem::difference(const SeparableFit& here, std::size_t k, double by,
                                          SeparableFit* better) const {
  const auto place = static_cast<Eigen::Index>(k);
  const double from = to_scale(k, here.values[place]);
  for (const double way : {by, -by}) {
    Eigen::VectorXd other = here.values;
    other[place] = from_scale(k, from + way);
    const double went = to_scale(k, other[place]) - from;
    if (std::abs(went) < 0.5 * std::abs(by)) continue;  // beyond a bound
    SeparableFit there = at(other);
    const Eigen::VectorXd change = here.residual - there.residual;
    if (!change.allFinite()) continue;
    if (better && there.misfit < better->misfit) *better = std::move(there);
    return change / went;
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

Eigen::MatrixXd CostlyProblem::on_scales(Eigen::MatrixXd slope, const Eigen::VectorXd& at) const {
  for (Eigen::Index k = 0; k < slope.cols(); ++k)
    slope.col(k) *= unit_of(static_cast<std::size_t>(k), at[k]);
  return slope;
}

CostlyFit CostlyProblem::from(const Eigen::VectorXd& start, const CostlyEnd& end) const {
  SeparableFit first = at(start);
  if (!std::isfinite(first.misfit)) return {};
  Eigen::MatrixXd slope = differences(first);
  auto begin = std::make_shared<CostlyFit>(CostlyFit{first, slope});
  for (Eigen::Index k = 0; k < slope.cols(); ++k)
    begin->slope.col(k) /= unit_of(static_cast<std::size_t>(k), start[k]);
  CostlyFit found = descend(std::move(first), std::move(slope), true, end);
  found.begin = std::move(begin);
  return found;
}

CostlyFit CostlyProblem::onwards(const CostlyFit& fit, const CostlyEnd& end) const {
  return descend(fit.fit, on_scales(fit.slope, fit.fit.values), false, end);
}

CostlyFit CostlyProblem::with_candidates(const CostlyFit& base, const Eigen::VectorXd& initial,
                                         const std::vector<std::size_t>& sizes) const {
  const Eigen::Index known = base.fit.values.size();
  CostlyFit first{base.fit, Eigen::MatrixXd::Zero(means_.size(), initial.size())};
  SeparableFit& here = first.fit;
  here.values = initial;
  here.values.head(known) = base.fit.values;
  here.converged = false;
  first.slope.leftCols(known) = on_scales(base.slope, base.fit.values);
  for (const std::size_t k : sizes)
    here.values[static_cast<Eigen::Index>(k)] = parameters_[k].neutral;
  find_bounds(here);
  SeparableFit better = here;
  for (const std::size_t k : sizes) {
    const auto place = static_cast<Eigen::Index>(k);
    const double neutral = to_scale(k, parameters_[k].neutral);
    double by = to_scale(k, initial[place]) - neutral;
    constexpr double none = 1e-9;
    if (!(std::abs(by) > none))
      by = spans_a_decade(parameters_[k]) ? 5.0 * share_of_value : share_of_size;
    first.slope.col(place) = difference(here, k, by, &better);
  }
  here = std::move(better);
  return first;
}

bool CostlyProblem::is_far(const CostlyFit& base) const {
  if (!base.begin) return false;
  for (Eigen::Index k = 0; k < base.fit.values.size(); ++k) {
    const auto place = static_cast<std::size_t>(k);
    const double moved =
        std::abs(to_scale(place, base.fit.values[k]) - to_scale(place, base.begin->fit.values[k]));
    if (moved > far_from_begin) return true;
  }
  return false;
}

bool CostlyProblem::gains(const CostlyFit& from, const CostlyFit& first,
                          const std::vector<std::size_t>& sizes) const {
  const Eigen::Index known = from.fit.values.size(), all = first.slope.cols();
  Eigen::VectorXd values = first.fit.values;
  values.head(known) = from.fit.values;
  for (const std::size_t k : sizes) values[static_cast<Eigen::Index>(k)] = parameters_[k].neutral;
  Eigen::MatrixXd slope = first.slope;
  slope.leftCols(known) = on_scales(from.slope, from.fit.values);
  const auto misfit_with = [&](Eigen::Index count) {
    const Range range = range_of(values.head(count));
    const LeastSquares problem(weight_.asDiagonal() * slope.leftCols(count),
                               weight_.cwiseProduct(from.fit.residual));
    Eigen::VectorXd d = Eigen::VectorXd::Zero(count);
    std::vector<int> side(static_cast<std::size_t>(count), 0);
    problem.solve(range.lower, range.upper, almost_undamped, d, side);
    return from.fit.misfit - problem.fall(d);
  };
  return misfit_with(all) < takes_little * misfit_with(known);
}

CostlyFit CostlyProblem::beyond(const CostlyFit& base, const Eigen::VectorXd& initial,
                                const std::vector<std::size_t>& sizes, const CostlyEnd& end) const {
  const auto fit_from = [&](const CostlyFit& first) {
    return descend(first.fit, first.slope, false, end);
  };
  const CostlyFit first = with_candidates(base, initial, sizes);
  CostlyFit found = fit_from(first);
  const bool stuck = std::any_of(sizes.begin(), sizes.end(),
                                 [&](std::size_t k) { return found.fit.at_bound[k]; }) ||
                     !(found.fit.misfit < takes_nothing * base.fit.misfit);
  if (!stuck || !is_far(base) || !gains(*base.begin, first, sizes)) return found;
  CostlyFit other = fit_from(with_candidates(*base.begin, initial, sizes));
  return other.fit.misfit < found.fit.misfit ? other : found;
}

CostlyProblem::Range CostlyProblem::range_of(const Eigen::VectorXd& values) const {
  const Eigen::Index n = values.size();
  Range range{Eigen::VectorXd(n), Eigen::VectorXd(n), Eigen::VectorXd(n)};
  for (Eigen::Index k = 0; k < n; ++k) {
    const auto place = static_cast<std::size_t>(k);
    const Parameter& p = parameters_[place];
    const double far = spans_a_decade(p) ? far_step : endless;
    range.here[k] = to_scale(place, values[k]);
    range.lower[k] = std::max(-far, to_scale(place, p.lower) - range.here[k]);
    range.upper[k] = std::min(far, to_scale(place, p.upper) - range.here[k]);
  }
  return range;
}

CostlyFit CostlyProblem::descend(SeparableFit best, Eigen::MatrixXd slope, bool is_fresh,
                                 const CostlyEnd& end) const {
  const Eigen::Index n = best.values.size();
  double damping = 1e-3;
  for (int step = 0; step < most_descents && !best.converged && n > 0; ++step) {
    ++best.iterations;
    const auto [here, lower, upper] = range_of(best.values);
    double fall = 0.0;
    bool better = false;
    const bool was_fresh = is_fresh;
    for (int attempt = 0; attempt < most_attempts && !better; ++attempt) {
      const LeastSquares problem(weight_.asDiagonal() * slope, weight_.cwiseProduct(best.residual));
      Eigen::VectorXd d = Eigen::VectorXd::Zero(n), values(n), went(n);
      std::vector<int> side(static_cast<std::size_t>(n), 0);
      problem.solve(lower, upper, damping, d, side);
      const bool is_little = problem.fall(d) <= end.settled * best.misfit;
      if (is_little && !end.rough) break;  // nothing more is to be had
      for (Eigen::Index k = 0; k < n; ++k) {
        const auto place = static_cast<std::size_t>(k);
        values[k] = from_scale(place, here[k] + d[k]);
        went[k] = to_scale(place, values[k]) - here[k];
      }
      if (is_little) {
        best.values = values;
        best.residual -= slope * went;
        best.misfit = weight_.cwiseProduct(best.residual).squaredNorm();
        find_bounds(best);
        break;
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
    if (better && fall > end.settled * best.misfit) continue;
    // A little step leaves derivatives that were exact before it as good as exact.
    is_fresh = was_fresh;
    if (is_fresh || end.rough || best.misfit > end.hopeless) {
      best.converged = true;
    } else {
      slope = differences(best);
      is_fresh = true;
      damping = 1e-3;
    }
  }
  if (!is_fresh && !end.rough && !(best.misfit > end.hopeless)) slope = differences(best);
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
  problem.solve(lower.cwiseQuotient(unit), upper.cwiseQuotient(unit), almost_undamped, d, side);
  return of.fit.residual - of.slope * unit.cwiseProduct(d);
}

}  // namespace raceway::fit
