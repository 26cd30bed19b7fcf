#include "fit/attribution.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <functional>
#include <memory>

namespace raceway::fit {

namespace {

constexpr std::size_t most_pairs = 40;     // refitted
constexpr double pair_reach = 30.0;        // of -2 ln L below the best linearised pair
constexpr double pair_reach_share = 0.15;  // of its gain, where that is more
constexpr double exponent_limit = 0.2;
constexpr double worse = 1e-3;      // than the base, in -2 ln L: a fit that went astray
constexpr double same_gain = 1e-8;  // of the misfit without effects: less is rounding

Eigen::Index total(const std::vector<Candidate>& candidates) {
  Eigen::Index count = 0;
  for (const Candidate& c : candidates)
    if (c.not_testable.empty()) count += c.scores.cols();
  return count;
}

}  // namespace

bool Explanation::bent_to_a_bound() const {
  return elastic && std::any_of(fit.at_bound.end() - static_cast<std::ptrdiff_t>(exponents),
                                fit.at_bound.end(), std::identity());
}

Attribution::Attribution(const Problem& problem, const NoiseModel& noise, const ResponseFit& base,
                         const Eigen::VectorXd& size)
    : problem_(problem),
      noise_(noise),
      base_(base),
      surface_(noise.whitening(surface_columns(problem.data, size))),
      draws_(total(problem.candidates)) {
  Eigen::MatrixXd scores(size.size(), total(problem.candidates));
  Eigen::Index column = 0;
  for (std::size_t k = 0; k < problem.candidates.size(); ++k) {
    const Candidate& c = problem.candidates[k];
    if (!c.not_testable.empty()) continue;
    for (Eigen::Index j = 0; j < c.scores.cols(); ++j) {
      scores.col(column++) = c.scores.col(j);
      one_sided_.push_back(c.one_sided);
      owner_.push_back(k);
    }
  }
  scores_ = noise.whitening(scores);
  gate_ = open_gate(base.tangent, base.residual, surface_, scores_, one_sided_,
                    noise.degrees_of_freedom, draws_);
}

std::pair<Eigen::Index, Eigen::Index> Attribution::score_range(std::size_t candidate) const {
  const auto [first, last] = std::equal_range(owner_.begin(), owner_.end(), candidate);
  return {first - owner_.begin(), last - first};
}

double Attribution::visibility(std::size_t candidate) const {
  const auto [first, count] = score_range(candidate);
  return count > 0 ? gate_.visibility.segment(first, count).maxCoeff() : 0.0;
}

Explanation Attribution::refit(const std::vector<std::size_t>& members,
                               const std::vector<Eigen::VectorXd>& extra_starts) const {
  std::vector<const Candidate*> on;
  for (const std::size_t k : members) on.push_back(&problem_.candidates[k]);
  Response response = response_with(problem_, on);
  response.find_affine_form();
  std::vector<Eigen::VectorXd> starts = extra_starts;
  if (!response.affine) {
    // The initial values; then the size that the scores ask for, shapes towards one bound, then
    // the other.
    const auto bases = static_cast<Eigen::Index>(problem_.base.size());
    Eigen::VectorXd first = response.start();
    first.head(bases) = base_.values;
    starts.push_back(first);
    for (const double part : {0.5, 0.25, 0.75}) {
      Eigen::VectorXd x = first;
      Eigen::Index at = bases;
      for (const Candidate* c : on) {
        const auto [begin, count] =
            score_range(static_cast<std::size_t>(c - problem_.candidates.data()));
        double amount = 1.0;
        if (count > 0) {
          const double norm = gate_.projected.col(begin).norm();
          if (norm > 0.0) amount = gate_.scores[begin] / norm;
        }
        for (std::size_t k = 0; k < c->parameters.size(); ++k, ++at) {
          const FitParameter& p = c->parameters[k];
          if (k == c->size_index)
            x[at] = c->neutral[k] + c->unit_size * std::clamp(2.0 * part * amount, -3.0, 3.0);
          else if (std::isfinite(p.upper - p.lower))
            x[at] = p.lower + part * (p.upper - p.lower);
          x[at] = std::clamp(x[at], p.lower, p.upper);
        }
      }
      starts.push_back(x);
    }
  }
  Explanation result{.members = members};
  result.parameters = response.parameters;
  result.fit = fit_response(response, noise_.whitening, problem_.measured, starts);
  if (result.fit.converged && result.fit.misfit > base_.misfit + worse) {
    // A hollow of its own: without the effect the misfit is less, so the search begins there.
    Eigen::VectorXd without = response.start();
    auto at = static_cast<Eigen::Index>(problem_.base.size());
    without.head(at) = base_.values;
    Eigen::VectorXd little = without;
    for (const Candidate* c : on) {
      const Eigen::Index size = at + static_cast<Eigen::Index>(c->size_index);
      without[size] = c->neutral[c->size_index];
      little[size] = without[size] + 0.01 * c->unit_size;
      at += static_cast<Eigen::Index>(c->parameters.size());
    }
    result.fit = fit_response(response, noise_.whitening, problem_.measured, {without, little});
  }
  result.response = std::move(response);
  if (!result.fit.converged) return result;
  result.gain = base_.misfit - result.fit.misfit;
  std::size_t at = problem_.base.size();
  for (const Candidate* c : on)
    for (std::size_t k = 0; k < c->parameters.size(); ++k, ++at)
      if (k != c->size_index && !result.fit.at_bound[at])
        result.gain -= std::log(static_cast<double>(problem_.measured.size()));
  return result;
}

std::vector<Explanation> Attribution::singles() const {
  std::vector<Explanation> all;
  for (std::size_t k = 0; k < problem_.candidates.size(); ++k)
    if (problem_.candidates[k].not_testable.empty() && visibility(k) >= invisible)
      all.push_back(refit({k}));
  // Not converged: last. Gains that differ by rounding alone keep the order of the candidates.
  const double quantum = same_gain * std::max(1.0, base_.misfit);
  std::stable_sort(all.begin(), all.end(), [&](const Explanation& a, const Explanation& b) {
    if (a.fit.converged != b.fit.converged) return a.fit.converged;
    return a.fit.converged && std::round(a.gain / quantum) > std::round(b.gain / quantum);
  });
  return all;
}

std::vector<Explanation> Attribution::pairs(const std::vector<Explanation>& singles,
                                            const std::function<bool()>& cancelled) const {
  // Directions: the scores of each candidate, and how it changed the prediction when refitted.
  std::vector<std::size_t> owner;
  std::vector<bool> one_sided;
  std::vector<Eigen::VectorXd> columns;
  for (const Explanation& single : singles) {
    if (!single.fit.converged) continue;
    const std::size_t k = single.members.front();
    const auto [first, count] = score_range(k);
    for (Eigen::Index j = first; j < first + count; ++j)
      if (gate_.visibility[j] >= invisible) {
        columns.push_back(gate_.projected.col(j));
        one_sided.push_back(one_sided_[static_cast<std::size_t>(j)]);
        owner.push_back(k);
      }
    columns.push_back(noise_.whitening(Eigen::VectorXd(single.fit.prediction - base_.prediction)));
    one_sided.push_back(true);
    owner.push_back(k);
  }
  Eigen::MatrixXd all(problem_.measured.size(), static_cast<Eigen::Index>(columns.size()));
  for (std::size_t k = 0; k < columns.size(); ++k)
    all.col(static_cast<Eigen::Index>(k)) = columns[k];
  all = project_off(base_.tangent, all);
  const Eigen::VectorXd rest = project_off(base_.tangent, base_.residual);
  const Eigen::MatrixXd gram = all.transpose() * all;
  const Eigen::VectorXd right = all.transpose() * rest;
  std::map<std::pair<std::size_t, std::size_t>, double> reach;
  for (Eigen::Index a = 0; a < all.cols(); ++a)
    for (Eigen::Index b = 0; b < a; ++b) {
      const std::size_t i = owner[static_cast<std::size_t>(a)],
                        j = owner[static_cast<std::size_t>(b)];
      if (i == j) continue;
      const double determinant = gram(a, a) * gram(b, b) - gram(a, b) * gram(a, b);
      if (!(determinant > 1e-6 * gram(a, a) * gram(b, b))) continue;
      const double x = (gram(b, b) * right[a] - gram(a, b) * right[b]) / determinant;
      const double y = (gram(a, a) * right[b] - gram(a, b) * right[a]) / determinant;
      if ((x < 0.0 && one_sided[static_cast<std::size_t>(a)]) ||
          (y < 0.0 && one_sided[static_cast<std::size_t>(b)]))
        continue;
      double& best = reach[{std::min(i, j), std::max(i, j)}];
      best = std::max(best, x * right[a] + y * right[b]);
    }
  std::vector<std::pair<double, std::pair<std::size_t, std::size_t>>> order;
  for (const auto& [members, value] : reach) order.push_back({-value, members});
  std::sort(order.begin(), order.end());
  std::map<std::size_t, const Explanation*> alone;
  for (const Explanation& single : singles) alone[single.members.front()] = &single;

  std::vector<Explanation> result;
  for (const auto& [negative, members] : order) {
    const double best = -order.front().first;
    if (result.size() >= most_pairs ||
        -negative < best - std::max(pair_reach, pair_reach_share * best))
      break;
    if (cancelled && cancelled()) break;
    // Started from the two singles.
    const auto bases = static_cast<Eigen::Index>(problem_.base.size());
    const Eigen::VectorXd& x = alone[members.first]->fit.values;
    const Eigen::VectorXd& y = alone[members.second]->fit.values;
    Eigen::VectorXd start(x.size() + y.size() - bases);
    start << x, y.tail(y.size() - bases);
    Eigen::VectorXd halved = start;
    const auto halve = [&](std::size_t k, Eigen::Index at) {
      const Candidate& c = problem_.candidates[k];
      double& size = halved[at + static_cast<Eigen::Index>(c.size_index)];
      size = 0.5 * (size + c.neutral[c.size_index]);
    };
    halve(members.first, bases);
    halve(members.second, x.size());
    Explanation pair = refit({members.first, members.second}, {start, halved});
    if (!pair.fit.converged) continue;
    pair.least_loss = pair.gain - std::max(alone[members.first]->gain, alone[members.second]->gain);
    result.push_back(std::move(pair));
  }
  std::stable_sort(result.begin(), result.end(),
                   [](const Explanation& a, const Explanation& b) { return a.gain > b.gain; });
  return result;
}

Explanation Attribution::elastic(const Explanation& single) const {
  const Candidate& c = problem_.candidates[single.members.front()];
  const Candidate* const on[] = {&c};
  const Response plain = response_with(problem_, on);
  const auto rows = problem_.measured.size();
  Eigen::MatrixXd logs(rows, 3);
  for (Eigen::Index i = 0; i < rows; ++i) {
    const Row& row = problem_.data.rows[static_cast<std::size_t>(i)];
    const bearing::OperatingPoint& p = row.point;
    logs(i, 0) = p.speed;
    if (problem_.data.quantity == Quantity::friction_torque)
      logs(i, 1) = std::hypot(p.axial_load, std::hypot(p.radial_load, p.radial_load_z));
    else
      logs(i, 1) = std::isfinite(row.preload) ? row.preload : 0.0;
    logs(i, 2) = problem_.model.lubricant.kinematic_viscosity(p.temperature);
  }
  for (Eigen::Index k = 0; k < 3; ++k) {
    const double floor = 1e-2 * logs.col(k).cwiseAbs().maxCoeff();
    logs.col(k) = logs.col(k).cwiseAbs().cwiseMax(floor > 0.0 ? floor : 1.0).array().log();
    logs.col(k).array() -= logs.col(k).mean();
  }
  Response bent;
  bent.parameters = plain.parameters;
  // An input that does not vary has no exponent.
  const char* const names[] = {"speed exponent", "load exponent", "viscosity exponent"};
  std::vector<Eigen::Index> varying;
  for (Eigen::Index k = 0; k < 3; ++k) {
    if (logs.col(k).cwiseAbs().maxCoeff() < 1e-3) continue;
    varying.push_back(k);
    bent.parameters.push_back({.name = names[k],
                               .unit = "1",
                               .start = 0.0,
                               .lower = -exponent_limit,
                               .upper = exponent_limit,
                               .scale = 0.1});
  }
  const Eigen::MatrixXd bending = logs(Eigen::all, varying);
  const auto count = static_cast<Eigen::Index>(plain.parameters.size());
  const auto bases = static_cast<Eigen::Index>(problem_.base.size());
  bent.readings = [&plain, &c, bending, count, bases](const Eigen::VectorXd& x) {
    Eigen::VectorXd without = x.head(count);
    for (std::size_t k = 0; k < c.neutral.size(); ++k)
      if (!std::isnan(c.neutral[k])) without[bases + static_cast<Eigen::Index>(k)] = c.neutral[k];
    const Eigen::VectorXd base = plain.readings(without);
    const Eigen::VectorXd change = plain.readings(x.head(count)) - base;
    return Eigen::VectorXd(
        base + change.cwiseProduct((bending * x.tail(bending.cols())).array().exp().matrix()));
  };
  std::vector<Eigen::VectorXd> starts;
  for (const double sign : {0.0, 1.0, -1.0}) {
    Eigen::VectorXd start(count + bending.cols());
    start << single.fit.values, sign * Eigen::Vector3d(0.1, -0.05, 0.1)(varying);
    starts.push_back(std::move(start));
  }
  Explanation result{.members = single.members};
  result.elastic = true;
  result.parameters = bent.parameters;
  result.fit = fit_response(bent, noise_.whitening, problem_.measured, starts);
  result.exponents = varying.size();
  if (!result.fit.converged) return result;
  result.gain = base_.misfit - result.fit.misfit;
  double* const exponents[] = {&result.speed_exponent, &result.load_exponent,
                               &result.viscosity_exponent};
  for (std::size_t k = 0; k < varying.size(); ++k)
    *exponents[varying[k]] = result.fit.values[count + static_cast<Eigen::Index>(k)];
  return result;
}

void Attribution::recheck(Explanation& explanation) const {
  if (explanation.rechecked) return;
  std::vector<Eigen::Index> others;
  std::vector<bool> one_sided;
  for (std::size_t k = 0; k < owner_.size(); ++k) {
    if (std::find(explanation.members.begin(), explanation.members.end(), owner_[k]) !=
        explanation.members.end())
      continue;
    others.push_back(static_cast<Eigen::Index>(k));
    one_sided.push_back(one_sided_[k]);
  }
  explanation.recheck =
      open_gate(explanation.fit.tangent, explanation.fit.residual, surface_,
                scores_(Eigen::all, others), one_sided, noise_.degrees_of_freedom, draws_);
  explanation.rechecked = true;
}

}  // namespace raceway::fit
