#include "fit/diagnose.h"

#include <fmt/format.h>

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <set>

#include "fit/attribution.h"
#include "fit/effect_sizes.h"
#include "fit/evidence.h"
#include "fit/hidden_input.h"
#include "fit/quantity.h"
#include "fit/unknown_shape.h"
#include "fit/verdict_model.h"
#include "fit/verdict_text.h"
#include "fit/visibility.h"

namespace raceway::fit {

namespace {

constexpr double within_reach = 6.0;       // of the best, in -2 ln L
constexpr double beaten = 3.84;            // in -2 ln L: 95 % of one degree of freedom
constexpr double loss_of_a_member = 60.0;  // of a pair, in -2 ln L
constexpr double passed = 0.01;            // of the gate
constexpr std::size_t ranked = 6;          // effects with a hold-out of their own
constexpr std::size_t most_near = 3;       // named where nothing explains the misfit

double rms(const Eigen::VectorXd& v) { return v.norm() / std::sqrt(static_cast<double>(v.size())); }

/// One diagnosis in the making.
class Investigation {
 public:
  Investigation(const Model& model, const DataSet& data, const DiagnoseOptions& options)
      : options_(options),
        model_(model),
        subject_(subject_of(data.quantity)),
        user_made_(take_user_made(model_)),
        evidence_(gather_evidence(model_, data, candidates(), options.most_rows, options.noise)),
        problem_(evidence_.problem),
        attribution_(problem_, evidence_.noise, evidence_.base, evidence_.size),
        blockings_(blockings(problem_.data)) {}

  Diagnosis run() {
    describe_base();
    Visibility seen = what_can_be_seen(problem_, attribution_);
    result_.candidates_tried =
        static_cast<int>(seen.would_have_been_found.size()) + options_.tried_before;
    result_.would_have_been_found = std::move(seen.would_have_been_found);
    result_.not_testable = std::move(seen.not_testable);
    result_.aliases = std::move(seen.aliases);
    const double rows = static_cast<double>(problem_.measured.size());
    result_.needed_gain = std::log(rows) + 2.0 * std::log(std::max(1, result_.candidates_tried));
    result_.p_value = attribution_.gate().p_value();
    result_.remaining_p_value = result_.p_value;
    const std::optional<HiddenInput> hidden = find_hidden_input(problem_.data);
    const bool by_runs = hidden && hidden->follows_the_runs();
    if (!attribution_.gate().alarm() && !by_runs) {
      nothing_missing();
      if (hidden) warn_of(*hidden);
      return std::move(result_);
    }
    step(0.2, "refitting with each effect");
    singles_ = attribution_.singles();
    for (const Explanation& single : singles_)
      if (!single.fit.converged)
        result_.messages.push_back(fmt::format(
            "the fit with {} did not converge: it takes no part in the verdict", id_of(single)));
    if (by_runs) {
      outside_the_inputs(*hidden);
      return std::move(result_);
    }
    attribute();
    if (hidden) warn_of(*hidden);
    return std::move(result_);
  }

 private:
  [[nodiscard]] std::vector<const effects::Description*> candidates() const {
    std::vector<const effects::Description*> all = options_.candidates;
    if (all.empty()) all = catalogue_of(subject_);
    for (const effects::Effect& e : user_made_) all.push_back(e.description);
    std::erase_if(all, [this](const effects::Description* d) { return !d->moves(subject_); });
    return all;
  }

  [[nodiscard]] bool cancelled() const { return options_.cancelled && options_.cancelled->load(); }

  void step(double share, std::string_view what) const {
    if (cancelled()) throw Cancelled();
    if (options_.progress) options_.progress(share, what);
  }

  [[nodiscard]] const std::string& id(std::size_t candidate) const {
    return problem_.candidates[candidate].id;
  }
  [[nodiscard]] std::string id_of(const Explanation& e) const { return joined(ids_of(e), "and"); }
  [[nodiscard]] std::vector<std::string> ids_of(const Explanation& e) const {
    std::vector<std::string> ids;
    for (const std::size_t k : e.members) ids.push_back(id(k));
    return ids;
  }

