#include "verdict/detail/investigation.h"

#include <fmt/format.h>

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <functional>
#include <set>

#include "algebra/detail/decompositions.h"
#include "verdict/effect_sizes.h"
#include "verdict/headline.h"
#include "verdict/next_points.h"
#include "verdict/unknown_shape.h"
#include "verdict/verdict_text.h"
#include "verdict/visibility.h"

namespace raceway::verdict {

namespace {

constexpr std::size_t ranked = 6;            // effects with a hold-out of their own
constexpr std::size_t most_rivals = 4;       // between which points are chosen
constexpr double fall_of_an_effect = 0.01;   // of the error, below which an effect is not shown
constexpr double chance_of_offsets = 0.001;  // of blocks that follow a change over time by luck
constexpr double worth_an_offer = 0.5;   // of the misfit, which another base model must take away
constexpr double worth_measuring = 0.5;  // predicted lambda_sep: less is none

void add_once(std::vector<std::string>& list, const std::string& word) {
  if (std::find(list.begin(), list.end(), word) == list.end()) list.push_back(word);
}

template <typename T>
bool contains(const std::vector<T>& list, const T& value) {
  return std::find(list.begin(), list.end(), value) != list.end();
}

}  // namespace

Investigation::Investigation(const fit::Subject& subject, const record::Record& record,
                             const DiagnoseOptions& options)
    : record_(record),
      options_(options),
      evidence_(gather_evidence(subject, record,
                                {.candidates = options.candidates,
                                 .most_rows = options.most_rows,
                                 .noise = options.noise,
                                 .cancelled = [this] { return cancelled(); }})),
      problem_(evidence_.problem),
      attribution_(evidence_),
      blockings_(fit::blocks_of_observations(subject, *problem_.record, problem_.observed)) {}

const std::string& Investigation::id(std::size_t candidate) const {
  return problem_.candidates[candidate].id();
}

std::string Investigation::id_of(const Explanation& e) const {
  return joined(search_->ids_of(e), "and");
}

bool Investigation::cancelled() const { return options_.cancelled && options_.cancelled->load(); }

void Investigation::step(double share, std::string_view what) const {
  if (cancelled()) throw fit::Cancelled();
  if (options_.progress) options_.progress(share, what);
}

double Investigation::degrees() const {
  return static_cast<double>(problem_.observed.size() - evidence_.base.tangent.cols());
}

void Investigation::look() {
  describe_channels();
  describe_base();
  Visibility seen = what_can_be_seen(evidence_, attribution_);
  result_.candidates_tried = static_cast<int>(seen.tried) + options_.tried_before;
  result_.would_have_been_found = std::move(seen.would_have_been_found);
  result_.not_testable = std::move(seen.not_testable);
  result_.aliases = std::move(seen.aliases);
  result_.needed_gain = std::log(static_cast<double>(problem_.observed.size())) +
                        2.0 * std::log(std::max(1, result_.candidates_tried));
  result_.p_value = attribution_.gate().p_value();
  result_.remaining_p_value = result_.p_value;
  search_.emplace(evidence_, attribution_, blockings_,
                  SearchLimits{.needed_gain = result_.needed_gain,
                               .tried = result_.candidates_tried,
                               .pairs = options_.pairs,
                               .step = [this](double s, std::string_view what) { step(s, what); },
                               .cancelled = [this] { return cancelled(); }});
  for (const fit::Measured& m : problem_.observed.channels)
    if (!hidden_) hidden_ = find_hidden_input(*problem_.record, m);
  if (hidden_)
    for (std::size_t* row : {&hidden_->low, &hidden_->high}) *row = problem_.rows[*row];
  if (!result_.tolerance_limited()) return;
  share_of_tolerance_ = search_->share_of_tolerance(evidence_.response, evidence_.base);
  result_.within_tolerance = share_of_tolerance_ <= 1.0;
  const std::vector<double> errors =
      held_out_within_range(evidence_, evidence_.response, evidence_.base, blockings_);
  for (std::size_t c = 0; c < errors.size(); ++c)
    result_.channels[c].rmse_held_out_before = errors[c];
  if (std::isnan(share_of_tolerance_))
    result_.messages.push_back(
        record::note::limits("no block of these rows can be held out, so the program cannot test "
                             "whether the held-out error is within the tolerance"));
}

void Investigation::describe_channels() {
  const fit::Observations& observed = problem_.observed;
  for (std::size_t c = 0; c < observed.channels.size(); ++c) {
    std::vector<double> predicted(record_.rows(), unset);
    const std::span<const std::size_t> rows = observed.rows(c);
    for (std::size_t i = 0; i < rows.size(); ++i)
      predicted[i] = evidence_.base.prediction[observed.first[c] + static_cast<Eigen::Index>(i)];
    // Over the rows used, in their order.
    std::vector<double> by_row(problem_.record->rows(), unset);
    for (std::size_t i = 0; i < rows.size(); ++i) by_row[rows[i]] = predicted[i];
    ChannelDiagnosis& d = result_.channels.emplace_back();
    d.baseline = compare(by_row, *problem_.record, observed.channels[c],
                         static_cast<int>(evidence_.base.tangent.cols()));
    d.noise = evidence_.noise[c];
    d.tolerance = observed.channels[c].tolerance;
    d.rmse_before = d.rmse_after =
        fit::rms(observed.of(c, Eigen::VectorXd(observed.measured - evidence_.base.prediction)));
    const Eigen::VectorXd& std = d.noise.whitening.std();
    for (auto* errors : {&d.baseline.errors, &d.baseline.worst})
      for (RowError& e : *errors) {
        e.row = problem_.rows[e.row];
        e.line = record_.line(e.row);
      }
    for (std::size_t& row : d.baseline.rows_not_predicted) row = problem_.rows[row];
    for (std::size_t i = 0; i < d.baseline.errors.size(); ++i)
      d.baseline.errors[i].std = std[static_cast<Eigen::Index>(i)];
    for (const std::size_t i : d.noise.outliers) result_.outliers.push_back(problem_.rows[rows[i]]);
  }
}

/// Declared standard deviations are not the scatter that is found.
void Investigation::tell_declared_noise() {
  for (const ChannelDiagnosis& d : result_.channels) {
    if (d.baseline.noise.source != fit::NoiseSource::declared || evidence_.few_rows) continue;
    const double declared = d.baseline.noise.rms, ratio = d.noise.rms / declared;
    if (ratio < 1.5 && ratio > 1.0 / 1.5) continue;
    result_.messages.push_back(record::note::noise(
        fmt::format("std_{} sets only the relative weights of the rows; a regression on the "
                    "inputs gives a noise of {} instead of the declared {:.3g}",
                    d.channel().key_unit(), reading_text(d.channel(), d.noise.rms),
                    declared / d.channel().factor)));
  }
}

/// Runs that coincide with levels of the plan: what differs between them is told by nothing.
void Investigation::tell_of_runs() {
  bool runs = false, blocks = false;
  for (const ChannelDiagnosis& d : result_.channels)
    if (d.noise.unknown_runs) (d.noise.undeclared_blocks ? blocks : runs) = true;
  if (blocks)
    result_.messages.push_back(
        record::note::plan("the data do not show how much blocks of rows differ by chance, so "
                           "effects that change from block to block were not tested; measure each "
                           "block twice, or mark the runs with run_id"));
  const std::string nested = fit::nested_settings(*problem_.record);
  // Where levels were measured in two runs it is no plan that lacks anything.
  if (!runs || (!nested.empty() && fit::nested_settings(*problem_.record, true).empty())) return;
  result_.messages.push_back(record::note::plan(
      nested.empty()
          ? "the data do not show how much runs differ by chance. So the program does not compare "
            "different runs to test an effect. Repeat the plan in more runs"
          : fmt::format("the data do not show how much runs differ by chance, as each run has its "
                        "own {0}. So the program does not compare different runs to test an effect "
                        "of {0}. Measure each level in two runs or more, or all levels within each "
                        "run",
                        nested)));
}

/// Records that do not scatter alike.
void Investigation::tell_of_records() {
  for (const ChannelDiagnosis& d : result_.channels) {
    std::vector<std::string> texts;
    for (std::size_t k = 0; k < d.noise.records.size(); ++k)
      texts.push_back(fmt::format("{} {:.2g} times", record_.parts.at(k).name, d.noise.records[k]));
    if (!texts.empty())
      result_.messages.push_back(
          record::note::noise(fmt::format("the noise differs between the records; factors on the "
                                          "common noise: {}. The rows are weighted accordingly",
                                          joined(texts, "and"))));
  }
}

/// Scatter that grows with the input that is swept.
void Investigation::tell_of_growth() {
  for (const ChannelDiagnosis& d : result_.channels) {
    if (d.noise.growth <= 0.0) continue;
    const record::Channel& swept = *d.noise.swept;
    const std::span<const double> values = problem_.record->values(swept);
    const double least = *std::min_element(values.begin(), values.end());
    const double most = d.noise.largest_swept;
    result_.messages.push_back(record::note::noise(fmt::format(
        "the scatter of {} grows with {}, from {:.2g} % of the reading at {:.4g} {} to {:.2g} % at "
        "{:.4g} {}. The rows are weighted accordingly",
        d.channel().words, swept.words,
        100.0 * d.noise.relative * std::pow(least / most, d.noise.growth), swept.in_unit(least),
        swept.unit, 100.0 * d.noise.relative, swept.in_unit(most), swept.unit)));
  }
}

bool Investigation::base_is_identifiable() const {
  Eigen::MatrixXd columns = evidence_.base.tangent;
  if (columns.cols() == 0) return true;
  columns.colwise().normalize();
  return algebra::PivotedQr(columns, 1e-4).rank() == columns.cols();
}

void Investigation::describe_base() {
  const auto tell = [this](record::Note said) { result_.messages.push_back(std::move(said)); };
  result_.rows = static_cast<int>(evidence_.rows());
  result_.likelihood = likelihood_of(evidence_, evidence_.base);
  result_.base = base_alone(evidence_);
  result_.correlation = correlation_of(result_.base, evidence_.base);
  result_.rows_not_predicted = problem_.not_predicted;
  std::vector<std::size_t>& outliers = result_.outliers;
  std::sort(outliers.begin(), outliers.end(),
            [&](std::size_t a, std::size_t b) { return record_.line(a) < record_.line(b); });
  if (!outliers.empty())
    tell(record::note::rows_used(
        fmt::format("number of rows that are outliers and have less weight: {}; the first is {}",
                    outliers.size(), record_.place(outliers.front()))));
  const std::size_t left_out = result_.rows_not_predicted.size();
  if (evidence_.rows() + left_out < evidence_.rows_in_record)
    tell(record::note::rows_used(fmt::format("{} of {} rows were used, chosen at random",
                                             result_.rows, evidence_.rows_in_record)));
  if (left_out > 0)
    tell(record::note::rows_used(
        fmt::format("number of rows that are not used, because they have no reading or no "
                    "prediction: {}; the first is {}",
                    left_out, record_.place(result_.rows_not_predicted.front()))));
  for (std::size_t k = 0; k < evidence_.base.at_bound.size(); ++k)
    if (evidence_.base.at_bound[k])
      tell(record::note::at_bound(
          evidence_.response.parameters[k].name +
              " is at a bound: an effect is missing, or the model does not describe these data",
          {.key = evidence_.response.parameters[k].name}));
  if (!evidence_.hint.empty()) tell(record::note::unit(evidence_.hint));
  for (const record::Note& one : evidence_.notes) tell(one);
  tell_declared_noise();
  for (const std::string& name : evidence_.idle) {
    const std::string needed = problem_.subject->lacks(name, *problem_.record);
    tell(record::note::not_identifiable(
        "the readings do not depend on " + name + ", so the fit does not change this parameter" +
            (needed.empty() ? "" : "; " + name + " needs " + needed),
        {.key = name}));
  }
  for (const std::string& name : problem_.base)
    if (const std::string needed = problem_.subject->lacks(name, *problem_.record); !needed.empty())
      tell(record::note::not_identifiable(
          "the value of " + name + " is uncertain: " + name + " needs " + needed, {.key = name}));
  if (!base_is_identifiable())
    tell(record::note::not_identifiable(joined(problem_.base, "and") +
                                        " cannot all be separated by these data, so their values "
                                        "are uncertain; fit fewer of them ([calibration] free)"));
  for (const ChannelDiagnosis& d : result_.channels)
    if (d.noise.undeclared_blocks && !d.noise.unknown_runs)
      tell(record::note::plan(
          fmt::format("{}: blocks of rows in which a setting rises or falls have different offsets "
                      "({} rms), as after a new clamping. The program treats each block as a run; "
                      "to define the runs yourself, add a column run_id",
                      d.channel().words, reading_text(d.channel(), d.noise.run_offset()))));
    else if (d.noise.undeclared_blocks)
      tell(record::note::plan(fmt::format(
          "{}: the rows form blocks in which a setting rises or falls. The program treats each "
          "block as a run; to define the runs yourself, add a column run_id",
          d.channel().words)));
  tell_of_runs();
  tell_of_records();
  tell_of_growth();
  for (const ChannelDiagnosis& d : result_.channels)
    if (d.noise.repeats_p_value < passed)
      tell(record::note::noise(fmt::format(
          "repeated rows scatter {:.2g} times as much as the estimated noise (p = {:.1g})",
          std::sqrt(d.noise.repeats_statistic), d.noise.repeats_p_value)));
}

bool Investigation::is_anything_missing() const {
  if (outside_the_inputs()) return true;
  if (result_.tolerance_limited() && result_.within_tolerance) return false;
  return attribution_.gate().alarm();
}

void Investigation::attribute() {
  step(0.2, "refitting with each effect");
  search_->refit_singles();
  for (const Explanation& single : search_->singles())
    if (!single.fit.converged)
      result_.messages.push_back(record::note::not_converged(fmt::format(
          "the fit with {} {}: the verdict does not use this fit", id_of(single),
          single.ran_away ? "diverges to " + size_text(problem_, single) : "did not converge")));
  if (outside_the_inputs()) return;
  const bool by_tolerance = result_.tolerance_limited() && !std::isnan(share_of_tolerance_);
  finding_ = by_tolerance ? search_->explain_within_tolerance() : search_->explain();
  result_.shape = search_->shape();
}

void Investigation::hold_out(const Explanation& best) {
  const fit::Observations& observed = problem_.observed;
  for (const fit::Blocking& b : blockings_)
    result_.hold_out.push_back(fit::compare_held_out(
        fit::held_out_errors(evidence_.response, evidence_.base, observed.measured, evidence_.std(),
                             b),
        fit::held_out_errors(best.response, best.fit, observed.measured, evidence_.std(), b),
        evidence_.std(), observed, b));
  const auto error = result_.tolerance_limited() ? held_out_within_range : held_out;
  const std::vector<double> before =
      error(evidence_, evidence_.response, evidence_.base, blockings_);
  const std::vector<double> after = error(evidence_, best.response, best.fit, blockings_);
  for (std::size_t c = 0; c < before.size(); ++c) {
    result_.channels[c].rmse_held_out_before = before[c];
    result_.channels[c].rmse_held_out_after = after[c];
  }
  holds_ = result_.tolerance_limited() || fit::confirmed(result_.hold_out);
}

void Investigation::confirm() {
  switch (finding_.kind) {
    case Finding::Kind::single:
      return confirm_single();
    case Finding::Kind::several:
      return confirm_several();
    case Finding::Kind::base_laws:
    case Finding::Kind::bent:
      result_.verdict = Verdict::effect_like;
      return fill(finding_.set, *finding_.set.front());
    case Finding::Kind::partly:
      result_.verdict = Verdict::effect_like;
      hold_out(*finding_.set.front());
      return fill(finding_.set, *finding_.set.front());
    case Finding::Kind::none:
      result_.verdict = Verdict::not_in_catalogue;
      fill({}, search_->singles().empty() ? Explanation{} : search_->singles().front());
  }
}

/// Why an explanation that leaves nothing but noise is believed less; empty if it is not.
std::string Investigation::doubt_about(const Explanation& best) const {
  std::vector<std::string> at_bound;
  for (std::size_t k = 0; k < problem_.base.size(); ++k)
    if (best.fit.at_bound[k])
      at_bound.push_back(fmt::format(
          "{} at {}", best.parameters[k].name,
          with_unit(best.fit.values[static_cast<Eigen::Index>(k)], best.parameters[k].unit)));
  if (!at_bound.empty())
    return fmt::format("but only with {}, the limit of its range", joined(at_bound, "and"));
  if (search_->lowers_the_error(best, fall_of_an_effect)) return {};
  const ChannelDiagnosis& first = result_.channels.front();
  return fmt::format("but the error {} from {:.4g} to {}",
                     search_->raises_the_error(best) ? "rises" : "hardly falls,",
                     first.rmse_before / first.channel().factor,
                     reading_text(first.channel(), rms_of(best).front(), 4));
}

/// True if zeros that were set anew before each block of rows may look like the change over time.
bool Investigation::may_be_block_offsets(const Explanation& e) const {
  // Of many partners the one was chosen that leaves the best line.
  const double partners = e.members.size() > 1 ? result_.candidates_tried : 1.0;
  return std::any_of(e.members.begin(), e.members.end(), [&](std::size_t k) {
    return problem_.candidates[k].candidate.of_time &&
           partners * chance_of_block_offsets(evidence_, e, k) > chance_of_offsets;
  });
}

std::string Investigation::doubt_about_time(const Set& set) const {
  const bool doubtful = std::all_of(
      set.begin(), set.end(), [this](const Explanation* e) { return may_be_block_offsets(*e); });
  if (!doubtful) return {};
  return record_.has(record::run)
             ? "but a sensor zero that was set before each run may change the readings in the same "
               "way"
             : "but a sensor zero that was set before each block of rows may change the "
               "readings in the same way, because no column run_id marks the runs";
}

/// Nothing in the set explains the misfit by its own law but shapes that stand for none.
bool Investigation::is_a_shape_alone(const Set& set) const {
  return std::all_of(set.begin(), set.end(), [this](const Explanation* e) {
    return e->elastic || problem_.candidates[e->members.front()].candidate.empirical;
  });
}

void Investigation::confirm_single() {
  // A size that nobody would believe is no rival of one that can be, and what raises the error
  // leads only where nothing else does as well.
  Set& set = finding_.set;
  std::stable_partition(set.begin(), set.end(),
                        [this](const Explanation* e) { return !search_->raises_the_error(*e); });
  const auto is_plausible = [this](const Explanation* e) { return sizes_plausible(problem_, *e); };
  // Nor does a law that had to be bent rule out such a size.
  plausible_ = std::any_of(set.begin(), set.end(),
                           [&](const Explanation* e) { return !e->elastic && is_plausible(e); });
  if (plausible_) std::erase_if(set, [&](const Explanation* e) { return !is_plausible(e); });
  if (set.front()->elastic) {
    finding_.kind = Finding::Kind::bent;
    return confirm();
  }
  hold_out(*set.front());
  fill(set, *set.front());
  doubt_ = doubt_about(*set.front());
  if (doubt_.empty()) doubt_ = doubt_about_time(set);
  if (doubt_.empty() && is_a_shape_alone(set)) doubt_ = "an empirical shape without a physical law";
  if (!plausible_ || !holds_ || !doubt_.empty()) {
    result_.verdict = Verdict::effect_like;
    if (!evidence_.few_rows) result_.shape = find_unknown_shape(evidence_);
  } else {
    result_.verdict = set.size() == 1 ? Verdict::effect : Verdict::ambiguous;
  }
}

void Investigation::confirm_several() {
  Set& set = finding_.set;
  const auto is_plausible = [this](const Explanation* e) { return sizes_plausible(problem_, *e); };
  plausible_ = std::any_of(set.begin(), set.end(), is_plausible);
  if (plausible_) std::erase_if(set, std::not_fn(is_plausible));
  hold_out(*set.front());
  fill(set, *set.front());
  doubt_ = plausible_ ? doubt_about(*set.front()) : "but one of their sizes is implausible";
  if (doubt_.empty()) doubt_ = doubt_about_time(finding_.set);
  result_.verdict = !holds_          ? Verdict::not_in_catalogue
                    : doubt_.empty() ? Verdict::several_effects
                                     : Verdict::effect_like;
  if (!holds_) result_.shape = find_unknown_shape(evidence_);
}

std::vector<double> Investigation::rms_of(const Explanation& e) const {
  const Eigen::VectorXd left = problem_.measured() - e.fit.prediction;
  std::vector<double> result;
  for (std::size_t c = 0; c < problem_.observed.channels.size(); ++c)
    result.push_back(fit::rms(problem_.observed.of(c, left)));
  return result;
}

/// Effects of the verdict first, the best set leading, then the others by rank.
void Investigation::fill(const Set& set, const Explanation& best) {
  if (!set.empty()) {
    const std::vector<double> errors = rms_of(best);
    for (std::size_t c = 0; c < errors.size(); ++c) result_.channels[c].rmse_after = errors[c];
    result_.remaining_p_value = best.rechecked ? best.recheck.p_value() : unset;
    result_.base = base_with(evidence_, best);
    result_.correlation = correlation_of(best.parameters, best.fit);
    for (std::size_t k = 0; k < problem_.base.size(); ++k)
      if (best.fit.at_bound[k])
        result_.messages.push_back(
            record::note::at_bound(best.parameters[k].name + " ends at a bound of its range",
                                   {.key = best.parameters[k].name}));
  }
  fill_verdict(set);
  fill_ranking();
  fill_explained(set);
}

void Investigation::fill_verdict(const Set& set) {
  for (const Explanation* e : set) {
    result_.sets.push_back(search_->ids_of(*e));
    result_.fits.push_back({e->gain, likelihood_of(evidence_, e->fit), rms_of(*e)});
    for (const std::size_t k : e->members) {
      if (std::any_of(result_.effects.begin(), result_.effects.end(),
                      [&](const RankedEffect& r) { return r.id == id(k); }))
        continue;
      RankedEffect effect = rank(*e, k, true);
      effect.in_verdict = true;
      effect.parameters[problem_.candidates[k].candidate.size].interval =
          size_interval(evidence_, *e, k);
      // Whatever stands in its place in another set of the verdict.
      for (const Explanation* other : set) {
        if (contains(other->members, k)) continue;
        for (const std::size_t j : other->members)
          if (!contains(e->members, j)) add_once(effect.indistinguishable_from, id(j));
      }
      result_.effects.push_back(std::move(effect));
    }
  }
}

void Investigation::fill_ranking() {
  std::set<std::string> listed;
  for (const RankedEffect& effect : result_.effects) listed.insert(effect.id);
  std::size_t count = 0;
  for (const Explanation& single : search_->singles()) {
    const std::size_t k = single.members.front();
    if (single.fit.converged && listed.insert(id(k)).second)
      result_.effects.push_back(rank(single, k, ++count <= ranked));
  }
}

/// What the readings are made of: by the best set, then by every single effect not in it.
void Investigation::fill_explained(const Set& set) {
  const Explanation* const best = set.empty() || set.front()->elastic ? nullptr : set.front();
  if (best) {
    result_.explained.push_back(explained_readings(evidence_, *best));
    result_.verdict_is_explained = true;
  }
  for (const RankedEffect& effect : result_.effects)
    for (const Explanation& single : search_->singles()) {
      const std::size_t k = single.members.front();
      if (!single.fit.converged || id(k) != effect.id || (best && contains(best->members, k)))
        continue;
      result_.explained.push_back(explained_readings(evidence_, single));
    }
}

RankedEffect Investigation::rank(const Explanation& e, std::size_t member, bool validate) const {
  RankedEffect effect{.id = id(member)};
  effect.datum = problem_.candidates[member].candidate.datum;
  if (!effect.datum.empty()) effect.correction = correction_text(problem_, e, member);
  effect.gain = e.gain;
  effect.likelihood = likelihood_of(evidence_, e.fit);
  effect.size = problem_.candidates[member].candidate.size;
  effect.rmse = rms_of(e);
  const auto error = result_.tolerance_limited() ? held_out_within_range : held_out;
  if (validate) effect.rmse_held_out = error(evidence_, e.response, e.fit, blockings_);
  effect.parameters = sizes_of(problem_, e, member);
  effect.base = base_with(evidence_, e);
  if (e.rechecked) effect.remaining_p_value = e.recheck.p_value();
  for (const auto& group : result_.aliases)
    if (contains(group, effect.id))
      for (const std::string& other : group)
        if (other != effect.id) add_once(effect.indistinguishable_from, other);
  return effect;
}

OtherBaseTried Investigation::tried(CalibratedBase& found) const {
  Explanation& e = found.explanation;
  OtherBaseTried result{
      .id = found.base.id, .words = found.base.words, .fitted_form = found.base.fitted_form};
  if (!e.fit.converged) return result;
  attribution_.recheck(e);
  result.gain = e.gain;
  result.likelihood = likelihood_of(evidence_, e.fit);
  result.rmse = rms_of(e);
  const auto error = result_.tolerance_limited() ? held_out_within_range : held_out;
  result.rmse_held_out = error(evidence_, e.response, e.fit, blockings_);
  for (std::size_t k = 0; k < e.parameters.size(); ++k)
    result.parameters.push_back(e.fit.fitted(e.response, k));
  result.remaining_p_value = e.recheck.p_value();
  return result;
}

/// As much as is asked of a candidate: certain, no less than what the verdict names, better on
/// blocks that no fit saw, and what it leaves is noise or within what is allowed.
bool Investigation::does_as_well(const CalibratedBase& found, const OtherBaseTried& tried) const {
  const Explanation& e = found.explanation;
  if (!(tried.gain > result_.needed_gain)) return false;
  if (!finding_.set.empty() && tried.gain < finding_.set.front()->gain - within_reach) return false;
  if (result_.tolerance_limited()) return search_->share_of_tolerance(e.response, e.fit) <= 1.0;
  if (tried.remaining_p_value < passed) return false;
  std::vector<fit::HoldOut> held;
  for (const fit::Blocking& b : blockings_)
    held.push_back(fit::compare_held_out(
        fit::held_out_errors(evidence_.response, evidence_.base, problem_.observed.measured,
                             evidence_.std(), b),
        fit::held_out_errors(e.response, e.fit, problem_.observed.measured, evidence_.std(), b),
        evidence_.std(), problem_.observed, b));
  return fit::confirmed(held);
}

/// The verdict with another base model, single candidates alone; null where there is none.
std::shared_ptr<const Diagnosis> Investigation::given(const CalibratedBase& found) const {
  DiagnoseOptions options = options_;
  options.other_bases = false;
  options.pairs = false;
  options.tried_before = result_.candidates_tried;  // on these data
  options.progress = {};
  try {
    return std::make_shared<const Diagnosis>(
        diagnose_by_noise(*fitted_subject(found), record_, options));
  } catch (const std::invalid_argument&) {
    return nullptr;
  }
}

void Investigation::try_other_bases() {
  const auto explains = [](Verdict v) {
    return v == Verdict::nothing_missing || v == Verdict::effect || v == Verdict::ambiguous;
  };
  const bool explained =
      result_.verdict != Verdict::not_in_catalogue && result_.verdict != Verdict::effect_like;
  if (!options_.other_bases || outside_the_inputs() || explained) return;
  step(0.9, "trying other base laws");
  std::vector<CalibratedBase> bases = calibrate_other_bases(evidence_);
  for (const CalibratedBase& b : bases)
    if (!b.not_testable.empty()) result_.not_testable.push_back({b.base.id, b.not_testable});
  std::erase_if(bases, [](const CalibratedBase& b) { return !b.not_testable.empty(); });
  if (bases.empty()) return;
  result_.candidates_tried += static_cast<int>(bases.size());
  result_.needed_gain = std::log(static_cast<double>(problem_.observed.size())) +
                        2.0 * std::log(std::max(1, result_.candidates_tried));
  for (CalibratedBase& b : bases) result_.other_bases.push_back(tried(b));
  const auto to_front = [](auto& list, std::size_t k) {
    const auto at = list.begin() + static_cast<std::ptrdiff_t>(k);
    std::rotate(list.begin(), at, at + 1);
  };
  std::size_t first = 0;
  while (first < bases.size() && !does_as_well(bases[first], result_.other_bases[first])) ++first;
  const bool leads = first < bases.size();
  if (leads) {
    to_front(bases, first);
    to_front(result_.other_bases, first);
  }
  const std::vector<Explanation>& singles = search_->singles();
  const double rival =
      singles.empty() || !singles.front().fit.converged ? 0.0 : singles.front().gain;
  // The first with which at most an effect is missing, otherwise the first that is better.
  std::shared_ptr<const Diagnosis> offer;
  std::size_t offered = bases.size();
  for (std::size_t k = 0; k < bases.size(); ++k) {
    const Explanation& found = bases[k].explanation;
    const bool as_well = leads && k == 0;
    // One that leaves most of the misfit is no offer.
    if (!found.fit.converged || !(found.gain > result_.needed_gain) ||
        !(as_well || found.fit.misfit < worth_an_offer * evidence_.base.misfit))
      continue;
    std::shared_ptr<const Diagnosis> given_this = given(bases[k]);
    const bool explained_by_this = given_this && explains(given_this->verdict);
    if (!as_well && !explained_by_this && (offer || !(found.gain > rival))) continue;
    offer = std::move(given_this);
    offered = k;
    if (as_well || explained_by_this) break;
  }
  if (offered == bases.size()) return;
  to_front(result_.other_bases, offered);
  result_.other_bases.front().explains =
      leads && offered == 0 && offer && offer->verdict == Verdict::nothing_missing;
  result_.given_other_base = std::move(offer);
}

void Investigation::propose() {
  const bool choice = result_.verdict == Verdict::ambiguous ||
                      (result_.verdict == Verdict::several_effects && finding_.set.size() > 1);
  if (!choice) return;
  step(0.9, "choosing the next measurements");
  Set few;
  for (const Explanation* e : finding_.set)
    if (!e->elastic && few.size() < most_rivals) few.push_back(e);
  if (few.size() > 1) {
    NextPoints next = next_points(evidence_, few);
    // Points that tell the rivals no better than chance are no advice.
    if (next.predicted_separation >= worth_measuring)
      result_.suggested_measurements = std::move(next.points);
    result_.axes = std::move(next.axes);
    result_.predicted_separation = next.predicted_separation;
    result_.separation_by_repetition = next.separation_by_repetition;
  }
  std::vector<std::string> not_testable;
  for (const fit::Screened& s : problem_.candidates)
    if (!s.not_testable.empty()) not_testable.push_back(s.id());
  result_.records_needed =
      problem_.subject->records_needed(*problem_.record, result_.sets, not_testable);
}

/// Effects that are certain and better on held-out blocks, where the model is good enough without.
void Investigation::find_immaterial() {
  search_->refit_singles();
  // By gain: the first of believable size leads, and what is beyond its reach is a poorer rival.
  double least = result_.needed_gain;
  for (const Explanation& single : search_->singles()) {
    if (!single.fit.converged || !(single.gain > least) || !sizes_plausible(problem_, single))
      continue;
    least = std::max(least, single.gain - within_reach);
    if (search_->share_of_tolerance(single.response, single.fit) < share_of_tolerance_)
      result_.significant_but_immaterial.push_back(id_of(single));
  }
  fill({}, Explanation{});
}

/// Of a thinned record: the error over every row, with the numbers found on those that were used.
void Investigation::tell_of_all_rows() {
  const std::size_t used = evidence_.rows() + problem_.not_predicted.size();
  if (used >= record_.rows() || finding_.set.empty() || finding_.set.front()->elastic) return;
  const Explanation& best = *finding_.set.front();
  std::vector<const fit::Screened*> on;
  for (const std::size_t k : best.members) on.push_back(&problem_.candidates[k]);
  const auto before = fitted_subject(problem_, {}, evidence_.response, evidence_.base.values);
  const auto after = fitted_subject(problem_, on, best.response, best.fit.values);
  const std::vector<double> a = fit::predict(*before, record_), b = fit::predict(*after, record_);
  for (std::size_t c = 0; c < problem_.observed.channels.size(); ++c) {
    const record::Channel& channel = *problem_.observed.channels[c].channel;
    const std::size_t first = problem_.observed.place[c] * record_.rows();
    const std::span<const double> readings = record_.values(channel);
    double square_before = 0.0, square_after = 0.0;
    int rows = 0;
    for (std::size_t i = 0; i < readings.size(); ++i) {
      const double x = a[first + i] - readings[i], y = b[first + i] - readings[i];
      if (!std::isfinite(x) || !std::isfinite(y)) continue;
      ++rows;
      square_before += x * x;
      square_after += y * y;
    }
    result_.messages.push_back(record::note::rows_used(
        fmt::format("on all {} rows that can be predicted, the RMS error changes from {:.3g} to {} "
                    "with the parameters that were fitted to the chosen rows",
                    rows, std::sqrt(square_before / rows) / channel.factor,
                    reading_text(channel, std::sqrt(square_after / rows)))));
  }
}

Diagnosis Investigation::conclude() {
  if (!is_anything_missing()) append(result_.messages, unusual_values(result_.base));
  if (!is_anything_missing() && result_.within_tolerance) find_immaterial();
  result_.sentence = sentence();
  result_.headline = headline(result_, !hidden_               ? Inputs::tell_all
                                       : outside_the_inputs() ? Inputs::miss_what_changes
                                                              : Inputs::may_miss_something);
  tell_of_all_rows();
  return std::move(result_);
}

}  // namespace raceway::verdict
