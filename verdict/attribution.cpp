#include "verdict/attribution.h"

#include <tbb/parallel_for.h>

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <functional>
#include <set>
#include <utility>

#include "fit/distributions.h"
#include "fit/smooth_columns.h"
#include "fit/subspace.h"

namespace raceway::verdict {

namespace {

constexpr std::size_t most_pairs = 40;     // refitted
constexpr std::size_t most_parents = 8;    // pairs that triples are made of
constexpr std::size_t most_triples = 24;   // refitted
constexpr double pair_reach = 30.0;        // of -2 ln L below the best linearised pair
constexpr double pair_reach_share = 0.15;  // of its gain, where that is more
constexpr double beyond_belief = 1000.0;   // times the largest size that is met
constexpr double exponent_limit = 0.2;
constexpr double worse = 1e-3;                // than the base, in -2 ln L: a fit that went astray
constexpr double worth_a_second_look = 0.05;  // p of the gate under the noise found
constexpr double surely = 2.326;              // standard deviations that 99 of 100 exceed
constexpr double same_gain = 1e-8;            // of the misfit without effects: less is rounding
constexpr double coarse_error = 2.0;          // of a coarse fit, in -2 ln L
constexpr double coarse_error_share = 5e-3;   // of its misfit, where that is more

Eigen::Index total(const std::vector<fit::Screened>& candidates) {
  Eigen::Index count = 0;
  for (const fit::Screened& s : candidates)
    if (s.not_testable.empty()) count += s.scores.cols();
  return count;
}

/// Parameters of a fit that are not at a bound.
std::vector<Eigen::Index> free_parameters(const fit::ResponseFit& fit) {
  std::vector<Eigen::Index> free;
  for (std::size_t k = 0; k < fit.at_bound.size(); ++k)
    if (!fit.at_bound[k]) free.push_back(static_cast<Eigen::Index>(k));
  return free;
}

/// A size far beyond all that is met in practice is that of a fit on a flat slope, not of anything.
bool ran_away(std::span<const fit::Screened* const> on, const fit::ResponseFit& fit,
              std::size_t at) {
  for (const fit::Screened* s : on) {
    const record::Parameter& p = s->size();
    const double most =
        std::max(std::abs(p.plausible_upper - p.neutral), std::abs(p.plausible_lower - p.neutral));
    const double value = fit.values[static_cast<Eigen::Index>(at + s->candidate.size)];
    if (std::isfinite(most) && std::abs(value - p.neutral) > beyond_belief * most) return true;
    at += s->candidate.parameters.size();
  }
  return false;
}

/// What `make` makes of 0 to count - 1, on all threads and in that order: each refit has rows of
/// its own, so that no digit depends on the others.
template <typename Make>
std::vector<Explanation> side_by_side(std::size_t count, const Make& make) {
  std::vector<Explanation> list(count);
  // What ends the loop of a caller ends no loop within it half way.
  tbb::task_group_context own(tbb::task_group_context::isolated);
  tbb::parallel_for(
      std::size_t{0}, count, [&](std::size_t k) { list[k] = make(k); }, own);
  return list;
}

/// Logarithm about its mean, with a floor where a factor is nearly zero.
Eigen::VectorXd centred_logarithm(const Eigen::VectorXd& values) {
  const double floor = 1e-2 * values.cwiseAbs().maxCoeff();
  Eigen::VectorXd result =
      values.cwiseAbs().cwiseMax(floor > 0.0 ? floor : 1.0).array().log().matrix();
  result.array() -= result.mean();
  return result;
}

}  // namespace

bool Explanation::bent_to_a_bound() const {
  return elastic && std::any_of(fit.at_bound.end() - static_cast<std::ptrdiff_t>(free_exponents),
                                fit.at_bound.end(), std::identity());
}

Attribution::Attribution(const Evidence& evidence)
    : evidence_(evidence),
      problem_(evidence.problem),
      whitening_(evidence.whitening),
      base_(evidence.base),
      raw_surface_(fit::surface_columns(evidence.saturation.surface, evidence.problem.observed,
                                        evidence.size)),
      raw_scores_(evidence.size.size(), total(evidence.problem.candidates)),
      surface_(evidence.whitening(raw_surface_)),
      draws_(total(evidence.problem.candidates)) {
  Eigen::Index column = 0;
  for (std::size_t k = 0; k < problem_.candidates.size(); ++k) {
    const fit::Screened& s = problem_.candidates[k];
    if (!s.not_testable.empty()) continue;
    for (Eigen::Index j = 0; j < s.scores.cols(); ++j) {
      raw_scores_.col(column++) = s.scores.col(j);
      one_sided_.push_back(s.one_sided);
      owner_.push_back(k);
    }
  }
  scores_ = whitening_(raw_scores_);
  gate_ = gate_on(base_, {});
}

std::pair<Eigen::Index, Eigen::Index> Attribution::score_range(std::size_t candidate) const {
  const auto [first, last] = std::equal_range(owner_.begin(), owner_.end(), candidate);
  return {first - owner_.begin(), last - first};
}

Eigen::VectorXd Attribution::least_lengths() const {
  Eigen::VectorXd least = gate_.projected.colwise().norm();
  const Eigen::MatrixXd slope = base_.slope(Eigen::all, free_parameters(base_));
  for (const fit::Whitening& other : evidence_.allowed) {
    const Eigen::MatrixXd projected = fit::project_off(other(slope), other(raw_scores_));
    least = least.cwiseMin(projected.colwise().norm().transpose());
  }
  return least;
}

double Attribution::length_found() const {
  double sides = 0.0;
  for (std::size_t k = 0; k < owner_.size(); ++k)
    if (gate_.visibility[static_cast<Eigen::Index>(k)] >= invisible)
      sides += one_sided_[k] ? 1.0 : 2.0;
  // The gate alarms where twice the p of the largest score is below its level.
  const double critical =
      fit::t_exceeded_with(evidence_.degrees_of_freedom, 0.5 * alarm_level / std::max(1.0, sides));
  // The score scatters about its length, and so does the estimate of the noise.
  const double scatter =
      std::sqrt(1.0 + critical * critical / (2.0 * evidence_.degrees_of_freedom));
  return critical + surely * scatter;
}

double Attribution::visibility(std::size_t candidate) const {
  const auto [first, count] = score_range(candidate);
  return count > 0 ? gate_.visibility.segment(first, count).maxCoeff() : 0.0;
}

std::vector<const fit::Screened*> Attribution::screened(
    const std::vector<std::size_t>& members) const {
  std::vector<const fit::Screened*> on;
  for (const std::size_t k : members) on.push_back(&problem_.candidates[k]);
  return on;
}

/// The initial values; then three starts about the size that the scores ask for. Their shapes are
/// near the bound that is farther from the initial value, halfway, and near the other bound: the
/// misfit can have a minimum near each bound, as for the mounting of a pair.
std::vector<Eigen::VectorXd> Attribution::starts(std::span<const fit::Screened* const> on,
                                                 const fit::Response& response) const {
  const auto bases = static_cast<Eigen::Index>(problem_.base.size());
  Eigen::VectorXd first = response.start();
  first.head(bases) = base_.values;
  std::vector<Eigen::VectorXd> list{first};
  for (const auto& [part, times] : {std::pair{0.1, 1.0}, {0.5, 0.5}, {0.75, 1.5}}) {
    Eigen::VectorXd x = first;
    Eigen::Index at = bases;
    for (const fit::Screened* s : on) {
      const auto [begin, count] =
          score_range(static_cast<std::size_t>(s - problem_.candidates.data()));
      double amount = 1.0;
      if (count > 0) {
        const double norm = gate_.projected.col(begin).norm();
        if (norm > 0.0) amount = gate_.scores[begin] / norm;
      }
      for (std::size_t k = 0; k < s->candidate.parameters.size(); ++k, ++at) {
        const record::Parameter& p = s->candidate.parameters[k];
        if (k == s->candidate.size)
          x[at] = p.neutral + s->unit_size * std::clamp(times * amount, -3.0, 3.0);
        else if (std::isfinite(p.upper - p.lower))
          x[at] = std::lerp(p.lower, p.upper,
                            p.start - p.lower > p.upper - p.start ? part : 1.0 - part);
        x[at] = std::clamp(x[at], p.lower, p.upper);
        // At its neutral size an effect adds nothing, and its shapes would have no gradient.
        if (k == s->candidate.size && x[at] == p.neutral)
          x[at] = std::clamp(times * p.start, p.lower, p.upper);
      }
    }
    list.push_back(x);
  }
  return list;
}

Explanation Attribution::refit(const std::vector<std::size_t>& members,
                               const std::vector<Eigen::VectorXd>& extra_starts) const {
  const std::vector<const fit::Screened*> on = screened(members);
  fit::Response response = fit::response_with(problem_, on);
  response.find_affine_form();
  std::vector<Eigen::VectorXd> from = extra_starts;
  if (!response.affine) {
    const std::vector<Eigen::VectorXd> own = starts(on, response);
    from.insert(from.end(), own.begin(), own.end());
  }
  Explanation result{.members = members};
  result.parameters = response.parameters;
  result.fit = fit::fit_response(response, whitening_, problem_.measured(), from);
  if (result.fit.converged && result.fit.misfit > base_.misfit + worse) {
    // A hollow of its own: without the effect the misfit is less, so the search begins there.
    Eigen::VectorXd without = response.start();
    auto at = static_cast<Eigen::Index>(problem_.base.size());
    without.head(at) = base_.values;
    Eigen::VectorXd little = without;
    for (const fit::Screened* s : on) {
      const Eigen::Index size = at + static_cast<Eigen::Index>(s->candidate.size);
      without[size] = s->size().neutral;
      little[size] = without[size] + 0.01 * s->unit_size;
      at += static_cast<Eigen::Index>(s->candidate.parameters.size());
    }
    result.fit = fit::fit_response(response, whitening_, problem_.measured(), {without, little});
  }
  result.response = std::move(response);
  judge(result);
  return result;
}

void Attribution::judge(Explanation& e) const {
  const std::vector<const fit::Screened*> on = screened(e.members);
  if (e.fit.converged && ran_away(on, e.fit, problem_.base.size())) {
    e.fit.converged = false;
    e.ran_away = true;
  }
  if (!e.fit.converged) return;
  e.gain = base_.misfit - e.fit.misfit;
  std::size_t at = problem_.base.size();
  for (const fit::Screened* s : on)
    for (std::size_t k = 0; k < s->candidate.parameters.size(); ++k, ++at)
      if (k != s->candidate.size && !e.fit.at_bound[at])
        e.gain -= std::log(static_cast<double>(problem_.measured().size()));
}

std::vector<Explanation> Attribution::singles() const {
  std::vector<std::size_t> tried;
  for (std::size_t k = 0; k < problem_.candidates.size(); ++k)
    if (problem_.candidates[k].not_testable.empty() && visibility(k) >= invisible)
      tried.push_back(k);
  std::vector<Explanation> all =
      side_by_side(tried.size(), [&](std::size_t k) { return refit({tried[k]}); });
  // Not converged: last. Gains that differ by rounding alone keep the order of the candidates.
  const double quantum = same_gain * std::max(1.0, base_.misfit);
  std::stable_sort(all.begin(), all.end(), [&](const Explanation& a, const Explanation& b) {
    if (a.fit.converged != b.fit.converged) return a.fit.converged;
    return a.fit.converged && std::round(a.gain / quantum) > std::round(b.gain / quantum);
  });
  return all;
}

Attribution::Directions Attribution::directions(const std::vector<Explanation>& singles) const {
  // The scores of each candidate, and how it changed the prediction when refitted.
  Directions result;
  std::vector<Eigen::VectorXd> columns;
  for (const Explanation& single : singles) {
    if (!single.fit.converged) continue;
    const std::size_t k = single.members.front();
    const auto [first, count] = score_range(k);
    for (Eigen::Index j = first; j < first + count; ++j)
      if (gate_.visibility[j] >= invisible) {
        columns.push_back(gate_.projected.col(j));
        result.one_sided.push_back(one_sided_[static_cast<std::size_t>(j)]);
        result.owner.push_back(k);
      }
    columns.push_back(whitening_(Eigen::VectorXd(single.fit.prediction - base_.prediction)));
    result.one_sided.push_back(true);
    result.owner.push_back(k);
  }
  Eigen::MatrixXd all(problem_.measured().size(), static_cast<Eigen::Index>(columns.size()));
  for (std::size_t k = 0; k < columns.size(); ++k)
    all.col(static_cast<Eigen::Index>(k)) = columns[k];
  result.columns = fit::project_off(base_.tangent, all);
  return result;
}

std::vector<std::pair<double, Attribution::Members>> Attribution::weigh_pairs(
    const std::vector<Explanation>& singles) const {
  const Directions d = directions(singles);
  const Eigen::VectorXd rest = fit::project_off(base_.tangent, base_.residual);
  const Eigen::MatrixXd gram = d.columns.transpose() * d.columns;
  const Eigen::VectorXd right = d.columns.transpose() * rest;
  std::map<Members, double> reach;
  for (Eigen::Index a = 0; a < gram.cols(); ++a)
    for (Eigen::Index b = 0; b < a; ++b) {
      const auto one = static_cast<std::size_t>(a), other = static_cast<std::size_t>(b);
      const std::size_t i = d.owner[one], j = d.owner[other];
      if (i == j) continue;
      const double determinant = gram(a, a) * gram(b, b) - gram(a, b) * gram(a, b);
      if (!(determinant > 1e-6 * gram(a, a) * gram(b, b))) continue;
      const double x = (gram(b, b) * right[a] - gram(a, b) * right[b]) / determinant;
      const double y = (gram(a, a) * right[b] - gram(a, b) * right[a]) / determinant;
      if ((x < 0.0 && d.one_sided[one]) || (y < 0.0 && d.one_sided[other])) continue;
      double& best = reach[{std::min(i, j), std::max(i, j)}];
      best = std::max(best, x * right[a] + y * right[b]);
    }
  std::vector<std::pair<double, Members>> order;
  for (const auto& [members, value] : reach) order.push_back({-value, members});
  std::sort(order.begin(), order.end());
  return order;
}

Eigen::VectorXd Attribution::values_of(const Explanation& e, std::size_t member) const {
  std::size_t at = problem_.base.size();
  for (const std::size_t k : e.members) {
    const std::size_t count = problem_.candidates[k].candidate.parameters.size();
    if (k == member)
      return e.fit.values.segment(static_cast<Eigen::Index>(at), static_cast<Eigen::Index>(count));
    at += count;
  }
  return {};
}

Explanation Attribution::refit_together(const Explanation& first, const Explanation& single) const {
  std::vector<std::size_t> members = first.members;
  members.push_back(single.members.front());
  std::sort(members.begin(), members.end());
  const auto bases = static_cast<Eigen::Index>(problem_.base.size());
  Eigen::VectorXd start = first.fit.values.head(bases), halved = start;
  const auto append = [](Eigen::VectorXd& to, const Eigen::VectorXd& values) {
    to.conservativeResize(to.size() + values.size());
    to.tail(values.size()) = values;
  };
  for (const std::size_t k : members) {
    const fit::Screened& s = problem_.candidates[k];
    Eigen::VectorXd own = values_of(k == single.members.front() ? single : first, k);
    append(start, own);
    double& size = own[static_cast<Eigen::Index>(s.candidate.size)];
    size = 0.5 * (size + s.size().neutral);
    append(halved, own);
  }
  const std::vector<Eigen::VectorXd> starts{start, halved};
  // What is affine needs no search, and what has a part that is not is not affine.
  if (first.response.affine && single.response.affine) return refit(members, starts);
  Explanation result{.members = members};
  result.response = fit::response_with(problem_, screened(members));
  result.parameters = result.response.parameters;
  result.fit = fit::coarse_fit(result.response, whitening_, problem_.measured(), start);
  judge(result);
  // Worse than a part of it: the search went astray.
  const double part = std::min(first.fit.misfit, single.fit.misfit);
  if (!result.fit.converged || result.fit.misfit > part + coarse_error)
    return refit(members, starts);
  result.starts = starts;
  return result;
}

bool Attribution::is_datum(std::size_t member) const {
  return !problem_.candidates[member].candidate.datum.empty();
}

bool Attribution::has_datum(const Explanation& e) const {
  return std::any_of(e.members.begin(), e.members.end(),
                     [this](std::size_t k) { return is_datum(k); });
}

void Attribution::refine(std::vector<Explanation>& list, double reach) const {
  for (;;) {
    std::vector<std::size_t> coarse;
    std::size_t parents = 0;
    double least = 0.0;
    for (std::size_t k = 0; k < list.size(); ++k) {
      if (k == 0)
        least = list[k].gain - reach -
                std::max(coarse_error, coarse_error_share * (base_.misfit - list[k].gain));
      const bool parent =
          list[k].members.size() == 2 && !has_datum(list[k]) && parents++ < most_parents;
      if (!list[k].starts.empty() && (parent || list[k].gain >= least)) coarse.push_back(k);
    }
    if (coarse.empty()) return;
    std::vector<Explanation> whole = side_by_side(coarse.size(), [&](std::size_t k) {
      return refit(list[coarse[k]].members, list[coarse[k]].starts);
    });
    for (std::size_t k = 0; k < coarse.size(); ++k) {
      Explanation& e = list[coarse[k]];
      whole[k].least_loss = e.least_loss + whole[k].gain - e.gain;
      e = std::move(whole[k]);
    }
    std::erase_if(list, [](const Explanation& e) { return !e.fit.converged; });
    std::stable_sort(list.begin(), list.end(),
                     [](const Explanation& a, const Explanation& b) { return a.gain > b.gain; });
  }
}

std::vector<Explanation> Attribution::pairs(const std::vector<Explanation>& singles,
                                            const std::function<bool()>& cancelled) const {
  const std::vector<std::pair<double, Members>> order = weigh_pairs(singles);
  std::map<std::size_t, const Explanation*> alone;
  for (const Explanation& single : singles) alone[single.members.front()] = &single;
  const double best = order.empty() ? 0.0 : -order.front().first;
  const double least = best - std::max(pair_reach, pair_reach_share * best);
  const auto within = static_cast<std::size_t>(
      std::find_if(order.begin(), order.end(),
                   [&](const auto& weighed) { return -weighed.first < least; }) -
      order.begin());
  std::vector<Explanation> result;
  // As many at once as are surely wanted: those that do not converge make room for others.
  for (std::size_t next = 0; next < within && result.size() < most_pairs;) {
    if (cancelled && cancelled()) break;
    const std::size_t count = std::min(within - next, most_pairs - result.size());
    std::vector<Explanation> refitted = side_by_side(count, [&](std::size_t k) {
      const Members& members = order[next + k].second;
      const Explanation &first = *alone.at(members.first), &second = *alone.at(members.second);
      Explanation pair = refit_together(first, second);
      pair.least_loss = pair.gain - std::max(first.gain, second.gain);
      return pair;
    });
    for (Explanation& pair : refitted)
      if (pair.fit.converged) result.push_back(std::move(pair));
    next += count;
  }
  std::stable_sort(result.begin(), result.end(),
                   [](const Explanation& a, const Explanation& b) { return a.gain > b.gain; });
  return result;
}

std::vector<Explanation> Attribution::triples(const std::vector<Explanation>& pairs,
                                              const std::vector<Explanation>& singles,
                                              const std::function<bool()>& cancelled) const {
  const Directions d = directions(singles);
  struct Choice {
    double gain;
    const Explanation *pair, *single;
  };
  std::vector<Choice> order;
  // Data that may be wrong fit what two effects leave of anything: not beside two.
  std::size_t parents = 0;
  for (const Explanation& pair : pairs) {
    if (has_datum(pair)) continue;
    if (++parents > most_parents) break;
    const Eigen::VectorXd rest = fit::project_off(pair.fit.tangent, pair.fit.residual);
    const Eigen::MatrixXd columns = fit::project_off(pair.fit.tangent, d.columns);
    for (const Explanation& single : singles) {
      const std::size_t k = single.members.front();
      if (!single.fit.converged || is_datum(k) ||
          std::find(pair.members.begin(), pair.members.end(), k) != pair.members.end())
        continue;
      double most = 0.0;
      for (Eigen::Index j = 0; j < columns.cols(); ++j) {
        const double square = columns.col(j).squaredNorm();
        if (d.owner[static_cast<std::size_t>(j)] != k ||
            !(square > 1e-6 * d.columns.col(j).squaredNorm()))
          continue;
        const double along = columns.col(j).dot(rest);
        if (along > 0.0 || !d.one_sided[static_cast<std::size_t>(j)])
          most = std::max(most, along * along / square);
      }
      order.push_back({pair.gain + most, &pair, &single});
    }
  }
  std::stable_sort(order.begin(), order.end(),
                   [](const Choice& a, const Choice& b) { return a.gain > b.gain; });
  std::vector<Choice> chosen;
  std::set<std::vector<std::size_t>> tried;
  for (const Choice& c : order) {
    if (tried.size() >= most_triples) break;
    std::vector<std::size_t> members = c.pair->members;
    members.push_back(c.single->members.front());
    std::sort(members.begin(), members.end());
    if (tried.insert(members).second) chosen.push_back(c);
  }
  std::vector<Explanation> result = side_by_side(chosen.size(), [&](std::size_t k) {
    if (cancelled && cancelled()) return Explanation();
    return refit_together(*chosen[k].pair, *chosen[k].single);
  });
  std::erase_if(result, [](const Explanation& triple) { return !triple.fit.converged; });
  std::stable_sort(result.begin(), result.end(),
                   [](const Explanation& a, const Explanation& b) { return a.gain > b.gain; });
  return result;
}

Explanation Attribution::elastic(const Explanation& single) const {
  const fit::Screened* const on[] = {&problem_.candidates[single.members.front()]};
  const fit::Candidate& candidate = on[0]->candidate;
  const fit::Response plain = fit::response_with(problem_, on);
  Explanation result{.members = single.members};
  result.elastic = true;
  fit::Response bent;
  bent.parameters = plain.parameters;
  // An input that does not vary has no exponent.
  std::vector<Eigen::VectorXd> columns;
  std::vector<std::size_t> varying;
  for (const fit::Factor& factor : problem_.subject->factors(*problem_.record)) {
    const Eigen::VectorXd logarithm = centred_logarithm(problem_.observed.at(factor.values));
    result.exponents.push_back({factor.name, 0.0});
    if (logarithm.cwiseAbs().maxCoeff() < 1e-3) continue;
    varying.push_back(result.exponents.size() - 1);
    columns.push_back(logarithm);
    record::Parameter exponent{.name = factor.name + " exponent", .unit = "1"};
    exponent.start = 0.0;
    exponent.lower = -exponent_limit;
    exponent.upper = exponent_limit;
    exponent.scale = 0.1;
    bent.parameters.push_back(std::move(exponent));
  }
  Eigen::MatrixXd bending(problem_.measured().size(), static_cast<Eigen::Index>(columns.size()));
  for (std::size_t k = 0; k < columns.size(); ++k)
    bending.col(static_cast<Eigen::Index>(k)) = columns[k];
  const auto count = static_cast<Eigen::Index>(plain.parameters.size());
  const auto bases = static_cast<Eigen::Index>(problem_.base.size());
  bent.readings = [&plain, &candidate, bending, count, bases](const Eigen::VectorXd& x) {
    Eigen::VectorXd without = x.head(count);
    for (std::size_t k = 0; k < candidate.parameters.size(); ++k)
      if (!std::isnan(candidate.parameters[k].neutral))
        without[bases + static_cast<Eigen::Index>(k)] = candidate.parameters[k].neutral;
    const Eigen::VectorXd base = plain.readings(without);
    const Eigen::VectorXd change = plain.readings(x.head(count)) - base;
    return Eigen::VectorXd(
        base + change.cwiseProduct((bending * x.tail(bending.cols())).array().exp().matrix()));
  };
  std::vector<Eigen::VectorXd> from;
  for (const double sign : {0.0, 1.0, -1.0}) {
    Eigen::VectorXd start(count + bending.cols());
    start.head(count) = single.fit.values;
    for (std::size_t k = 0; k < varying.size(); ++k)
      start[count + static_cast<Eigen::Index>(k)] = sign * (varying[k] % 2 == 0 ? 0.1 : -0.05);
    from.push_back(std::move(start));
  }
  result.parameters = bent.parameters;
  result.fit = fit::fit_response(bent, whitening_, problem_.measured(), from);
  result.free_exponents = varying.size();
  if (!result.fit.converged) return result;
  result.gain = base_.misfit - result.fit.misfit;
  for (std::size_t k = 0; k < varying.size(); ++k)
    result.exponents[varying[k]].value = result.fit.values[count + static_cast<Eigen::Index>(k)];
  return result;
}

void Attribution::recheck(Explanation& explanation) const {
  if (explanation.rechecked) return;
  explanation.recheck = gate_on(explanation.fit, explanation.members);
  explanation.rechecked = true;
}

Gate Attribution::gate_on(const fit::ResponseFit& fit,
                          const std::vector<std::size_t>& without) const {
  std::vector<Eigen::Index> columns;
  std::vector<bool> one_sided;
  for (std::size_t k = 0; k < owner_.size(); ++k) {
    if (std::find(without.begin(), without.end(), owner_[k]) != without.end()) continue;
    columns.push_back(static_cast<Eigen::Index>(k));
    one_sided.push_back(one_sided_[k]);
  }
  Gate gate = open_gate(fit.tangent, fit.residual, surface_, scores_(Eigen::all, columns),
                        one_sided, evidence_.degrees_of_freedom, draws_);
  if (evidence_.allowed.empty() || gate.p_value() >= worth_a_second_look) return gate;
  // The fit under another noise is where the linearised model says: it takes its tangent away.
  const Eigen::VectorXd rest = problem_.measured() - fit.prediction;
  const std::vector<Eigen::Index> free = free_parameters(fit);
  const Eigen::MatrixXd slope = fit.slope(Eigen::all, free);
  const Eigen::MatrixXd scores = raw_scores_(Eigen::all, columns);
  for (const fit::Whitening& other : evidence_.allowed) {
    const Eigen::MatrixXd tangent = other(slope);
    const Gate under = open_gate(tangent, other(rest), other(raw_surface_), other(scores),
                                 one_sided, evidence_.degrees_of_freedom, draws_);
    gate.allowed_p_value = std::max(gate.allowed_p_value, under.p_value());
    if (gate.allowed_p_value >= worth_a_second_look) break;
  }
  return gate;
}

}  // namespace raceway::verdict