  [[nodiscard]] bool base_is_identifiable() const {
    Eigen::MatrixXd columns = evidence_.base.tangent;
    if (columns.cols() == 0) return true;
    columns.colwise().normalize();
    Eigen::ColPivHouseholderQR<Eigen::MatrixXd> qr(columns);
    qr.setThreshold(1e-4);
    return qr.rank() == columns.cols();
  }

  [[nodiscard]] bool is_base_exponent(const Explanation& single) const {
    const std::string& name = id(single.members.front());
    return name == "viscous-exponent" || name == "load-exponent";
  }

  /// Declared standard deviations are not the scatter that is found.
  void tell_declared_noise() {
    if (problem_.data.noise != NoiseSource::declared) return;
    double square = 0.0;
    for (const Row& row : problem_.data.rows) square += row.std * row.std;
    const double declared = std::sqrt(square / static_cast<double>(problem_.data.rows.size()));
    const double ratio = evidence_.noise.rms / declared;
    if (ratio < 1.5 && ratio > 1.0 / 1.5) return;
    const QuantityText quantity = text_of(problem_.data.quantity);
    result_.messages.push_back(fmt::format(
        "std_{} weighs the rows against each other; the noise is what a saturated regression "
        "leaves, {:.3g} {} where {:.3g} are declared",
        quantity.key_unit, evidence_.noise.rms / quantity.factor, quantity.unit,
        declared / quantity.factor));
  }

  void describe_base() {
    const std::vector<double> predicted(
        evidence_.base.prediction.data(),
        evidence_.base.prediction.data() + evidence_.base.prediction.size());
    result_.baseline =
        compare(predicted, problem_.data, static_cast<int>(evidence_.base.tangent.cols()));
    result_.noise = evidence_.noise;
    result_.rows = static_cast<int>(problem_.data.rows.size());
    result_.rows_not_predicted = problem_.rows_not_predicted;
    result_.rmse_before = rms(problem_.measured - evidence_.base.prediction);
    for (const std::size_t i : evidence_.noise.outliers)
      result_.outlier_lines.push_back(problem_.data.rows[i].line);
    std::sort(result_.outlier_lines.begin(), result_.outlier_lines.end());
    if (!result_.outlier_lines.empty())
      result_.messages.push_back(
          fmt::format("{} row(s) stand more than 3.5 standard deviations apart and count with less "
                      "weight, first line {}",
                      result_.outlier_lines.size(), result_.outlier_lines.front()));
    if (result_.rows + static_cast<int>(result_.rows_not_predicted.size()) < evidence_.rows_in_file)
      result_.messages.push_back(fmt::format("{} of {} rows were used, evenly spread in time",
                                             result_.rows, evidence_.rows_in_file));
    if (!result_.rows_not_predicted.empty())
      result_.messages.push_back(
          fmt::format("{} row(s) without balance were left out, first line {}",
                      result_.rows_not_predicted.size(), result_.rows_not_predicted.front()));
    for (std::size_t k = 0; k < evidence_.base.at_bound.size(); ++k)
      if (evidence_.base.at_bound[k])
        result_.messages.push_back(evidence_.response.parameters[k].name +
                                   " ends at a bound: the model lacks something, or is far off");
    if (!evidence_.hint.empty()) result_.messages.push_back(evidence_.hint);
    tell_declared_noise();
    for (const std::string& name : evidence_.idle)
      result_.messages.push_back("the readings do not depend on " + name +
                                 ", which stays as it is");
    if (!base_is_identifiable())
      result_.messages.push_back(joined(problem_.base, "and") +
                                 " cannot all be told apart on these data: their values mean "
                                 "little; free fewer of them under [calibration]");
    if (evidence_.noise.repeats_p_value < passed)
      result_.messages.push_back(fmt::format(
          "repeated rows scatter {:.2g} times as much as the noise found otherwise (p = {:.1g})",
          std::sqrt(evidence_.noise.repeats_statistic), evidence_.noise.repeats_p_value));
  }

  /// A warning beside a verdict: scatter of that size may be no scatter.
  void warn_of(const HiddenInput& hidden) {
    result_.sentence += fmt::format(
        " But readings at nearly equal operating points differ by {:.0f} % ({}), more than a "
        "rig scatters: something that is in no input of the model may change from row to row.",
        100.0 * hidden.scatter, difference_text(problem_.data, hidden));
  }

