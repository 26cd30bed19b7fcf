#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "verdict/detail/investigation.h"
#include "verdict/effect_sizes.h"
#include "verdict/verdict_text.h"

// The sentence that a user reads first.
namespace raceway::verdict {

namespace {

constexpr std::size_t most_near = 3;  // named where nothing explains the misfit

}  // namespace

std::string_view name(Verdict verdict) {
  switch (verdict) {
    case Verdict::nothing_missing:
      return "nothing-missing";
    case Verdict::effect:
      return "effect";
    case Verdict::ambiguous:
      return "ambiguous";
    case Verdict::several_effects:
      return "several-effects";
    case Verdict::effect_like:
      return "effect-like";
    case Verdict::not_in_catalogue:
      return "not-in-catalogue";
  }
  return "unknown";
}

bool Diagnosis::tolerance_limited() const {
  return std::any_of(channels.begin(), channels.end(),
                     [](const ChannelDiagnosis& c) { return std::isfinite(c.tolerance); });
}

std::string Investigation::joined_sets(const Set& set) const {
  std::vector<std::string> names;
  for (const Explanation* e : set) names.push_back(id_of(*e));
  return joined(names, "or");
}

std::string Investigation::shifts() const {
  return base_is_identifiable() ? shift_text(result_) : "";
}

std::string Investigation::sentence() const {
  if (!is_anything_missing())
    return (result_.within_tolerance ? within_tolerance_text(result_)
                                     : nothing_missing_text(result_)) +
           hidden_text();
  if (outside_the_inputs())
    return fmt::format(
        "The cause is not an input of the model: at nearly equal operating points the readings of "
        "different runs differ by {:.0f} % ({}; {}), and no law of the inputs can explain this "
        "difference. Find out what changes from run to run before you add an effect.",
        100.0 * hidden_->scatter, p_text(hidden_->run_p_value), difference_text(record_, *hidden_));
  switch (finding_.kind) {
    case Finding::Kind::single:
      return single_text() + other_bases_text() + hidden_text();
    case Finding::Kind::several:
      return several_text() + other_bases_text() + hidden_text();
    case Finding::Kind::base_laws:
      return base_laws_text() + other_bases_text() + hidden_text();
    case Finding::Kind::bent:
      return bent_text() + other_bases_text() + hidden_text();
    case Finding::Kind::partly:
      return partly_text() + other_bases_text() + hidden_text();
    case Finding::Kind::none:
      break;
  }
  return unexplained_text() + other_bases_text() + hidden_text();
}

/// A warning beside a verdict: scatter of that size may be no scatter.
std::string Investigation::hidden_text() const {
  if (!hidden_) return {};
  return fmt::format(
      " But readings at nearly equal operating points differ by {:.0f} % ({}), which is more than "
      "their noise: a cause that is not an input of the model may change from row to row.",
      100.0 * hidden_->scatter, difference_text(record_, *hidden_));
}

/// What the explanation leaves, against the noise or what is allowed.
std::string Investigation::remains_text() const {
  if (!result_.tolerance_limited())
    return fmt::format("the residual is at noise level (p = {:.2g})", result_.remaining_p_value);
  std::vector<std::string> errors;
  for (const ChannelDiagnosis& c : result_.channels)
    if (std::isfinite(c.tolerance))
      errors.push_back(
          fmt::format("{:.3g} (tolerance {})",
                      fit::beyond_noise(c.rmse_held_out_after, c.noise.rms) / c.channel().factor,
                      reading_text(c.channel(), c.tolerance)));
  return fmt::format("the part of the held-out error that the noise does not explain is {}",
                     joined(errors, "and"));
}

/// Which of some explanations would be wrong data, and where to look first.
std::string Investigation::data_text(const Set& set) const {
  std::vector<std::string> ids, data;
  std::set<std::size_t> said;
  for (const Explanation* e : set)
    for (const std::size_t k : e->members) {
      const fit::Candidate& c = problem_.candidates[k].candidate;
      if (c.datum.empty() || !said.insert(k).second) continue;
      ids.push_back(c.id + " (" + correction_text(problem_, *e, k) + ")");
      if (std::find(data.begin(), data.end(), c.datum) == data.end()) data.push_back(c.datum);
    }
  if (ids.empty()) return "";
  std::vector<std::string> bent;
  for (const Explanation* e : set)
    if (e->elastic) bent.push_back(id_of(*e));
  const std::string by_another_law = bent.empty()
                                         ? ""
                                         : fmt::format(
                                               " {} fits only with exponents that differ slightly "
                                               "from the exponents in the catalogue.",
                                               joined(bent, "and"));
  return fmt::format("{} {} would mean wrong data, not missing physics: check {} first.",
                     by_another_law, joined(ids, "and"), joined(data, "and"));
}

std::string Investigation::single_text() const {
  const Set& set = finding_.set;
  const Explanation& best = *set.front();
  if (!plausible_ || !holds_ || !doubt_.empty())
    return fmt::format("Something is missing ({}); it acts like {}, {} (fitted size: {}).{}",
                       p_text(result_.p_value), joined_sets(set),
                       !plausible_ ? "but its size is implausible"
                       : !holds_   ? "but the held-out rows do not confirm it"
                                   : doubt_,
                       size_text(problem_, best), is_a_shape_alone(set) ? rivals_text() : "");
  if (set.size() == 1) {
    std::string next;
    for (const Explanation& e : search_->singles())
      if (&e != &best && e.fit.converged) {
        next =
            fmt::format(", next best {} with a gain lower by {:.0f}", id_of(e), best.gain - e.gain);
        break;
      }
    const fit::Candidate& named = problem_.candidates[best.members.front()].candidate;
    const std::string found =
        fmt::format("{}, {}; gain {:.0f} (needed {:.1f}), {}{}. Error {}{}.", named.id,
                    size_text(problem_, best), best.gain, result_.needed_gain, remains_text(), next,
                    error_text(result_), shifts());
    if (named.datum.empty()) return "Consistent with " + found;
    return fmt::format(
        "Check {}: {}. The misfit is consistent with wrong data rather than missing physics: {}",
        named.datum, correction_text(problem_, best, best.members.front()), found);
  }
  if (result_.tolerance_limited())
    return fmt::format(
        "{}: these explanations are equally good, so these data do not decide between them. "
        "With {}, {}.{}{}",
        joined_sets(set), id_of(best), remains_text(), data_text(set), measure_text(result_));
  return fmt::format(
      "{0}: one of these effects is {3} ({4}), but these data do not decide which (difference of "
      "the gains {1:.1f}, needed {2:.0f}).{5}{6}",
      joined_sets(set), std::abs(best.gain - set[1]->gain), within_reach,
      data_text(set).empty() ? "missing" : "the cause", p_text(result_.p_value), data_text(set),
      measure_text(result_));
}

/// The physics that comes nearest to a shape that stands for none.
std::string Investigation::rivals_text() const {
  const double best = finding_.set.front()->gain;
  std::vector<std::string> near;
  for (const Explanation& e : search_->singles())
    if (near.size() < most_near && e.fit.converged && e.gain > result_.needed_gain &&
        search_->is_physics(e) && sizes_plausible(problem_, e))
      near.push_back(fmt::format("{} (gain lower by {:.0f})", id_of(e), best - e.gain));
  if (near.empty()) return "";
  return fmt::format(" Physical effects with the most similar shape: {}.", joined(near, "and"));
}

std::string Investigation::several_text() const {
  const Set& set = finding_.set;
  const Explanation& best = *set.front();
  if (!holds_)
    return fmt::format(
        "Something is missing ({}); {} together explain the fitted rows, but the held-out rows do "
        "not confirm this.",
        p_text(result_.p_value), id_of(best));
  if (!doubt_.empty())
    return fmt::format(
        "Something is missing ({}); it acts like {} together, {} (fitted sizes: {}).",
        p_text(result_.p_value), id_of(best), doubt_, size_text(problem_, best));
  return fmt::format(
      "Consistent with {} together, {}; gain {:.0f}, which falls by {:.0f} without the weakest "
      "effect; {}.{} Error {}{}.{}{}",
      id_of(best), size_text(problem_, best), best.gain, best.least_loss, remains_text(),
      set.size() > 1
          ? fmt::format(" Number of other combinations of effects that are equally good: {}.",
                        set.size() - 1)
          : "",
      error_text(result_), shifts(), data_text(set) + instead_text(), measure_text(result_));
}

/// Wrong data that would do in the place of an effect.
std::string Investigation::instead_text() const {
  const std::string data = data_text(finding_.with_data);
  if (data.empty()) return data;
  std::set<std::string> beside;
  for (const Explanation* e : finding_.with_data)
    for (const std::size_t k : e->members)
      if (const fit::Candidate& c = problem_.candidates[k].candidate; c.datum.empty())
        beside.insert(c.id);
  const std::string effects = joined({beside.begin(), beside.end()}, "or");
  return fmt::format(" {} would explain the misfit as well:{}",
                     effects.empty() ? "Wrong data alone" : effects + " together with wrong data",
                     data);
}

std::string Investigation::base_laws_text() const {
  const Explanation& both = *finding_.set.front();
  return fmt::format(
      "Something is missing ({}). {} together explain the misfit ({}; {}). But the weaker effect "
      "adds a gain of only {:.0f}, which is too little to prove two effects. The model needs "
      "another base "
      "law, or another effect with a similar shape.",
      p_text(result_.p_value), id_of(both), size_text(problem_, both), remains_text(),
      both.least_loss);
}

std::string Investigation::bent_text() const {
  const Set& set = finding_.set;
  const std::vector<Explanation>& singles = search_->singles();
  const double pure = singles.empty() || !singles.front().rechecked
                          ? result_.p_value
                          : singles.front().recheck.p_value();
  std::vector<std::string> exponents;
  for (const record::NamedValue& e : set.front()->exponents)
    exponents.push_back(fmt::format("{} {:+.2f}", e.name, e.value));
  return fmt::format(
      "Something is missing that acts like {}, but with exponents that differ from the exponents "
      "in the catalogue by {} (with the exponents in the catalogue, the fit is rejected, {}). "
      "Either this effect follows another law here, or a similar effect is missing that is not in "
      "the catalogue.",
      joined_sets(set), fmt::join(exponents, ", "), p_text(pure));
}

std::string Investigation::partly_text() const {
  return fmt::format(
      "An important effect is missing. {} ({}) explains more than half of the misfit, but {}. "
      "Several effects are missing, or the model needs another law.",
      joined_sets(finding_.set), size_text(problem_, *finding_.set.front()), remains_text());
}

std::string Investigation::unexplained_text() const {
  std::string shape;
  if (result_.shape)
    shape = fmt::format(
        " A power law describes {1:.0f} % of the misfit: {0}; raceway add MODEL shape --data DATA "
        "adds this law.",
        result_.shape->statement, 100.0 * result_.shape->explained_share);
  std::string pairs;
  if (const auto& weak = search_->weak_pairs(); !weak.empty())
    pairs =
        " These pairs of effects could explain the misfit, but the data do not prove them: " +
        joined(weak.front(), "and") +
        (weak.size() > 1 ? fmt::format("; number of other such pairs: {}.", weak.size() - 1) : ".");
  return fmt::format("Something is missing ({}) that no effect of the catalogue explains.{}{}{}",
                     p_text(result_.p_value), nearest_text(), shape, pairs);
}

/// Which single effects of believable size come nearest, and how far what they leave is from
/// noise.
std::string Investigation::nearest_text() const {
  const auto taken = [&](const Explanation& e) {
    const double beyond = std::max(1.0, evidence_.base.misfit - degrees());
    return std::clamp((evidence_.base.misfit - e.fit.misfit) / beyond, 0.0, 1.0);
  };
  Set near;
  for (const Explanation& e : search_->singles())
    if (e.fit.converged && e.gain > result_.needed_gain && sizes_plausible(problem_, e) &&
        near.size() < most_near && (near.empty() || taken(e) > taken(*near.front()) - 0.1))
      near.push_back(&e);
  if (near.empty()) return "";
  const ChannelDiagnosis& first = result_.channels.front();
  const double left = rms_of(*near.front()).front();
  std::string text = fmt::format(
      " Best candidate: {}; {} explains {:.0f} % of the misfit and leaves an error of {}",
      joined_sets(near), near.size() > 1 ? id_of(*near.front()) : "it",
      100.0 * taken(*near.front()), reading_text(first.channel(), left));
  const double ratio = left / first.noise.rms;
  if (ratio > 2.0)
    text += fmt::format(
        ", {:.0f} times the noise: several effects are missing, or the model needs another law",
        ratio);
  return text + ".";
}

/// Which other base model does better, and what takes it.
std::string Investigation::other_bases_text() const {
  if (result_.other_bases.empty()) return "";
  const OtherBaseTried& best = result_.other_bases.front();
  if (!result_.given_other_base) {
    std::vector<std::string> names;  // of ids such as law:skf
    for (const OtherBaseTried& b : result_.other_bases)
      names.push_back(b.id.substr(b.id.find(':') + 1));
    return fmt::format(" None of the other base laws fits better (tested: law = {}).",
                       joined(names, "or"));
  }
  const ChannelDiagnosis& first = result_.channels.front();
  const std::string fall = fmt::format(
      "error {:.3g} -> {}, gain {:.0f} (needed {:.1f})", first.rmse_before / first.channel().factor,
      reading_text(first.channel(), best.rmse.front()), best.gain, result_.needed_gain);
  const std::string take = fmt::format("use it with: raceway add MODEL {} --data DATA", best.id);
  if (best.explains)
    return fmt::format(" {} {} these data: {}; {}.", best.words,
                       best.fitted_form ? "describes" : "explains", fall, take);
  std::vector<std::string> sets;
  for (const std::vector<std::string>& set : result_.given_other_base->sets)
    sets.push_back(joined(set, "and"));
  const std::string names = sets.empty() ? "" : ": " + joined(sets, "or");
  return fmt::format(" {} fits better: {}; {}. With {} the verdict is {}{}.", best.words, fall,
                     take, best.words, name(result_.given_other_base->verdict), names);
}

}  // namespace raceway::verdict
