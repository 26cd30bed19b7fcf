#include "tolerance/approximation_loop.h"

#include <fmt/format.h>

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>

#include "tolerance/detail/inquiry.h"
#include "tolerance/one_way.h"
#include "tolerance/residual_course.h"
#include "tolerance/stray_readings.h"
#include "tolerance/thinned_record.h"
#include "verdict/verdict_text.h"

namespace raceway::tolerance {
namespace {

constexpr double half_an_hour = 1800.0;  // in which what is left forgets itself [s]
constexpr double decided = 20.0;         // lambda from which two are told apart
constexpr double much_of_it = 0.5;       // of a mean square
constexpr double surely_better = 0.95;   // of the held-out error

}  // namespace

std::size_t worst_channel(const std::vector<double>& errors) {
  std::size_t worst = 0;
  for (std::size_t c = 0; c < errors.size(); ++c)
    if (errors[c] > errors[worst] || std::isnan(errors[worst])) worst = c;
  return worst;
}

double worst_held_out(const Approximation& a) {
  return a.channel_held_out.empty() ? unset : a.channel_held_out[worst_channel(a.channel_held_out)];
}

Inquiry::Inquiry(const fit::Subject& subject, const record::Record& record,
                 const verdict::DiagnoseOptions& options)
    : options_(options), record_(record) {
  subject.require(record);
  std::unique_ptr<fit::Subject> informed = subject.informed_by(record);
  subject_ = informed ? std::shared_ptr<const fit::Subject>(std::move(informed))
                      : std::shared_ptr<const fit::Subject>(subject.with_values({}));
  channels_ = subject_->measured();
  for (fit::Measured& m : channels_) m.tolerance = fit::tolerance_of(m, record);
  for (const fit::Measured& m : channels_)
    if (!std::isfinite(m.tolerance))
      throw std::invalid_argument(
          fmt::format("a verdict on {} needs the largest RMS error that you accept: enter "
                      "tolerance_{} (or --tolerance)",
                      m.channel->words, m.channel->key_unit()));
  recorded_ = recorded(*subject_, for_search(std::make_shared<const record::Record>(record)),
                       usual_width(record));
  require_readings();
  candidates_ = subject_->candidates();
  if (!options.candidates.empty())
    std::erase_if(candidates_, [&](const fit::Candidate& c) {
      return std::find(options.candidates.begin(), options.candidates.end(), c.id) ==
             options.candidates.end();
    });
}

verdict::Diagnosis Inquiry::run() {
  step(0.05, "refitting the model");
  base_ = approximate(subject_, recorded_, subject_->free(), search());
  require_fit(base_);
  hold_out(base_, recorded_);
  if (std::isnan(base_.rms_held_out))
    throw std::invalid_argument(
        "no part of these readings can be held out, so diagnose cannot give a verdict");
  describe();
  step(0.15, "refitting with each effect");
  try_singles();
  decide();
  return conclude();
}

/// "axial displacement, housing temperature": the channels that the record has.
std::string Inquiry::words_of_read() const {
  std::string words;
  for (const fit::Measured& m : channels_)
    if (record_.has(*m.channel)) words.append(words.empty() ? "" : ", ").append(m.channel->words);
  return words;
}

/// Errors of a channel are in its tolerances.
double Inquiry::in_SI(double error, std::size_t of) const {
  return error * channels_[of].tolerance;
}

/// By channel of the results.
std::vector<double> Inquiry::in_SI(const std::vector<double>& errors) const {
  std::vector<double> list;
  for (const std::size_t c : told_) list.push_back(c < errors.size() ? in_SI(errors[c], c) : unset);
  return list;
}

ApproximationOptions Inquiry::search() const {
  return {.rough = subject_->is_costly(),
          .cancelled = [this] { return options_.cancelled && options_.cancelled->load(); }};
}

void Inquiry::step(double share, std::string_view what) const {
  if (options_.cancelled && options_.cancelled->load()) throw fit::Cancelled();
  if (options_.progress) options_.progress(share, what);
}

void Inquiry::require_readings() {
  const auto count = static_cast<std::size_t>(recorded_.means.size());
  constexpr std::size_t least = 16, enough = 40;
  if (count < least)
    throw std::invalid_argument(
        fmt::format("{} readings of {} are too few: a verdict needs {} or more. Rows that are "
                    "close in time count as one reading",
                    count, words_of_read(), least));
  few_readings_ = count < enough;
  if (few_readings_)
    result_.messages.push_back(record::note::limits(fmt::format(
        "only {} readings of {}: the verdict is a hint, and pairs of effects are not tried; take "
        "{} readings or more",
        count, words_of_read(), enough)));
  bool all_go_one_way = true;
  for (std::size_t c = 0; c < channels_.size(); ++c)
    all_go_one_way = all_go_one_way && goes_one_way(recorded_.means, c);
  if (all_go_one_way)
    throw std::invalid_argument(
        "this record cannot validate a model: the readings change only once, in one direction, "
        "so no part of the record can test a fit to the other part. Record a cool-down as well, "
        "or a second "
        "speed profile");
}

/// Means of one channel.
fit::Means Inquiry::means_of_channel(std::size_t channel) const {
  fit::Means means;
  for (const fit::Means::Mean& mean : recorded_.means.list)
    if (mean.channel == channel) means.list.push_back(mean);
  return means;
}

void Inquiry::describe() {
  const std::vector<double> predicted = fit::predict(*fitted(base_), record_);
  const std::size_t rows = record_.rows();
  bool noise_is_known = true;
  for (std::size_t c = 0; c < channels_.size(); ++c) {
    const fit::Measured& of = channels_[c];
    if (c >= base_.channel_held_out.size() || std::isnan(base_.channel_held_out[c]))
      continue;  // not read
    told_.push_back(c);
    verdict::ChannelDiagnosis& d = result_.channels.emplace_back();
    d.baseline = verdict::compare(std::span(predicted).subspan(c * rows, rows), record_, of,
                                  static_cast<int>(base_.names.size()));
    d.tolerance = of.tolerance;
    d.rmse_before = d.rmse_after = in_SI(base_.channel_rms[c], c);
    d.rmse_held_out_before = in_SI(base_.channel_held_out[c], c);
    d.noise.rms = std::isfinite(of.std) ? of.std : fit::noise_of_neighbours(record_, *of.channel);
    noise_is_known = noise_is_known && std::isfinite(d.noise.rms);
    result_.rows = std::max(result_.rows, d.baseline.rows);
  }
  result_.refits.push_back(refit_of(base_, recorded_));
  result_.rows_not_predicted = result_.channels.front().baseline.rows_not_predicted;
  if (!noise_is_known)
    result_.messages.push_back(
        record::note::noise("the readings are too far apart in time to separate the noise of the "
                            "sensor from the motion of the machine"));
  for (std::size_t k = 0; k < base_.names.size(); ++k)
    if (base_.fit.at_bound[k])
      result_.messages.push_back(record::note::at_bound(
          fmt::format(
              "{} = {} is at a bound: the record does not determine it, or an effect is missing",
              base_.parameters[k].name,
              verdict::with_unit(base_.parameters[k].value, base_.parameters[k].unit)),
          {.key = base_.parameters[k].name}));
  for (const record::Parameter& p : base_.stays) result_.messages.push_back(stays_note(p));
  for (const fit::Blocking& b : subject_->blockings(record_))
    if (!b.untold.empty())
      result_.messages.push_back(record::note::plan(fmt::format(
          "{} {} only in one part of the record. The program cannot hold out this part, so the "
          "reaction of the model to {} is not tested: record such changes at least twice",
          fmt::join(b.untold, ", "), b.untold.size() == 1 ? "changes" : "change",
          b.untold.size() == 1 ? "it" : "them")));
  for (const std::string& id : subject_->catalogue())
    if (std::string why = subject_->lacks(id, record_); !why.empty())
      result_.not_testable.push_back({id, "needs " + why});
}

/// Returns true if the record does not separate another explanation from the best one.
bool Inquiry::rivals(const Tried& other, const Tried& best) const {
  const double ratio = other.error() / best.error(), base = base_.rms_held_out;
  const double lambda = recorded_.duration / half_an_hour * (ratio * ratio - 1.0);
  const double taken = base * base - other.error() * other.error();
  // A fault has no number to fit: where it explains enough, effects that fit better do not rule
  // it out.
  if (other.shown && other.worst() <= 1.0) return true;
  return (ratio <= comes_near || lambda < decided) &&
         taken >= much_of_it * (base * base - best.error() * best.error());
}

/// The best and all that come near it, without other forms of the same.
std::vector<const Tried*> Inquiry::near_best(const std::vector<const Tried*>& list) const {
  std::vector<const Tried*> set{list.front()};
  for (const Tried* t : list) {
    const auto same = [&](const Tried* s) { return t->kinds() == s->kinds(); };
    if (std::none_of(set.begin(), set.end(), same) && rivals(*t, *list.front())) set.push_back(t);
  }
  return set;
}

/// Independent stretches of the residual: what wanders for an hour says as much as one reading.
double Inquiry::independent_stretches() const {
  const double correlation = result_.channels.front().baseline.correlation_time;
  const double length =
      std::isfinite(correlation) ? std::max(half_an_hour, 2.0 * correlation) : half_an_hour;
  return std::max(2.0, recorded_.duration / length);
}

/// Price of having tried many columns: one of them is an explanation where -2 ln L, of
/// independent stretches, falls so far against what explains without it that one of m columns
/// that have nothing to do with it does as well in 1 % of such records: m exp(-x/2) = 0.01, by
/// chi squared of two degrees, gain and time constant.
bool Inquiry::is_worth_its_column(const Tried& t, double error_without) const {
  constexpr double by_chance = 0.01;
  const auto columns = std::count_if(candidates_.begin(), candidates_.end(),
                                     [](const fit::Candidate& c) { return c.by_column; });
  return independent_stretches() * std::log(error_without / t.error()) >
         std::log(static_cast<double>(columns) / by_chance);
}

/// All of a list in its order that are worth their price, or those alone that a mechanism stands
/// for: a column that happens to follow the displacement is no explanation where one of these is.
std::vector<const Tried*> Inquiry::chosen(const std::vector<Tried>& list, bool with_columns) const {
  const auto mechanism = std::find_if(singles_.begin(), singles_.end(),
                                      [](const Tried& t) { return !t.has_column(); });
  const double without = &list == &singles_ || mechanism == singles_.end()
                             ? base_.rms_held_out
                             : std::min(base_.rms_held_out, mechanism->error());
  std::vector<const Tried*> some;
  for (const Tried& t : list)
    if (!t.has_column() || (with_columns && is_worth_its_column(t, without))) some.push_back(&t);
  return some;
}

/// Of pairs that are not told apart those of the machine come before those of its readings: three
/// jumps fit much that they have nothing to do with.
std::vector<const Tried*> Inquiry::causes_first(std::vector<const Tried*> set) {
  std::stable_partition(set.begin(), set.end(), [](const Tried* t) {
    return std::none_of(t->on.begin(), t->on.end(),
                        [](const fit::Candidate* c) { return c->of_reading; });
  });
  return set;
}

/// An error that is not told from the tolerance: so large does one of the tolerance turn out, by
/// the few half hours of a record, once in twenty times.
double Inquiry::as_good_as_within() const {
  constexpr double one_sided = 1.645;
  return 1.0 + one_sided / std::sqrt(2.0 * recorded_.duration / half_an_hour);
}

/// Whether one of these, the best first, brings the error within the tolerance; it and its rivals
/// are the verdict then.
bool Inquiry::explained_by(const std::vector<const Tried*>& list) {
  if (list.empty() || !is_believable(*list.front())) return false;
  std::vector<const Tried*> near = near_best(list);
  std::erase_if(near, [&](const Tried* t) { return !is_believable(*t); });
  // What is beyond the tolerance by chance has at least taken as much of the misfit.
  const double slack = as_good_as_within(), base = worst_held_out(base_);
  const auto is_within = [&](const Tried* t) {
    return t->worst() <= 1.0 || (t->worst() <= slack && slack * t->worst() <= base);
  };
  if (std::none_of(near.begin(), near.end(), is_within)) return false;
  const double least = near.front()->error();
  const auto column = std::find_if(singles_.begin(), singles_.end(), [&](const Tried& t) {
    return t.has_column() && comes_near * t.error() <= least;
  });
  if (column != singles_.end()) {
    // Wrong data that happen to come within the tolerance are no rival of a column without a
    // channel.
    if (is_worth_its_column(*column, least) &&
        std::all_of(near.begin(), near.end(), [](const Tried* t) { return t->is_wrong_data(); }))
      return false;
    result_.messages.push_back(record::note::plan(fmt::format(
        "with a held-out error of {}, {} explains the displacement better than the effects "
        "of the catalogue, but no mechanism is known for this column. Is the sensor of "
        "this column on the part that moves?",
        error(*column), column->ids().front())));
  }
  found_ = std::move(near);
  result_.verdict = found_.size() == 1 ? verdict::Verdict::effect : verdict::Verdict::ambiguous;
  return true;
}

bool Inquiry::explained_by_pairs(const std::vector<const Tried*>& list) {
  if (list.empty() || list.front()->worst() > 1.0 || !is_believable(*list.front()) ||
      comes_near * list.front()->error() > singles_.front().error())
    return false;
  found_ = causes_first(near_best(list));
  result_.verdict = verdict::Verdict::several_effects;
  return true;
}

void Inquiry::decide() {
  result_.within_tolerance = worst_held_out(base_) <= 1.0;
  if (result_.within_tolerance) {
    for (const Tried& t : singles_)
      if (t.error() < surely_better * base_.rms_held_out)
        result_.significant_but_immaterial.push_back(t.ids().front());
    return;
  }
  if (explained_by(chosen(singles_, false))) return;
  const auto shown = std::find_if(singles_.begin(), singles_.end(),
                                  [](const Tried& t) { return t.shown && t.shown->certain; });
  if (shown != singles_.end()) {
    found_ = {&*shown};
    result_.verdict = verdict::Verdict::effect_like;
    result_.course = course_of_worst(base_);
    return;
  }
  if (explained_by(chosen(singles_, true))) return;
  if (options_.pairs && !few_readings_) try_pairs();
  for (const bool with_columns : {false, true})
    if (explained_by_pairs(chosen(pairs_, with_columns))) return;
  const double base = base_.rms_held_out;
  const std::vector<const Tried*> worth = chosen(singles_, true);
  const bool like =
      !worth.empty() && worth.front()->error() * worth.front()->error() <= much_of_it * base * base;
  if (like) found_ = {worth.front()};
  result_.verdict = like ? verdict::Verdict::effect_like : verdict::Verdict::not_in_catalogue;
  result_.course = course_of_worst(like ? worth.front()->fit : base_);
}

/// A size that a fit drives to its bound explains nothing, where all that is known of an effect
/// is a factor or a heat.
bool Inquiry::is_believable(const Tried& t) const {
  return !subject_->is_costly() || t.is_within_bounds(base_.names.size());
}

/// Of the channel that errs most.
verdict::Course Inquiry::course_of_worst(const Approximation& a) const {
  const std::size_t worst = worst_channel(a.channel_held_out);
  const std::vector<fit::Means::Mean>& all = recorded_.means.list;
  std::vector<double> left;
  for (std::size_t i = 0; i < all.size(); ++i)
    if (all[i].channel == worst) left.push_back(a.fit.residual[static_cast<Eigen::Index>(i)]);
  return course_of(means_of_channel(worst),
                   Eigen::Map<const Eigen::VectorXd>(left.data(), std::ssize(left)));
}

verdict::Diagnosis diagnose_approximation(const fit::Subject& subject, const record::Record& record,
                                          const verdict::DiagnoseOptions& options) {
  const WithoutStrays without = without_strays(subject, record);
  verdict::Diagnosis found = Inquiry(subject, *without.record, options).run();
  found.messages.insert(found.messages.begin(), without.notes.begin(), without.notes.end());
  return found;
}

}  // namespace raceway::tolerance