  /// Runs that read differently at equal operating points: no effect of these inputs can do that.
  void outside_the_inputs(const HiddenInput& hidden) {
    result_.verdict = Verdict::not_in_catalogue;
    fill({}, singles_.empty() ? Explanation{} : singles_.front());
    result_.sentence = fmt::format(
        "Something is missing that is in no input of the model: at nearly equal operating points "
        "runs differ by {:.0f} % ({}; {}), which no law of speed, load and temperature can do. "
        "Find what changes from run to run before adding an effect.",
        100.0 * hidden.scatter, p_text(hidden.run_p_value), difference_text(problem_.data, hidden));
  }

  void nothing_missing() {
    result_.verdict = Verdict::nothing_missing;
    result_.rmse_after = result_.rmse_before;
    result_.sentence = nothing_missing_text(result_);
  }

  /// Candidates admitted and within reach of the best; the first is the best.
  static std::vector<const Explanation*> best_set(const std::vector<Explanation>& ranked_list,
                                                  double needed) {
    std::vector<const Explanation*> set;
    for (const Explanation& e : ranked_list)
      if (e.fit.converged && e.gain > needed && e.gain >= ranked_list.front().gain - within_reach)
        set.push_back(&e);
    return set;
  }

  bool any_passes(std::vector<Explanation>& list,
                  const std::vector<const Explanation*>& set) const {
    bool passes = false;
    for (Explanation& e : list) {
      if (std::find(set.begin(), set.end(), &e) == set.end()) continue;
      attribution_.recheck(e);
      passes = passes || e.recheck.p_value() >= passed;
    }
    return passes;
  }

  void attribute() {
    std::vector<const Explanation*> set = best_set(singles_, result_.needed_gain);
    // The base law's own exponents come before physics.
    std::stable_partition(set.begin(), set.end(),
                          [this](const Explanation* e) { return is_base_exponent(*e); });
    if (any_passes(singles_, set)) {
      one_effect(set);
      return;
    }
    if (both_base_exponents()) return;
    if (options_.pairs && singles_.size() >= 2) {
      step(0.5, "refitting with pairs of effects");
      pairs_ = attribution_.pairs(singles_, [this] { return cancelled(); });
      step(0.8, "checking what is left");
      // Dropping either member must cost more than chance would pay for it.
      const double needed =
          std::log(static_cast<double>(problem_.measured.size())) +
          2.0 * std::log(std::max(1, result_.candidates_tried - 1)) +
          (singles_.front().fit.converged ? std::max(0.0, singles_.front().gain) : 0.0);
      const std::vector<const Explanation*> two = best_set(pairs_, needed);
      if (any_passes(pairs_, two)) {
        std::vector<const Explanation*> strong;
        for (const Explanation* e : two)
          if (e->least_loss >= loss_of_a_member) strong.push_back(e);
        if (!strong.empty() && strong.front() == two.front()) {
          two_effects(strong);
          return;
        }
        for (const Explanation* e : two) weak_pairs_.push_back(ids_of(*e));
      }
    }
    bent_law();
  }

  /// The base law with both its exponents wrong comes before two effects of physics, and each
  /// needs no more than what admits a single effect.
  bool both_base_exponents() {
    std::vector<std::size_t> members;
    double alone = 0.0;
    for (const Explanation& single : singles_)
      if (is_base_exponent(single) && single.fit.converged) {
        members.push_back(single.members.front());
        alone = std::max(alone, single.gain);
      }
    if (members.size() != 2) return false;
    std::sort(members.begin(), members.end());
    Explanation pair = attribution_.refit(members);
    if (!pair.fit.converged || pair.gain < alone + result_.needed_gain) return false;
    attribution_.recheck(pair);
    if (pair.recheck.p_value() < passed) return false;
    pair.least_loss = pair.gain - alone;
    pairs_ = {std::move(pair)};
    two_effects({&pairs_.front()});
    return true;
  }

