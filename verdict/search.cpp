#include "verdict/search.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "verdict/effect_sizes.h"
#include "verdict/unknown_shape.h"

namespace raceway::verdict {

namespace {

constexpr double loss_of_a_member = 60.0;  // of a pair, in -2 ln L
constexpr double loss_of_a_third = 30.0;   // of a triple
constexpr std::size_t most_bent = 3;       // candidates whose laws are bent
constexpr double most_of_it = 0.5;         // of the mean square that a part of an answer takes
constexpr double as_near = 1.2;            // of a held-out error: no reason to prefer the better

}  // namespace

Search::Search(const Evidence& evidence, const Attribution& attribution,
               const std::vector<fit::Blocking>& blockings, SearchLimits limits)
    : evidence_(evidence),
      problem_(evidence.problem),
      attribution_(attribution),
      blockings_(blockings),
      limits_(std::move(limits)) {}

void Search::refit_singles() { singles_ = attribution_.singles(); }

std::vector<std::string> Search::ids_of(const Explanation& e) const {
  std::vector<std::string> ids;
  for (const std::size_t k : e.members) ids.push_back(problem_.candidates[k].id());
  return ids;
}

bool Search::is_base_law(const Explanation& single) const {
  return problem_.candidates[single.members.front()].candidate.base_law;
}

/// Candidates admitted and within reach of the best; the first is the best.
std::vector<const Explanation*> Search::within_reach_of_best(const Ranked& list,
                                                             double needed) const {
  std::vector<const Explanation*> set;
  for (const Explanation& e : list)
    if (e.fit.converged && e.gain > needed && e.gain >= list.front().gain - within_reach)
      set.push_back(&e);
  return set;
}

bool Search::any_passes(Ranked& list, const std::vector<const Explanation*>& set) const {
  bool passes = false;
  for (Explanation& e : list) {
    if (std::find(set.begin(), set.end(), &e) == set.end()) continue;
    attribution_.recheck(e);
    passes = passes || e.recheck.p_value() >= passed;
  }
  return passes;
}

Finding Search::explain() {
  if (auto found = one_candidate()) return *std::move(found);
  if (evidence_.few_rows) return {};
  if (auto found = both_base_laws()) return *std::move(found);
  std::optional<Finding> two = two_candidates();
  if (auto three = three_candidates()) return *std::move(three);
  if (two && is_physics_alone(*two->set.front())) return *std::move(two);
  Finding bent = bent_law();
  // An effect by a slightly other law and that effect beside a wrong datum look alike.
  if (two && (bent.set.empty() || bent.set.front()->gain < two->set.front()->gain - within_reach))
    return *std::move(two);
  if (bent.set.empty() && !base_laws_.empty())
    return {Finding::Kind::base_laws, {&base_laws_.front()}};
  return bent;
}

std::optional<Finding> Search::one_candidate() {
  std::vector<const Explanation*> set = within_reach_of_best(singles_, limits_.needed_gain);
  // The base law's own corrections come before physics.
  std::stable_partition(set.begin(), set.end(),
                        [this](const Explanation* e) { return is_base_law(*e); });
  if (!any_passes(singles_, set)) return std::nullopt;
  if (!evidence_.few_rows) add_bent_physics(set);
  return Finding{Finding::Kind::single, std::move(set)};
}

bool Search::is_physics(const Explanation& e) const {
  return std::any_of(e.members.begin(), e.members.end(), [this](std::size_t k) {
    const fit::Candidate& c = problem_.candidates[k].candidate;
    return c.datum.empty() && !c.empirical;
  });
}

bool Search::is_physics_alone(const Explanation& e) const {
  return std::all_of(e.members.begin(), e.members.end(), [this](std::size_t k) {
    return problem_.candidates[k].candidate.datum.empty();
  });
}

/// A wrong datum and an effect by a slightly other law than the catalogue's look alike, and so does
/// a shape without a law: where only these are named, the effects that come as near with their laws
/// bent stand beside them.
void Search::add_bent_physics(std::vector<const Explanation*>& set) {
  if (set.empty() ||
      std::any_of(set.begin(), set.end(), [this](const auto* e) { return is_physics(*e); }))
    return;
  const double best = set.front()->gain;
  bent_.clear();
  bent_.reserve(most_bent);
  std::size_t tried = 0;
  for (const Explanation& single : singles_) {
    if (!single.fit.converged || single.gain < limits_.needed_gain || tried == most_bent) break;
    if (!is_physics(single)) continue;
    ++tried;
    Explanation e = attribution_.elastic(single);
    if (!e.fit.converged || e.gain < best - within_reach) continue;
    attribution_.recheck(e);
    if (e.recheck.p_value() < passed) continue;
    bent_.push_back(std::move(e));
    set.push_back(&bent_.back());
  }
}

/// The base law with two of its own corrections comes before two effects of physics, by the rule of
/// every pair.
std::optional<Finding> Search::both_base_laws() {
  std::vector<std::size_t> members;
  double alone = 0.0;
  for (const Explanation& single : singles_)
    if (is_base_law(single) && single.fit.converged) {
      members.push_back(single.members.front());
      alone = std::max(alone, single.gain);
    }
  if (members.size() != 2) return std::nullopt;
  std::sort(members.begin(), members.end());
  Explanation pair = attribution_.refit(members);
  if (!pair.fit.converged || pair.gain < alone + limits_.needed_gain) return std::nullopt;
  pair.least_loss = pair.gain - alone;
  attribution_.recheck(pair);
  if (pair.recheck.p_value() < passed) return std::nullopt;
  const bool shown = pair.gain >= gain_beyond(singles_, 1) && pair.least_loss >= loss_of_a_member;
  base_laws_ = {std::move(pair)};
  if (!shown) return std::nullopt;
  return Finding{Finding::Kind::several, {&base_laws_.front()}};
}

double Search::gain_beyond(const Ranked& smaller, int choices) const {
  return std::log(static_cast<double>(problem_.measured().size())) +
         2.0 * std::log(std::max(1, choices)) +
         (smaller.front().fit.converged ? std::max(0.0, smaller.front().gain) : 0.0);
}

/// A size that nobody would believe explains nothing where a believable one does.
void Search::drop_implausible(Ranked& list) const {
  Ranked plausible;
  for (Explanation& e : list)
    if (sizes_plausible(problem_, e)) plausible.push_back(std::move(e));
  if (!plausible.empty()) list = std::move(plausible);
}

std::optional<Finding> Search::two_candidates() {
  if (!limits_.pairs || singles_.size() < 2) return std::nullopt;
  limits_.step(0.5, "refitting with pairs of effects");
  pairs_ = attribution_.pairs(singles_, limits_.cancelled);
  limits_.step(0.8, "checking the residual");
  drop_implausible(pairs_);
  attribution_.refine(pairs_, within_reach);
  std::vector<const Explanation*> two =
      within_reach_of_best(pairs_, gain_beyond(singles_, limits_.tried - 1));
  if (!any_passes(pairs_, two)) return std::nullopt;
  // Two effects before one and a datum; what the datum would do is said beside them.
  const Explanation* const best = two.front();
  std::stable_partition(two.begin(), two.end(),
                        [this](const auto* e) { return is_physics_alone(*e); });
  std::vector<const Explanation*> strong;
  for (const Explanation* e : two)
    if (e->least_loss >= loss_of_a_member) strong.push_back(e);
  if (!strong.empty() && (strong.front() == best || strong.front() == two.front())) {
    const auto data = std::find_if_not(strong.begin(), strong.end(),
                                       [this](const auto* e) { return is_physics_alone(*e); });
    Finding finding{Finding::Kind::several, {strong.begin(), data}, {data, strong.end()}};
    if (finding.set.empty()) finding.set.swap(finding.with_data);
    return finding;
  }
  for (const Explanation* e : two) weak_pairs_.push_back(ids_of(*e));
  return std::nullopt;
}

/// What the triple gains over the best of the pairs in it.
double Search::least_loss_of(const Explanation& triple) {
  double most = 0.0;
  for (const std::size_t left_out : triple.members) {
    std::vector<std::size_t> others = triple.members;
    std::erase(others, left_out);
    const auto known = std::find_if(pairs_.begin(), pairs_.end(),
                                    [&](const Explanation& e) { return e.members == others; });
    const bool whole = known != pairs_.end() && known->starts.empty();
    const Explanation pair = whole ? *known : attribution_.refit(others);
    if (pair.fit.converged) most = std::max(most, pair.gain);
  }
  return triple.gain - most;
}

/// Also where a pair would do, as long as the error on held-out blocks falls.
std::optional<Finding> Search::three_candidates() {
  if (pairs_.empty() || pairs_.front().gain <= gain_beyond(singles_, limits_.tried - 1))
    return std::nullopt;
  limits_.step(0.8, "refitting with three effects");
  triples_ = attribution_.triples(pairs_, singles_, limits_.cancelled);
  attribution_.refine(triples_, within_reach);
  const std::vector<const Explanation*> three =
      triples_.empty() ? std::vector<const Explanation*>()
                       : within_reach_of_best(triples_, gain_beyond(pairs_, limits_.tried - 2));
  if (three.empty() || !any_passes(triples_, three)) return std::nullopt;
  std::vector<const Explanation*> strong;
  for (Explanation& e : triples_) {
    if (std::find(three.begin(), three.end(), &e) == three.end()) continue;
    const bool at_bound =
        std::any_of(e.fit.at_bound.begin(), e.fit.at_bound.end(), [](bool at) { return at; });
    if (at_bound || !sizes_plausible(problem_, e)) continue;
    e.least_loss = least_loss_of(e);
    if (e.least_loss >= loss_of_a_third) strong.push_back(&e);
  }
  if (strong.empty() || strong.front() != three.front()) return std::nullopt;
  // One power of the inputs does as well: an effect of its own, in no catalogue.
  shape_ = find_unknown_shape(evidence_);
  if (shape_ && shape_->gain > strong.front()->gain - within_reach) return std::nullopt;
  const auto error = [this](const Explanation& e) {
    return held_out(evidence_, e.response, e.fit, blockings_);
  };
  const std::vector<double> with = error(*strong.front()), without = error(pairs_.front());
  for (std::size_t c = 0; c < with.size(); ++c)
    if (!(with[c] <= without[c])) return std::nullopt;
  return Finding{Finding::Kind::several, std::move(strong)};
}

/// True if a law bent to its limit is no better than a plain power of the inputs, which has as many
/// free numbers: what is missing then acts like something else.
bool Search::bent_too_far(const Explanation& bent) const {
  return bent.bent_to_a_bound() && shape_ && shape_->gain > bent.gain;
}

Finding Search::bent_law() {
  limits_.step(0.85, "testing other exponents");
  bent_.clear();
  shape_ = find_unknown_shape(evidence_);
  for (std::size_t k = 0; k < singles_.size() && k < most_bent; ++k) {
    if (!singles_[k].fit.converged || singles_[k].gain < limits_.needed_gain) continue;
    Explanation e = attribution_.elastic(singles_[k]);
    if (!e.fit.converged || bent_too_far(e)) continue;
    attribution_.recheck(e);
    if (e.recheck.p_value() >= passed) bent_.push_back(std::move(e));
  }
  std::stable_sort(bent_.begin(), bent_.end(),
                   [](const Explanation& a, const Explanation& b) { return a.gain > b.gain; });
  Finding finding;
  for (const Explanation& e : bent_)
    if (e.gain >= bent_.front().gain - within_reach) finding.set.push_back(&e);
  if (!finding.set.empty()) finding.kind = Finding::Kind::bent;
  return finding;
}

bool Search::raises_the_error(const Explanation& e) const { return !lowers_the_error(e, 0.0); }

bool Search::lowers_the_error(const Explanation& e, double share) const {
  const fit::Observations& observed = problem_.observed;
  const auto error = [&](const fit::ResponseFit& fit) {
    double square = 0.0;
    for (std::size_t c = 0; c < observed.channels.size(); ++c) {
      Eigen::VectorXd rest = observed.of(c, Eigen::VectorXd(observed.measured - fit.prediction));
      for (const std::size_t i : evidence_.noise[c].outliers)
        rest[static_cast<Eigen::Index>(i)] = 0;
      square += rest.squaredNorm() / std::pow(evidence_.noise[c].rms, 2);
    }
    return square;
  };
  return error(e.fit) <= std::pow(1.0 - share, 2) * error(evidence_.base);
}

double Search::share_of_tolerance(const fit::Response& response,
                                  const fit::ResponseFit& fit) const {
  const std::vector<double> errors = held_out_within_range(evidence_, response, fit, blockings_);
  double share = errors.empty() ? unset : 0.0;
  for (std::size_t c = 0; c < errors.size(); ++c)
    if (const double tolerance = problem_.observed.channels[c].tolerance; std::isfinite(tolerance))
      share = std::fmax(share, fit::beyond_noise(errors[c], evidence_.noise[c].rms) / tolerance);
  return share;
}

/// Explanations of certain gain and believable size whose held-out error is within the tolerance
/// and at most `most` of it; beside the best all that come as near, whether or not they are within.
/// By that error.
std::vector<const Explanation*> Search::good_enough(const Ranked& list, double most) const {
  std::vector<std::pair<double, const Explanation*>> order;
  for (const Explanation& e : list)
    if (e.fit.converged && e.gain > limits_.needed_gain && sizes_plausible(problem_, e))
      order.emplace_back(share_of_tolerance(e.response, e.fit), &e);
  std::stable_sort(order.begin(), order.end(),
                   [](const auto& a, const auto& b) { return a.first < b.first; });
  std::vector<const Explanation*> set;
  if (order.empty() || !(order.front().first <= std::min(1.0, most))) return set;
  for (const auto& [share, e] : order)
    if (share <= as_near * order.front().first) set.push_back(e);
  return set;
}

Finding Search::explain_within_tolerance() {
  if (auto set = good_enough(singles_, 1.0); !set.empty()) {
    // Where the best leaves nothing but noise, the likelihood tells the others from it.
    if (any_passes(singles_, {set.front()}))
      std::erase_if(set, [best = set.front()->gain](const Explanation* e) {
        return e->gain < best - within_reach;
      });
    return {Finding::Kind::single, std::move(set)};
  }
  double best = std::numeric_limits<double>::infinity();
  const Explanation* nearest = nullptr;
  for (const Explanation& single : singles_) {
    if (!single.fit.converged || !sizes_plausible(problem_, single)) continue;
    const double share = share_of_tolerance(single.response, single.fit);
    if (!(share < best)) continue;
    best = share;
    nearest = &single;
  }
  if (limits_.pairs && !evidence_.few_rows && singles_.size() >= 2) {
    limits_.step(0.5, "refitting with pairs of effects");
    pairs_ = attribution_.pairs(singles_, limits_.cancelled);
    attribution_.refine(pairs_, std::numeric_limits<double>::infinity());
    if (auto set = good_enough(pairs_, best / as_near); !set.empty())
      return {Finding::Kind::several, std::move(set)};
  }
  limits_.step(0.85, "fitting a power law to the misfit");
  shape_ = find_unknown_shape(evidence_);
  const double base = share_of_tolerance(evidence_.response, evidence_.base);
  if (!nearest || !(best * best <= most_of_it * base * base)) return {};
  return {Finding::Kind::partly, {nearest}};
}

}  // namespace raceway::verdict
