#include "tolerance/approximation.h"

#include <Eigen/Core>
#include <algorithm>
#include <boost/random/mersenne_twister.hpp>
#include <boost/random/uniform_01.hpp>
#include <cmath>
#include <numeric>
#include <optional>
#include <stdexcept>

namespace raceway::tolerance {
namespace {

constexpr double a_minute = 60.0;
constexpr double most_means = 1500.0;
constexpr std::size_t trials = 6;       // of a parameter of a candidate
constexpr std::size_t coarse = 128;     // of values that are the only ones
constexpr double worth_another = 0.85;  // of the misfit, that a further one must fall below
constexpr int replacements = 3;         // of places, after all else was fitted
constexpr double hollow = 0.1;          // share of the way between bounds
constexpr int most_spread = 64;
constexpr double same_hollow = 1e-4;  // relative: a start that ended where another did

double duration_of(const record::Record& record) {
  const std::span<const double> time = record.values(record::time);
  double longest = 0.0, begin = 0.0;
  for (std::size_t k = 0; k < time.size(); ++k) {
    if (k == 0 || record.run_of(k) != record.run_of(k - 1)) begin = time[k];
    longest = std::max(longest, time[k] - begin);
  }
  return longest;
}

bool spans_decades(const record::Parameter& p) {
  return p.lower > 0.0 && std::isfinite(p.upper) && p.upper > 10.0 * p.lower;
}

/// A share of the way between the bounds.
double between(const record::Parameter& p, double share) {
  if (!std::isfinite(p.upper - p.lower)) return p.start;
  return spans_decades(p) ? p.lower * std::pow(p.upper / p.lower, share)
                          : p.lower + share * (p.upper - p.lower);
}

/// The share at which a value lies.
double share_of(const record::Parameter& p, double value) {
  if (!std::isfinite(p.upper - p.lower)) return 0.0;
  return spans_decades(p) ? std::log(value / p.lower) / std::log(p.upper / p.lower)
                          : (value - p.lower) / (p.upper - p.lower);
}

/// Whether a start lies so near another one that it most likely ends where that one did.
bool in_the_same_hollow(const fit::Separable& problem, const Eigen::VectorXd& a,
                        const Eigen::VectorXd& b) {
  return std::all_of(problem.bending().begin(), problem.bending().end(), [&](std::size_t k) {
    const auto at = static_cast<Eigen::Index>(k);
    const record::Parameter& p = problem.parameters()[k];
    return std::abs(share_of(p, a[at]) - share_of(p, b[at])) < hollow;
  });
}

/// All combinations of values spread over what bends and is not held, as many as make up no more
/// than `most`; none where that leaves fewer than `fewest` values of each.
std::vector<Eigen::VectorXd> spread(const fit::Separable& problem, const Eigen::VectorXd& start,
                                    const std::vector<bool>& held, int most, int fewest) {
  std::vector<std::size_t> moving;
  for (const std::size_t k : problem.bending())
    if (held.empty() || !held[k]) moving.push_back(k);
  std::vector<Eigen::VectorXd> list;
  if (moving.empty()) return list;
  const int each = static_cast<int>(std::pow(most + 0.5, 1.0 / static_cast<double>(moving.size())));
  if (each < fewest) return list;
  const int count = static_cast<int>(std::lround(std::pow(each, moving.size())));
  for (int n = 0; n < count; ++n) {
    Eigen::VectorXd x = start;
    int rest = n;
    for (const std::size_t k : moving) {
      x[static_cast<Eigen::Index>(k)] =
          between(problem.parameters()[k], (rest % each + 0.5) / each);
      rest /= each;
    }
    list.push_back(std::move(x));
  }
  return list;
}

/// Polishes the best of some starts, the least misfit at the end.
fit::SeparableFit best_of(const fit::Separable& problem, std::vector<fit::SeparableFit> begun,
                          int polished, const std::vector<bool>& held,
                          const ApproximationOptions& options) {
  std::erase_if(begun, [](const fit::SeparableFit& f) { return !std::isfinite(f.misfit); });
  std::stable_sort(
      begun.begin(), begun.end(),
      [](const fit::SeparableFit& a, const fit::SeparableFit& b) { return a.misfit < b.misfit; });
  fit::SeparableFit best;
  int done = 0;
  double last = unset;
  std::vector<const Eigen::VectorXd*> seen;
  for (const fit::SeparableFit& start : begun) {
    if (options.cancelled && options.cancelled()) break;
    // A start that is as good as the one before it is most likely the same hollow.
    if (std::abs(start.misfit - last) <= same_hollow * start.misfit) continue;
    if (std::any_of(seen.begin(), seen.end(), [&](const Eigen::VectorXd* other) {
          return in_the_same_hollow(problem, start.values, *other);
        }))
      continue;
    last = start.misfit;
    seen.push_back(&start.values);
    fit::SeparableFit fit = problem.from(start.values, -1, held);
    if (std::isnan(best.misfit) || fit.misfit < best.misfit) best = std::move(fit);
    if (++done >= polished) break;
  }
  return best;
}

/// Errors of each channel as root mean squares, weighted as the means are; of NaN nothing counts.
template <typename Errors>
std::vector<double> rms_by_channel(const fit::Means& means, const Errors& errors) {
  std::vector<double> square, count;
  for (std::size_t i = 0; i < means.list.size(); ++i) {
    const fit::Means::Mean& mean = means.list[i];
    if (square.size() <= mean.channel) {
      square.resize(mean.channel + 1, 0.0);
      count.resize(mean.channel + 1, 0.0);
    }
    if (static_cast<Eigen::Index>(i) >= std::ssize(errors) || std::isnan(errors[i])) continue;
    square[mean.channel] += std::pow(errors[i] * mean.weight, 2);
    count[mean.channel] += 1.0;
  }
  for (std::size_t c = 0; c < square.size(); ++c)
    square[c] = count[c] > 0.0 ? std::sqrt(square[c] / count[c]) : unset;
  return square;
}

Approximation approximation_of(std::shared_ptr<const fit::Subject> subject,
                               const std::vector<std::string>& names,
                               const std::vector<record::Parameter>& parameters,
                               fit::SeparableFit fit, const fit::Means& means) {
  Approximation result{.subject = std::move(subject),
                       .names = names,
                       .parameters = parameters,
                       .fit = std::move(fit)};
  for (std::size_t k = 0; k < result.parameters.size(); ++k) {
    record::Parameter& p = result.parameters[k];
    if (result.fit.values.size() == 0) continue;
    p.value = result.fit.values[static_cast<Eigen::Index>(k)];
    if (result.fit.at_bound[k])
      p.at_bound =
          p.value - p.lower < p.upper - p.value ? record::Bound::lower : record::Bound::upper;
  }
  double square = 0.0;
  for (Eigen::Index i = 0; i < result.fit.residual.size(); ++i)
    square += std::pow(result.fit.residual[i] * means.list[static_cast<std::size_t>(i)].weight, 2);
  result.rms = result.fit.residual.size() > 0
                   ? std::sqrt(square / static_cast<double>(result.fit.residual.size()))
                   : unset;
  result.channel_rms = rms_by_channel(
      means,
      std::span(result.fit.residual.data(), static_cast<std::size_t>(result.fit.residual.size())));
  return result;
}

// Of what is costly: relative fall of the misfit that is none, where its numbers are kept, and of a
// rough fit.
constexpr double settled_misfit = 1e-4, well_settled = 1e-6, roughly_settled = 0.05;
constexpr double hopeless = 0.9;  // of the misfit without a candidate

/// The same of what is costly.
Approximation costly_approximation(std::shared_ptr<const fit::Subject> subject,
                                   const Recorded& recorded, const std::vector<std::string>& names,
                                   const fit::CostlyProblem& problem, fit::CostlyFit found) {
  Approximation result = approximation_of(std::move(subject), names, problem.parameters(),
                                          std::move(found.fit), recorded.means);
  result.slope = std::move(found.slope);
  result.begin = std::move(found.begin);
  return result;
}

Eigen::VectorXd starting_values(const std::vector<record::Parameter>& parameters) {
  Eigen::VectorXd start(parameters.size());
  for (std::size_t k = 0; k < parameters.size(); ++k)
    start[static_cast<Eigen::Index>(k)] =
        std::clamp(parameters[k].start, parameters[k].lower, parameters[k].upper);
  return start;
}

/// Places of the sizes of candidates behind some other parameters.
std::vector<std::size_t> places_of_sizes(std::size_t others,
                                         const std::vector<const fit::Candidate*>& candidates) {
  std::vector<std::size_t> list;
  for (const fit::Candidate* c : candidates) {
    list.push_back(others + c->size);
    others += c->parameters.size();
  }
  return list;
}

}  // namespace

double usual_width(const record::Record& record) {
  return std::max(a_minute, duration_of(record) / most_means);
}

Recorded recorded(const fit::Subject& subject, std::shared_ptr<const record::Record> record,
                  double width) {
  Recorded result;
  result.prepared = subject.prepare(*record);
  result.means = fit::means_of(subject, *record, width);
  result.duration = duration_of(*record);
  result.record = std::move(record);
  return result;
}

namespace {

/// Without priors.
Approximation searched(std::shared_ptr<const fit::Subject> subject, const Recorded& recorded,
                       const std::vector<std::string>& names, const ApproximationOptions& options) {
  const fit::Separable problem(*subject, *recorded.record, recorded.prepared, recorded.means,
                               names);
  const std::vector<record::Parameter>& parameters = problem.parameters();
  const Eigen::VectorXd start = starting_values(parameters);
  std::vector<fit::SeparableFit> begun{problem.at(start)};
  for (const Eigen::VectorXd& other : options.starts) begun.push_back(problem.at(other));
  for (const Eigen::VectorXd& other : spread(problem, start, {}, most_spread, 3))
    begun.push_back(problem.at(other));
  boost::random::mt19937_64 engine(20210305);
  boost::random::uniform_01<double> any;
  for (int k = 0; k < options.random_starts && !problem.bending().empty(); ++k) {
    Eigen::VectorXd x = start;
    for (const std::size_t j : problem.bending())
      x[static_cast<Eigen::Index>(j)] = between(parameters[j], any(engine));
    begun.push_back(problem.at(x));
  }
  fit::SeparableFit fit = best_of(problem, std::move(begun), options.polished, {}, options);
  return approximation_of(std::move(subject), names, problem.parameters(), std::move(fit),
                          recorded.means);
}

/// From these values, with priors.
Approximation weighed(std::shared_ptr<const fit::Subject> subject, const Recorded& recorded,
                      const std::vector<std::string>& names, const Eigen::VectorXd& start,
                      double prior_weight) {
  const fit::Separable problem(*subject, *recorded.record, recorded.prepared, recorded.means, names,
                               prior_weight);
  Approximation result = approximation_of(std::move(subject), names, problem.parameters(),
                                          problem.from(start), recorded.means);
  result.prior_weight = prior_weight;
  return result;
}

struct NamedValues {
  std::vector<record::NamedValue> list{};
  [[nodiscard]] const double* find(const std::string& name) const {
    const auto at = std::find_if(list.begin(), list.end(),
                                 [&](const record::NamedValue& v) { return v.name == name; });
    return at == list.end() ? nullptr : &at->value;
  }
  [[nodiscard]] std::vector<std::string> others(const std::vector<std::string>& names) const {
    std::vector<std::string> rest;
    std::copy_if(names.begin(), names.end(), std::back_inserter(rest),
                 [&](const std::string& name) { return find(name) == nullptr; });
    return rest;
  }
};

/// Parameters with a prior of which the record tells next to nothing.
NamedValues untold(const Approximation& a, const Recorded& recorded) {
  constexpr double least_share = 0.1;  // of the variance of the prior, taken away by the record
  const ApproximationErrors errors = errors_of(a, recorded);
  NamedValues result;
  for (std::size_t k = 0; k < a.names.size(); ++k) {
    const record::Parameter& p = a.parameters[k];
    const auto at = static_cast<Eigen::Index>(k);
    if (p.prior.is_known() && p.at_bound == record::Bound::none &&
        !(errors.covariance(at, at) < (1.0 - least_share) * p.prior.std * p.prior.std))
      result.list.push_back({p.name, p.prior.value});
  }
  return result;
}

/// With the parameters of these names at their priors.
Approximation staying(const Approximation& a, const Recorded& recorded, const NamedValues& stay) {
  const std::vector<std::string> names = stay.others(a.names);
  Eigen::VectorXd start(names.size());
  Approximation result;
  std::vector<record::Parameter> stays;
  for (std::size_t k = 0, j = 0; k < a.names.size(); ++k) {
    const auto at = static_cast<Eigen::Index>(k);
    if (const double* const value = stay.find(a.names[k])) {
      record::Parameter p = a.parameters[k];
      p.value = *value;
      p.std = p.prior.std;
      p.held = true;
      p.identifiable = false;
      stays.push_back(std::move(p));
    } else {
      start[static_cast<Eigen::Index>(j++)] = a.fit.values[at];
    }
  }
  result = weighed(a.subject->with_values(stay.list), recorded, names, start, a.prior_weight);
  result.stays = std::move(stays);
  return result;
}

}  // namespace

Approximation approximate(std::shared_ptr<const fit::Subject> subject, const Recorded& recorded,
                          const std::vector<std::string>& names,
                          const ApproximationOptions& options) {
  if (subject->is_costly()) {
    const fit::CostlyProblem costly(*subject, *recorded.record, recorded.prepared, recorded.means,
                                    names);
    return costly_approximation(
        subject, recorded, names, costly,
        costly.from(starting_values(costly.parameters()), {settled_misfit}));
  }
  NamedValues priors;
  for (const record::Parameter& p : fit::find_parameters(*subject, names))
    if (p.prior.is_known())
      priors.list.push_back({p.name, std::clamp(p.prior.value, p.lower, p.upper)});
  if (priors.list.empty()) return searched(std::move(subject), recorded, names, options);

  const std::vector<std::string> others = priors.others(names);
  const Approximation beside =
      searched(subject->with_values(priors.list), recorded, others, options);
  if (!std::isfinite(beside.fit.misfit)) return beside;
  Eigen::VectorXd start(names.size());
  for (std::size_t k = 0, j = 0; k < names.size(); ++k) {
    const double* const value = priors.find(names[k]);
    start[static_cast<Eigen::Index>(k)] =
        value ? *value : beside.fit.values[static_cast<Eigen::Index>(j++)];
  }
  constexpr int most_rounds = 8;
  constexpr double settled = 0.05, of_exact_readings = 1e-30;
  double weight = std::max(of_exact_readings, errors_of(beside, recorded).variance);
  Approximation a = weighed(subject, recorded, names, start, weight);
  for (int round = 0; round < most_rounds && std::isfinite(a.fit.misfit); ++round) {
    const double next = std::max(of_exact_readings, errors_of(a, recorded).variance);
    if (std::abs(next - weight) <= settled * weight) break;
    weight = next;
    a = weighed(subject, recorded, names, a.fit.values, weight);
  }
  if (!std::isfinite(a.fit.misfit)) return a;
  const NamedValues stay = untold(a, recorded);
  return stay.list.empty() || stay.list.size() == names.size() ? a : staying(a, recorded, stay);
}

void require_fit(const Approximation& approximation) {
  if (approximation.fit.values.size() == 0 || !std::isfinite(approximation.fit.misfit))
    throw std::invalid_argument(
        "the fit has no start values that predict every reading; raceway compare names the rows "
        "without a prediction and the reason");
}

namespace {

/// All combinations of trial values of the bending parameters of candidates, with the base as it
/// ended; places stay as they are.
std::vector<fit::SeparableFit> tried(const fit::Separable& problem, const Eigen::VectorXd& start,
                                     std::size_t first,
                                     const std::vector<const std::vector<double>*>& only) {
  const std::vector<record::Parameter>& parameters = problem.parameters();
  std::vector<std::size_t> bending;
  for (const std::size_t k : problem.bending())
    if (k >= first && only[k] == nullptr) bending.push_back(k);
  std::vector<std::vector<double>> values;
  std::size_t count = 1;
  const std::size_t each = bending.size() > 2 ? 3 : bending.size() > 1 ? 4 : trials;
  for (const std::size_t k : bending) {
    std::vector<double>& list = values.emplace_back();
    for (std::size_t i = 0; i < each; ++i)
      list.push_back(
          between(parameters[k], (static_cast<double>(i) + 0.5) / static_cast<double>(each)));
    count *= list.size();
  }
  std::vector<fit::SeparableFit> begun;
  for (std::size_t n = 0; n < count; ++n) {
    Eigen::VectorXd x = start;
    std::size_t rest = n;
    for (std::size_t j = 0; j < bending.size(); ++j) {
      x[static_cast<Eigen::Index>(bending[j])] = values[j][rest % values[j].size()];
      rest /= values[j].size();
    }
    begun.push_back(problem.at(x));
  }
  return begun;
}

/// Where a parameter that is the place of the one before it serves best, all else as it is.
double best_place(const fit::Separable& problem, const fit::SeparableFit& fit, std::size_t k,
                  const std::vector<double>& only) {
  const auto best_of = [&](const std::vector<double>& list) {
    const std::vector<double> falls = problem.falls(fit.values, k - 1, k, list);
    return list[static_cast<std::size_t>(std::max_element(falls.begin(), falls.end()) -
                                         falls.begin())];
  };
  const std::size_t some = std::min(only.size(), coarse);
  std::vector<double> list;
  for (std::size_t i = 0; i < some; ++i)
    list.push_back(only[(2 * i + 1) * only.size() / (2 * some)]);
  const double about = best_of(list);
  const auto here = std::lower_bound(only.begin(), only.end(), about) - only.begin();
  const auto reach = static_cast<std::ptrdiff_t>(only.size() / some + 1);
  return best_of({only.begin() + std::max<std::ptrdiff_t>(0, here - reach),
                  only.begin() + std::min<std::ptrdiff_t>(std::ssize(only), here + reach + 1)});
}

/// With places found one after the other, and further ones as long as each takes enough. `off`:
/// values with which none is in use.
fit::SeparableFit placed(const fit::Separable& problem, fit::SeparableFit fit,
                         const Eigen::VectorXd& off,
                         const std::vector<const std::vector<double>*>& only) {
  for (std::size_t k = 0; k < only.size(); ++k) {
    if (only[k] == nullptr) continue;
    const auto at = static_cast<Eigen::Index>(k);
    const bool in_use = fit.values[at] != off[at];
    const bool is_first = k < 2 || only[k - 2] == nullptr;
    Eigen::VectorXd x = fit.values;
    x[at] = best_place(problem, fit, k, *only[k]);
    fit::SeparableFit next = problem.at(x);
    const double needed = in_use || is_first ? 1.0 : worth_another;
    if (next.misfit < needed * fit.misfit)
      fit = std::move(next);
    else if (!in_use)
      break;
  }
  return fit;
}

/// The same after all else was fitted, as long as it helps.
fit::SeparableFit placed_again(const fit::Separable& problem, fit::SeparableFit fit,
                               const Eigen::VectorXd& off,
                               const std::vector<const std::vector<double>*>& only,
                               const std::vector<bool>& held) {
  for (int round = 0; round < replacements; ++round) {
    const fit::SeparableFit moved = placed(problem, fit, off, only);
    if (!(moved.misfit < (1.0 - same_hollow) * fit.misfit)) break;
    fit = problem.from(moved.values, -1, held);
  }
  return fit;
}

}  // namespace

Approximation approximate_with(const Approximation& base, const Recorded& recorded,
                               const std::vector<const fit::Candidate*>& candidates,
                               const ApproximationOptions& options) {
  std::vector<std::string> ids, names = base.names;
  for (const fit::Candidate* c : candidates) {
    ids.push_back(c->id);
    for (const record::Parameter& p : c->parameters) names.push_back(p.name);
  }
  std::shared_ptr<const fit::Subject> subject = base.subject->with_candidates(ids);
  if (subject->is_costly()) {
    const fit::CostlyProblem costly(*subject, *recorded.record, recorded.prepared, recorded.means,
                                    names);
    return costly_approximation(
        std::move(subject), recorded, names, costly,
        costly.beyond({base.fit, base.slope, base.begin}, starting_values(costly.parameters()),
                      places_of_sizes(base.names.size(), candidates),
                      {.settled = options.rough ? roughly_settled : settled_misfit,
                       .hopeless = hopeless * base.fit.misfit,
                       .rough = options.rough}));
  }
  const fit::Separable problem(*subject, *recorded.record, recorded.prepared, recorded.means, names,
                               base.prior_weight);
  std::vector<const std::vector<double>*> only(base.names.size(), nullptr);
  std::vector<bool> held(names.size(), false);
  for (const fit::Candidate* c : candidates)
    for (std::size_t k = 0; k < c->parameters.size(); ++k) {
      const bool few = k < c->only.size() && !c->only[k].empty();
      held[only.size()] = few;
      only.push_back(few ? &c->only[k] : nullptr);
    }
  Eigen::VectorXd start(names.size());
  start.head(base.fit.values.size()) = base.fit.values;
  for (std::size_t k = base.names.size(); k < names.size(); ++k)
    start[static_cast<Eigen::Index>(k)] = problem.parameters()[k].start;
  std::vector<fit::SeparableFit> begun = tried(problem, start, base.names.size(), only);
  for (const Eigen::VectorXd& other : options.starts) begun.push_back(problem.at(other));
  const auto best = std::min_element(
      begun.begin(), begun.end(),
      [](const fit::SeparableFit& a, const fit::SeparableFit& b) { return a.misfit < b.misfit; });
  const bool has_places = std::find(held.begin(), held.end(), true) != held.end();
  if (has_places) {
    fit::SeparableFit found = placed(problem, std::move(*best), start, only);
    // A base that was bent far to hide jumps shows them where they are not.
    for (const Eigen::VectorXd& other :
         spread(problem, start, held, options.random_starts / 2, 2)) {
      fit::SeparableFit next = placed_again(
          problem, problem.from(placed(problem, problem.at(other), start, only).values, -1, held),
          start, only, held);
      if (next.misfit < found.misfit) found = std::move(next);
    }
    *best = std::move(found);
  }
  // Where the base was bent to hide the effect, its own time constants have to move first.
  boost::random::mt19937_64 engine(20210305);
  boost::random::uniform_01<double> any;
  const Eigen::VectorXd found = best->values;
  for (int k = 0; k < options.random_starts; ++k) {
    Eigen::VectorXd x = found;
    for (const std::size_t j : problem.bending())
      if (!held[j]) x[static_cast<Eigen::Index>(j)] = between(problem.parameters()[j], any(engine));
    begun.push_back(problem.at(x));
  }
  fit::SeparableFit fit = best_of(problem, std::move(begun), options.polished, held, options);
  if (has_places && std::isfinite(fit.misfit))
    fit = placed_again(problem, std::move(fit), start, only, held);
  Approximation result = approximation_of(std::move(subject), names, problem.parameters(),
                                          std::move(fit), recorded.means);
  result.prior_weight = base.prior_weight;
  result.stays = base.stays;
  return result;
}

namespace {

/// What may take some values alone, and stays where it was found.
bool is_place(const record::Parameter& p) {
  return !std::isfinite(p.upper - p.lower) && !p.proportional;
}

/// A fit to all but one block, with the jumps within that block as they were found: of a zero that
/// changes there nothing outside of it tells. Nothing where there are none.
std::optional<fit::SeparableFit> with_jumps_of(const Approximation& a, const Recorded& recorded,
                                               int block) {
  double first = unset, last = unset;
  for (const fit::Means::Mean& mean : recorded.means.list)
    if (mean.block == block) {
      first = std::fmin(first, mean.time);
      last = std::fmax(last, mean.time);
    }
  std::vector<record::NamedValue> given;
  std::vector<std::size_t> rest;
  for (std::size_t k = 0; k < a.names.size(); ++k) {
    const auto value = [&](std::size_t of) { return a.fit.values[static_cast<Eigen::Index>(of)]; };
    const auto is_within = [&](std::size_t place) {
      return place < a.names.size() && is_place(a.parameters[place]) && value(place) >= first &&
             value(place) <= last;
    };
    if (is_within(k) || (a.parameters[k].proportional && is_within(k + 1)))
      given.push_back({a.names[k], value(k)});
    else
      rest.push_back(k);
  }
  if (given.empty()) return std::nullopt;
  const std::unique_ptr<fit::Subject> subject = a.subject->with_values(given);
  std::vector<std::string> names;
  std::vector<bool> held;
  Eigen::VectorXd start(rest.size());
  for (std::size_t j = 0; j < rest.size(); ++j) {
    names.push_back(a.names[rest[j]]);
    held.push_back(is_place(a.parameters[rest[j]]));
    start[static_cast<Eigen::Index>(j)] = a.fit.values[static_cast<Eigen::Index>(rest[j])];
  }
  return fit::Separable(*subject, *recorded.record, recorded.prepared, recorded.means, names,
                        a.prior_weight)
      .from(start, block, held);
}

}  // namespace

namespace {

/// What is left of the means of a block by a fit to all others: of what is not costly by such a
/// fit, otherwise by the derivatives.
std::function<Eigen::VectorXd(int)> fits_without(const Approximation& a, const Recorded& recorded) {
  const fit::Means& means = recorded.means;
  if (a.subject->is_costly())
    return [&a, &means](int block) {
      return fit::left_of_block({a.fit, a.slope}, a.parameters, means, block);
    };
  const auto problem = std::make_shared<const fit::Separable>(
      *a.subject, *recorded.record, recorded.prepared, means, a.names, a.prior_weight);
  std::vector<bool> held(a.names.size(), false);
  for (std::size_t k = 0; k < a.names.size(); ++k) held[k] = is_place(a.parameters[k]);
  return [&a, &recorded, problem, held](int block) {
    const std::optional<fit::SeparableFit> given = with_jumps_of(a, recorded, block);
    return given ? given->residual : problem->from(a.fit.values, block, held).residual;
  };
}

}  // namespace

void hold_out(Approximation& a, const Recorded& recorded) {
  const fit::Means& means = recorded.means;
  a.held_out.assign(means.list.size(), unset);
  if (a.fit.values.size() == 0) return;
  int blocks = 0;
  for (const fit::Means::Mean& mean : means.list) blocks = std::max(blocks, mean.block + 1);
  const auto left_without = fits_without(a, recorded);
  double sum = 0.0;
  std::size_t count = 0;
  for (int b = 0; b < blocks; ++b) {
    const auto in_block = [&](const fit::Means::Mean& mean) { return mean.block == b; };
    if (std::none_of(means.list.begin(), means.list.end(), in_block)) continue;
    const Eigen::VectorXd without = left_without(b);
    for (std::size_t i = 0; i < means.list.size(); ++i)
      if (means.list[i].block == b) {
        a.held_out[i] = without[static_cast<Eigen::Index>(i)];
        const double weighted = a.held_out[i] * means.list[i].weight;
        sum += weighted * weighted;
        ++count;
      }
  }
  a.rms_held_out = count > 0 ? std::sqrt(sum / static_cast<double>(count)) : unset;
  a.channel_held_out = rms_by_channel(means, a.held_out);
}

namespace {

constexpr std::size_t most_single_rows = 20000;  // that are fitted one by one
constexpr double almost_no_ridge = 1e-12;

/// Two lags that only a ridge has held apart say nothing by themselves.
bool runs_away(const Eigen::VectorXd& values, const Eigen::VectorXd& from) {
  constexpr double far = 10.0;
  for (Eigen::Index k = 0; k < values.size(); ++k)
    if (!(std::abs(values[k]) <= far * std::abs(from[k]) + far)) return true;
  return false;
}

}  // namespace

Approximation finished(const Approximation& rough, const Recorded& recorded) {
  const fit::CostlyProblem costly(*rough.subject, *recorded.record, recorded.prepared,
                                  recorded.means, rough.names);
  fit::CostlyFit from{rough.fit, rough.slope};
  from.fit.converged = false;
  return costly_approximation(rough.subject, recorded, rough.names, costly,
                              costly.onwards(from, {settled_misfit}));
}

Approximation refined(const Approximation& a, const Recorded& by_means, Recorded& rows) {
  const double width =
      by_means.record->rows() > most_single_rows ? usual_width(*by_means.record) : 0.0;
  rows = recorded(*a.subject, by_means.record, width);
  if (a.subject->is_costly()) {
    const fit::CostlyProblem costly(*a.subject, *rows.record, rows.prepared, rows.means, a.names);
    Approximation found = costly_approximation(a.subject, rows, a.names, costly,
                                               costly.from(a.fit.values, {well_settled}));
    found.rms_held_out = a.rms_held_out;
    found.channel_held_out = a.channel_held_out;
    return found;
  }
  // As many more rows as there are, as much less each tells.
  const double prior_weight = a.prior_weight * static_cast<double>(rows.means.size()) /
                              static_cast<double>(by_means.means.size());
  const fit::Separable problem(*a.subject, *rows.record, rows.prepared, rows.means, a.names,
                               prior_weight);
  std::vector<bool> held(a.names.size(), false);
  for (std::size_t k = 0; k < a.names.size(); ++k)
    held[k] = !std::isfinite(a.parameters[k].upper - a.parameters[k].lower) &&
              !a.parameters[k].proportional;
  fit::SeparableFit fit = problem.from(a.fit.values, -1, held, almost_no_ridge);
  if (!fit.values.allFinite() || runs_away(fit.values, a.fit.values))
    fit = problem.from(a.fit.values, -1, held);
  Approximation result =
      approximation_of(a.subject, a.names, problem.parameters(), std::move(fit), rows.means);
  result.rms_held_out = a.rms_held_out;
  result.channel_held_out = a.channel_held_out;
  result.prior_weight = prior_weight;
  result.stays = a.stays;
  return result;
}

fit::Refit refit_of(const Approximation& a, const Recorded& recorded) {
  fit::Refit refit{.subject = fitted(a)};
  for (std::size_t i = 0; i < a.held_out.size(); ++i) {
    const fit::Means::Mean& mean = recorded.means.list[i];
    if (std::isnan(a.held_out[i])) continue;
    const auto place = static_cast<std::size_t>(mean.places[mean.places.size() / 2]);
    refit.held_out.push_back(
        {mean.channel, place % recorded.record->rows(), mean.block, -a.held_out[i]});
  }
  return refit;
}

std::shared_ptr<const fit::Subject> fitted(const Approximation& a) {
  std::vector<record::NamedValue> values;
  for (std::size_t k = 0; k < a.names.size(); ++k)
    values.push_back({a.names[k], a.fit.values[static_cast<Eigen::Index>(k)]});
  return a.subject->with_values(values);
}

}  // namespace raceway::tolerance