  void one_effect(std::vector<const Explanation*> set) {
    // A size that nobody would believe is no rival of one that can be.
    const bool plausible = std::any_of(set.begin(), set.end(), [this](const Explanation* e) {
      return sizes_plausible(problem_, *e);
    });
    if (plausible)
      std::erase_if(set, [this](const Explanation* e) { return !sizes_plausible(problem_, *e); });
    const Explanation& best = *set.front();
    hold_out(best);
    fill(set, best);
    const bool holds = confirmed(result_.hold_out);
    if (!plausible || !holds) {
      result_.verdict = Verdict::effect_like;
      result_.shape = unknown_shape();
      result_.sentence = fmt::format(
          "Something is missing ({}); it acts like {}, {}: {}.", p_text(result_.p_value),
          joined_sets(set),
          !plausible ? "but of an implausible size" : "but the hold-out does not confirm it",
          size_text(problem_, best));
      return;
    }
    if (set.size() == 1) {
      result_.verdict = Verdict::effect;
      double next = 0.0;
      std::string next_id;
      for (const Explanation& e : singles_)
        if (&e != &best && e.fit.converged) {
          next = e.gain;
          next_id = id_of(e);
          break;
        }
      result_.sentence = fmt::format(
          "Consistent with {}, {}; gain {:.0f} (needed {:.1f}), what remains is {} (p = {:.2g})"
          "{}. Error {}{}.",
          id_of(best), size_text(problem_, best), best.gain, result_.needed_gain, "at noise level",
          result_.remaining_p_value,
          next_id.empty() ? ""
                          : fmt::format(", next best {} {:.0f} behind", next_id, best.gain - next),
          error_text(result_), shifts());
      return;
    }
    result_.verdict = Verdict::ambiguous;
    suggest(set);
    result_.sentence = fmt::format(
        "{} cannot be told apart on these data (difference {:.1f}, needed {:.0f}); one of them is "
        "missing ({}).{}",
        joined_sets(set), std::abs(set.front()->gain - set[1]->gain), within_reach,
        p_text(result_.p_value), measure_text(result_));
  }

  void two_effects(const std::vector<const Explanation*>& set) {
    const Explanation& best = *set.front();
    hold_out(best);
    fill(set, best);
    if (!confirmed(result_.hold_out)) {
      result_.verdict = Verdict::not_in_catalogue;
      result_.shape = unknown_shape();
      result_.sentence = fmt::format(
          "Something is missing ({}); {} would do in sample, but the hold-out does not confirm it.",
          p_text(result_.p_value), id_of(best));
      return;
    }
    result_.verdict = Verdict::several_effects;
    if (set.size() > 1) suggest(set);
    result_.sentence = fmt::format(
        "Consistent with {} at once, {}; gain {:.0f}, the lesser alone {:.0f}; what remains is at "
        "noise level (p = {:.2g}).{} Error {}{}.{}",
        id_of(best), size_text(problem_, best), best.gain, best.least_loss,
        result_.remaining_p_value,
        set.size() > 1 ? fmt::format(" {} other pair(s) do as well.", set.size() - 1) : "",
        error_text(result_), shifts(), measure_text(result_));
  }

  /// True if a law bent to its limit is beaten by a plain power of the inputs, which has as many
  /// free numbers: what is missing then acts like something else.
  [[nodiscard]] bool bent_too_far(const Explanation& bent) const {
    return bent.bent_to_a_bound() && result_.shape && result_.shape->gain > bent.gain + beaten;
  }

  void bent_law() {
    step(0.85, "bending the laws of the best");
    result_.shape = unknown_shape();
    std::vector<Explanation> bent;
    for (std::size_t k = 0; k < singles_.size() && k < 3; ++k) {
      if (!singles_[k].fit.converged || singles_[k].gain < result_.needed_gain) continue;
      Explanation e = attribution_.elastic(singles_[k]);
      if (!e.fit.converged || bent_too_far(e)) continue;
      attribution_.recheck(e);
      if (e.recheck.p_value() >= passed) bent.push_back(std::move(e));
    }
    std::stable_sort(bent.begin(), bent.end(),
                     [](const Explanation& a, const Explanation& b) { return a.gain > b.gain; });
    std::vector<const Explanation*> set;
    for (const Explanation& e : bent)
      if (e.gain >= bent.front().gain - within_reach) set.push_back(&e);
    const double pure = singles_.empty() || !singles_.front().rechecked
                            ? result_.p_value
                            : singles_.front().recheck.p_value();
    if (set.empty()) {
      result_.verdict = Verdict::not_in_catalogue;
      fill({}, singles_.empty() ? Explanation{} : singles_.front());
      std::string pairs;
      if (!weak_pairs_.empty())
        pairs =
            " Pairs that would do, without being shown: " + joined(weak_pairs_.front(), "and") +
            (weak_pairs_.size() > 1 ? fmt::format(" and {} more.", weak_pairs_.size() - 1) : ".");
      result_.sentence =
          fmt::format("Something is missing ({}) that nothing in the catalogue explains.{}{}{}",
                      p_text(result_.p_value), nearest_text(), shape_text(), pairs);
      return;
    }
    result_.verdict = Verdict::effect_like;
    fill(set, *set.front());
    result_.sentence = fmt::format(
        "Something is missing; it acts like {} but not with the catalogue's law (pure law "
        "rejected, {}; exponents speed {:+.2f}, {} {:+.2f}, viscosity {:+.2f}): either "
        "that effect with another law, or an effect outside the catalogue that acts alike.",
        joined_sets(set), p_text(pure), set.front()->speed_exponent,
        problem_.data.quantity == Quantity::friction_torque ? "load" : "preload",
        set.front()->load_exponent, set.front()->viscosity_exponent);
  }

  /// Which single effects of believable size come nearest, and how far what they leave is from
  /// noise.
  [[nodiscard]] std::string nearest_text() const {
    const auto taken = [&](const Explanation& e) {
      const double beyond = std::max(1.0, evidence_.base.misfit - degrees());
      return std::clamp((evidence_.base.misfit - e.fit.misfit) / beyond, 0.0, 1.0);
    };
    std::vector<const Explanation*> near;
    for (const Explanation& e : singles_)
      if (e.fit.converged && e.gain > result_.needed_gain && sizes_plausible(problem_, e) &&
          near.size() < most_near && (near.empty() || taken(e) > taken(*near.front()) - 0.1))
        near.push_back(&e);
    if (near.empty()) return "";
    const double left = rms(problem_.measured - near.front()->fit.prediction);
    const QuantityText quantity = text_of(problem_.data.quantity);
    std::string text =
        fmt::format(" Nearest: {}; {} {:.0f} % of the misfit away and leaves {:.3g} {}",
                    joined_sets(near), near.size() > 1 ? "the first takes" : "it takes",
                    100.0 * taken(*near.front()), left / quantity.factor, quantity.unit);
    const double ratio = left / evidence_.noise.rms;
    if (ratio > 2.0)
      text += fmt::format(
          ", {:.0f} times the noise: more than one thing is missing, or another law", ratio);
    return text + ".";
  }

  [[nodiscard]] std::string shape_text() const {
    if (!result_.shape) return "";
    return fmt::format(" As a power law: {} ({:.0f} % of the misfit).", result_.shape->statement,
                       100.0 * result_.shape->explained_share);
  }

  [[nodiscard]] double degrees() const {
    return static_cast<double>(problem_.measured.size() - evidence_.base.tangent.cols());
  }

  [[nodiscard]] std::optional<Shape> unknown_shape() const {
    return find_unknown_shape(problem_, evidence_.noise, evidence_.base);
  }

  void hold_out(const Explanation& best) {
    const Eigen::VectorXd& std = evidence_.noise.whitening.std();
    for (const Blocking& b : blockings_)
      result_.hold_out.push_back(compare_held_out(
          held_out_errors(evidence_.response, evidence_.base, problem_.measured, std, b),
          held_out_errors(best.response, best.fit, problem_.measured, std, b), std, b));
  }

  /// Effects of the verdict first, the best set leading, then the others by rank.
  void fill(const std::vector<const Explanation*>& set, const Explanation& best) {
    if (!set.empty()) {
      result_.rmse_after = rms(problem_.measured - best.fit.prediction);
      result_.remaining_p_value = best.rechecked ? best.recheck.p_value() : unset;
      result_.base_shifts = base_shifts(evidence_, best);
      for (std::size_t k = 0; k < best.parameters.size(); ++k)
        if (best.fit.at_bound[k] && k < problem_.base.size())
          result_.messages.push_back(best.parameters[k].name + " ends at a bound");
    } else {
      result_.rmse_after = result_.rmse_before;
    }
    std::set<std::size_t> listed;
    for (const Explanation* e : set) {
      result_.sets.push_back(ids_of(*e));
      for (const std::size_t k : e->members) {
        if (!listed.insert(k).second) continue;
        RankedEffect effect = rank(*e, k);
        effect.in_verdict = true;
        effect.parameters[problem_.candidates[k].size_index].interval =
            size_interval(evidence_, *e, k);
        // Whatever stands in its place in another set of the verdict.
        for (const Explanation* other : set) {
          if (std::find(other->members.begin(), other->members.end(), k) != other->members.end())
            continue;
          for (const std::size_t j : other->members)
            if (std::find(e->members.begin(), e->members.end(), j) == e->members.end())
              add(effect.indistinguishable_from, id(j));
        }
        result_.effects.push_back(std::move(effect));
      }
    }
    std::size_t count = 0;
    for (const Explanation& single : singles_) {
      if (!single.fit.converged) continue;
      if (!listed.insert(single.members.front()).second) continue;
      RankedEffect effect = rank(single, single.members.front(), ++count <= ranked);
      result_.effects.push_back(std::move(effect));
    }
  }

  static void add(std::vector<std::string>& list, const std::string& word) {
    if (std::find(list.begin(), list.end(), word) == list.end()) list.push_back(word);
  }

  [[nodiscard]] RankedEffect rank(const Explanation& e, std::size_t member,
                                  bool validate = true) const {
    RankedEffect effect{.id = id(member)};
    effect.gain = e.gain;
    effect.rmse = rms(problem_.measured - e.fit.prediction);
    if (validate) effect.rmse_cross_validated = cross_validated(evidence_, e, blockings_);
    effect.parameters = sizes_of(problem_, e, member);
    effect.base_shifts = base_shifts(evidence_, e);
    if (e.rechecked) effect.remaining_p_value = e.recheck.p_value();
    for (const auto& group : result_.aliases)
      if (std::find(group.begin(), group.end(), effect.id) != group.end())
        for (const std::string& other : group)
          if (other != effect.id) add(effect.indistinguishable_from, other);
    return effect;
  }

  void suggest(const std::vector<const Explanation*>& set) {
    step(0.9, "choosing the next measurements");
    const std::vector<const Explanation*> few(
        set.begin(),
        set.begin() + static_cast<std::ptrdiff_t>(std::min<std::size_t>(4, set.size())));
    NextPoints next = next_points(problem_, evidence_.noise, few);
    result_.suggested_measurements = std::move(next.points);
    result_.predicted_separation = next.predicted_separation;
    result_.separation_by_repetition = next.separation_by_repetition;
    result_.records_needed = records_needed(problem_, set);
  }

  [[nodiscard]] std::string joined_sets(const std::vector<const Explanation*>& set) const {
    std::vector<std::string> names;
    for (const Explanation* e : set) names.push_back(id_of(*e));
    return joined(names, "or");
  }

  [[nodiscard]] std::string shifts() const {
    return base_is_identifiable() ? shift_text(result_) : "";
  }

  const DiagnoseOptions& options_;
  Model model_;
  effects::Subject subject_;
  std::vector<effects::Effect> user_made_;
  Evidence evidence_;
  const Problem& problem_;
  Attribution attribution_;
  std::vector<Blocking> blockings_;
  std::vector<Explanation> singles_, pairs_;
  std::vector<std::vector<std::string>> weak_pairs_;
  Diagnosis result_;
};

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

Diagnosis diagnose(const Model& model, const DataSet& data, const DiagnoseOptions& options) {
  if (options.progress) options.progress(0.0, "estimating the noise");
  Diagnosis diagnosis = Investigation(model, data, options).run();
  const std::size_t used =
      static_cast<std::size_t>(diagnosis.rows) + diagnosis.rows_not_predicted.size();
  if (used < data.rows.size())
    if (const auto errors = errors_on_all_rows(model, data, diagnosis)) {
      const QuantityText quantity = text_of(data.quantity);
      diagnosis.messages.push_back(fmt::format(
          "over all {} rows that can be predicted the error falls from {:.3g} to {:.3g} {} with "
          "the numbers found on those that were used",
          errors->rows, errors->before / quantity.factor, errors->after / quantity.factor,
          quantity.unit));
    }
  return diagnosis;
}

}  // namespace raceway::fit
