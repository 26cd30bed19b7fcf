#include "tolerance/approximation_loop.h"

#include <fmt/format.h>
#include <tbb/parallel_for.h>

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <limits>
#include <mutex>
#include <stdexcept>
#include <utility>

#include "algebra/detail/decompositions.h"
#include "tolerance/one_way.h"
#include "tolerance/residual_course.h"
#include "tolerance/stray_readings.h"
#include "tolerance/thinned_record.h"
#include "verdict/effect_sizes.h"
#include "verdict/headline.h"
#include "verdict/verdict_text.h"

namespace raceway::tolerance {
namespace {

constexpr double comes_near = 1.2;       // of the error of the best
constexpr double half_an_hour = 1800.0;  // in which what is left forgets itself [s]
constexpr double decided = 20.0;         // lambda from which two are told apart
constexpr double much_of_it = 0.5;       // of a mean square
constexpr double surely_better = 0.95;   // of the held-out error
constexpr double no_limit = std::numeric_limits<double>::infinity();
constexpr std::size_t costly_members = 4;  // of pairs: the best singles
constexpr std::size_t most_members = 16;   // of all pairs: beyond that the best singles

/// The channel that errs most, in its tolerances; 0 where nothing was held out.
std::size_t worst_channel(const std::vector<double>& errors) {
  std::size_t worst = 0;
  for (std::size_t c = 0; c < errors.size(); ++c)
    if (errors[c] > errors[worst] || std::isnan(errors[worst])) worst = c;
  return worst;
}

/// An error of which the worst channel is within its tolerance is within.
double worst_held_out(const Approximation& a) {
  return a.channel_held_out.empty() ? unset : a.channel_held_out[worst_channel(a.channel_held_out)];
}

/// A fit with one or two candidates.
struct Tried {
  std::vector<const fit::Candidate*> on{};
  const fit::Fault* shown = nullptr;  ///< instead: by the record itself
  Approximation fit{};
  [[nodiscard]] double error() const { return fit.rms_held_out; }
  [[nodiscard]] double worst() const { return worst_held_out(fit); }
  /// No number of a candidate has gone as far as it may.
  [[nodiscard]] bool is_within_bounds(std::size_t base) const {
    for (std::size_t k = base; k < fit.parameters.size(); ++k)
      if (fit.parameters[k].at_bound != record::Bound::none) return false;
    return true;
  }
  [[nodiscard]] std::vector<std::string> ids() const {
    std::vector<std::string> list;
    if (shown) list.push_back(shown->id);
    for (const fit::Candidate* c : on) list.push_back(c->id);
    return list;
  }
  [[nodiscard]] bool has_column() const {
    return std::any_of(on.begin(), on.end(), [](const auto* c) { return c->by_column; });
  }
  /// It says that data are wrong, not that something is missing.
  [[nodiscard]] bool is_wrong_data() const {
    return shown
               ? !shown->datum.empty()
               : std::all_of(on.begin(), on.end(), [](const auto* c) { return !c->datum.empty(); });
  }
  /// Kinds of the effects, sorted: second-time-constant of second-time-constant:ambient.
  [[nodiscard]] std::vector<std::string> kinds() const {
    std::vector<std::string> list;
    if (shown) list.push_back(shown->id);
    for (const fit::Candidate* c : on)
      list.push_back(c->by_column ? c->id : c->id.substr(0, c->id.find(':')));
    std::sort(list.begin(), list.end());
    return list;
  }
};

class Inquiry {
 public:
  Inquiry(const fit::Subject& subject, const record::Record& record,
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

  verdict::Diagnosis run() {
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

 private:
  /// "axial displacement, housing temperature": the channels that the record has.
  [[nodiscard]] std::string words_of_read() const {
    std::string words;
    for (const fit::Measured& m : channels_)
      if (record_.has(*m.channel)) words.append(words.empty() ? "" : ", ").append(m.channel->words);
    return words;
  }
  /// Errors of a channel are in its tolerances.
  [[nodiscard]] double in_SI(double error, std::size_t of) const {
    return error * channels_[of].tolerance;
  }
  /// By channel of the results.
  [[nodiscard]] std::vector<double> in_SI(const std::vector<double>& errors) const {
    std::vector<double> list;
    for (const std::size_t c : told_)
      list.push_back(c < errors.size() ? in_SI(errors[c], c) : unset);
    return list;
  }
  [[nodiscard]] ApproximationOptions search() const {
    return {.rough = subject_->is_costly(),
            .cancelled = [this] { return options_.cancelled && options_.cancelled->load(); }};
  }

  void step(double share, std::string_view what) const {
    if (options_.cancelled && options_.cancelled->load()) throw fit::Cancelled();
    if (options_.progress) options_.progress(share, what);
  }

  void require_readings() {
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
  [[nodiscard]] fit::Means means_of_channel(std::size_t channel) const {
    fit::Means means;
    for (const fit::Means::Mean& mean : recorded_.means.list)
      if (mean.channel == channel) means.list.push_back(mean);
    return means;
  }

  void describe() {
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

  /// Fits with each of some sets of candidates, side by side; in their order.
  /// `most`: error in sample up to which parts are held out. `from`, `to`: share of the whole.
  std::vector<Tried> fits_with(const std::vector<std::vector<const fit::Candidate*>>& sets,
                               const ApproximationOptions& with, double most, double from,
                               double to) const {
    std::vector<Tried> list(sets.size());
    std::mutex telling;
    std::size_t done = 0;
    const auto try_one = [&](std::size_t k) {
      {
        const std::scoped_lock lock(telling);
        step(from + (to - from) * static_cast<double>(done++) / static_cast<double>(sets.size()),
             sets[k].size() > 1 ? "refitting with pairs of effects" : sets[k].front()->id);
      }
      list[k].on = sets[k];
      list[k].fit = approximate_with(base_, recorded_, sets[k], with);
    };
    const auto each = [&](const auto& work) {
      tbb::parallel_for(std::size_t{0}, sets.size(), work, tbb::simple_partitioner());
    };
    each(try_one);
    const double worth_finishing = with.rough ? promising(list) : 0.0;
    each([&](std::size_t k) {
      Approximation& fit = list[k].fit;
      if (fit.fit.misfit <= worth_finishing) fit = finished(fit, recorded_);
      if (fit.fit.values.size() > 0 && fit.rms <= most) hold_out(fit, recorded_);
    });
    return list;
  }

  /// Misfit up to which a rough fit may yet come near the best.
  [[nodiscard]] double promising(const std::vector<Tried>& list) const {
    constexpr double of_best = 4.0, of_base = 0.9;
    double best = base_.fit.misfit;
    for (const Tried& t : list) best = std::fmin(best, t.fit.fit.misfit);
    return std::min(of_best * best, of_base * base_.fit.misfit);
  }

  void try_singles() {
    std::vector<std::vector<const fit::Candidate*>> sets;
    for (const fit::Candidate& c : candidates_)
      if (is_testable(c.id)) sets.push_back({&c});
    singles_ = fits_with(sets, search(), no_limit, 0.15, 0.5);
    leave_out_what_is_not_felt();
    look_at_record();
    sort(singles_);
    result_.candidates_tried = static_cast<int>(singles_.size()) + options_.tried_before;
  }

  /// It takes nothing, and over all its range moves no channel by a share of its tolerance.
  [[nodiscard]] bool is_felt(const Tried& t) const {
    constexpr double least = 0.1, nothing = 1e-4;
    const Approximation& fit = t.fit;
    if (fit.slope.size() == 0 || fit.rms < (1.0 - nothing) * base_.rms) return true;
    const std::size_t size = base_.names.size() + t.on.front()->size;
    const record::Parameter& p = fit.parameters[size];
    const auto column = fit.slope.col(static_cast<Eigen::Index>(size));
    double square = 0.0;
    for (Eigen::Index i = 0; i < column.size(); ++i)
      square += std::pow(column[i] * recorded_.means.list[static_cast<std::size_t>(i)].weight, 2);
    const double moved = std::sqrt(square / static_cast<double>(column.size()));
    return !(moved * (p.upper - p.lower) < least);
  }

  void leave_out_what_is_not_felt() {
    for (const Tried& t : singles_)
      if (!is_felt(t))
        result_.not_testable.push_back(
            {t.on.front()->id, "no reading of this record depends on the effect"});
    std::erase_if(singles_, [&](const Tried& t) { return !is_felt(t); });
  }

  /// What the record cannot feel is not looked for where looking costs much.
  [[nodiscard]] bool is_testable(const std::string& id) const {
    return !subject_->is_costly() ||
           std::none_of(result_.not_testable.begin(), result_.not_testable.end(),
                        [&](const verdict::NotTestable& n) { return n.id == id; });
  }

  /// Faults that the record shows of itself: the model alone, on what it would be without.
  void look_at_record() {
    const auto asked = [&](const std::string& id) {
      const std::vector<std::string>& only = options_.candidates;
      return only.empty() || std::find(only.begin(), only.end(), id) != only.end();
    };
    faults_ = fitted(base_)->faults(record_);
    const bool something_is_left = worst_held_out(base_) > 1.0;
    for (const fit::Fault& e : faults_) {
      if (!asked(e.id) || (!e.certain && !something_is_left)) continue;
      const Recorded without = recorded(*subject_, for_search(e.without), usual_width(record_));
      Tried t{.shown = &e};
      t.fit = approximate(subject_, without, subject_->free(), search());
      if (t.fit.fit.values.size() == 0) continue;
      hold_out(t.fit, without);
      singles_.push_back(std::move(t));
    }
  }

  static void sort(std::vector<Tried>& list) {
    std::erase_if(list, [](const Tried& t) { return !std::isfinite(t.error()); });
    std::stable_sort(list.begin(), list.end(),
                     [](const Tried& a, const Tried& b) { return a.error() < b.error(); });
  }

  /// Whether another explanation comes so near the best that the record does not tell them apart.
  [[nodiscard]] bool rivals(const Tried& other, const Tried& best) const {
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
  [[nodiscard]] std::vector<const Tried*> near_best(const std::vector<const Tried*>& list) const {
    std::vector<const Tried*> set{list.front()};
    for (const Tried* t : list) {
      const auto same = [&](const Tried* s) { return t->kinds() == s->kinds(); };
      if (std::none_of(set.begin(), set.end(), same) && rivals(*t, *list.front())) set.push_back(t);
    }
    return set;
  }

  /// Independent stretches of the residual: what wanders for an hour says as much as one reading.
  [[nodiscard]] double independent_stretches() const {
    const double correlation = result_.channels.front().baseline.correlation_time;
    const double length =
        std::isfinite(correlation) ? std::max(half_an_hour, 2.0 * correlation) : half_an_hour;
    return std::max(2.0, recorded_.duration / length);
  }

  /// Price of having tried many columns: one of them is an explanation where -2 ln L, of
  /// independent stretches, falls so far against what explains without it that one of m columns
  /// that have nothing to do with it does as well in 1 % of such records: m exp(-x/2) = 0.01, by
  /// chi squared of two degrees, gain and time constant.
  [[nodiscard]] bool is_worth_its_column(const Tried& t, double error_without) const {
    constexpr double by_chance = 0.01;
    const auto columns = std::count_if(candidates_.begin(), candidates_.end(),
                                       [](const fit::Candidate& c) { return c.by_column; });
    return independent_stretches() * std::log(error_without / t.error()) >
           std::log(static_cast<double>(columns) / by_chance);
  }

  /// All of a list in its order that are worth their price, or those alone that a mechanism stands
  /// for: a column that happens to follow the displacement is no explanation where one of these is.
  [[nodiscard]] std::vector<const Tried*> chosen(const std::vector<Tried>& list,
                                                 bool with_columns) const {
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
  [[nodiscard]] static std::vector<const Tried*> causes_first(std::vector<const Tried*> set) {
    std::stable_partition(set.begin(), set.end(), [](const Tried* t) {
      return std::none_of(t->on.begin(), t->on.end(),
                          [](const fit::Candidate* c) { return c->of_reading; });
    });
    return set;
  }

  /// An error that is not told from the tolerance: so large does one of the tolerance turn out, by
  /// the few half hours of a record, once in twenty times.
  [[nodiscard]] double as_good_as_within() const {
    constexpr double one_sided = 1.645;
    return 1.0 + one_sided / std::sqrt(2.0 * recorded_.duration / half_an_hour);
  }

  /// Whether one of these, the best first, brings the error within the tolerance; it and its rivals
  /// are the verdict then.
  [[nodiscard]] bool explained_by(const std::vector<const Tried*>& list) {
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

  [[nodiscard]] bool explained_by_pairs(const std::vector<const Tried*>& list) {
    if (list.empty() || list.front()->worst() > 1.0 || !is_believable(*list.front()) ||
        comes_near * list.front()->error() > singles_.front().error())
      return false;
    found_ = causes_first(near_best(list));
    result_.verdict = verdict::Verdict::several_effects;
    return true;
  }

  void decide() {
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
    const bool like = !worth.empty() &&
                      worth.front()->error() * worth.front()->error() <= much_of_it * base * base;
    if (like) found_ = {worth.front()};
    result_.verdict = like ? verdict::Verdict::effect_like : verdict::Verdict::not_in_catalogue;
    result_.course = course_of_worst(like ? worth.front()->fit : base_);
  }

  /// A size that a fit drives to its bound explains nothing, where all that is known of an effect
  /// is a factor or a heat.
  [[nodiscard]] bool is_believable(const Tried& t) const {
    return !subject_->is_costly() || t.is_within_bounds(base_.names.size());
  }

  /// Of the channel that errs most.
  [[nodiscard]] verdict::Course course_of_worst(const Approximation& a) const {
    const std::size_t worst = worst_channel(a.channel_held_out);
    const std::vector<fit::Means::Mean>& all = recorded_.means.list;
    std::vector<double> left;
    for (std::size_t i = 0; i < all.size(); ++i)
      if (all[i].channel == worst) left.push_back(a.fit.residual[static_cast<Eigen::Index>(i)]);
    return course_of(means_of_channel(worst),
                     Eigen::Map<const Eigen::VectorXd>(left.data(), std::ssize(left)));
  }

  [[nodiscard]] std::vector<std::vector<const fit::Candidate*>> all_pairs() const {
    std::vector<const fit::Candidate*> members;
    for (const Tried& t : singles_)
      if (!t.on.empty() && members.size() < most_members) members.push_back(t.on.front());
    std::sort(members.begin(), members.end());
    std::vector<std::vector<const fit::Candidate*>> sets;
    for (std::size_t i = 0; i < members.size(); ++i)
      for (std::size_t j = i + 1; j < members.size(); ++j)
        if (!members[i]->by_column || !members[j]->by_column)
          sets.push_back({members[i], members[j]});
    return sets;
  }

  /// Those of the best few, and the best with what takes most of what it leaves, by derivatives.
  [[nodiscard]] std::vector<std::vector<const fit::Candidate*>> promising_pairs() const {
    if (singles_.front().on.empty()) return {};
    std::vector<const fit::Candidate*> members;
    for (const Tried& t : singles_)
      if (!t.on.empty() && members.size() < costly_members) members.push_back(t.on.front());
    std::vector<std::vector<const fit::Candidate*>> sets;
    for (std::size_t i = 0; i < members.size(); ++i)
      for (std::size_t j = i + 1; j < members.size(); ++j) sets.push_back({members[i], members[j]});
    for (const fit::Candidate* partner : partners_of(singles_.front())) {
      const bool is_new = std::find(members.begin(), members.end(), partner) == members.end();
      if (is_new) sets.push_back({members.front(), partner});
    }
    return sets;
  }

  /// Candidates by how far the misfit of `best` would fall with them, the most first; a few.
  [[nodiscard]] std::vector<const fit::Candidate*> partners_of(const Tried& best) const {
    const std::vector<fit::Means::Mean>& means = recorded_.means.list;
    Eigen::VectorXd weight(recorded_.means.size());
    for (Eigen::Index i = 0; i < weight.size(); ++i)
      weight[i] = means[static_cast<std::size_t>(i)].weight;
    const Eigen::MatrixXd own = weight.asDiagonal() * best.fit.slope;
    const algebra::PivotedQr qr(own);
    const auto without_own = [&](const Eigen::VectorXd& v) -> Eigen::VectorXd {
      return v - own * qr.solve(v);
    };
    const Eigen::VectorXd left = without_own(weight.cwiseProduct(best.fit.fit.residual));
    std::vector<std::pair<double, const fit::Candidate*>> falls;
    for (const Tried& t : singles_) {
      if (t.on.empty() || t.on.front() == best.on.front()) continue;
      const auto size = static_cast<Eigen::Index>(base_.names.size() + t.on.front()->size);
      const Eigen::VectorXd column =
          without_own(weight.cwiseProduct(Eigen::VectorXd(t.fit.slope.col(size))));
      const double square = column.squaredNorm();
      if (square > 0.0) falls.emplace_back(std::pow(column.dot(left), 2) / square, t.on.front());
    }
    std::stable_sort(falls.begin(), falls.end(),
                     [](const auto& a, const auto& b) { return a.first > b.first; });
    std::vector<const fit::Candidate*> list;
    for (std::size_t k = 0; k < std::min(costly_members, falls.size()); ++k)
      list.push_back(falls[k].second);
    return list;
  }

  /// Pairs that meet the tolerance on the rows that they were fitted to: others cannot on those
  /// that they did not see.
  void try_pairs() {
    if (singles_.empty()) return;
    const double most = std::min(1.0, singles_.front().error() / comes_near);
    const std::vector<std::vector<const fit::Candidate*>> sets =
        subject_->is_costly() ? promising_pairs() : all_pairs();
    ApproximationOptions from = search();
    from.random_starts = 8;
    from.polished = 2;
    pairs_ = fits_with(sets, from, most, 0.5, 0.9);
    sort(pairs_);
  }

  [[nodiscard]] verdict::RankedEffect ranked(const Tried& t, std::size_t member) const {
    verdict::RankedEffect effect{.id = t.ids()[member]};
    if (t.shown) {
      effect.datum = t.shown->datum;
      effect.correction = t.shown->correction;
    }
    for (const fit::Candidate* c : t.on)
      if (c->id == effect.id) {
        effect.acts_on = c->acts_on;
        effect.by_column = c->by_column;
        effect.size = c->size;
        effect.datum = c->datum;
      }
    effect.rmse = in_SI(t.fit.channel_rms);
    effect.rmse_held_out = in_SI(t.fit.channel_held_out);
    const ApproximationErrors errors = errors_of(t.fit, recorded_);
    for (std::size_t k = 0; k < t.fit.parameters.size(); ++k) {
      record::Parameter p = t.fit.parameters[k];
      const auto at = static_cast<Eigen::Index>(k);
      p.std = std::sqrt(errors.covariance(at, at));
      if (k < base_.names.size()) {
        p.start = base_.parameters[k].value;
        effect.base.push_back(std::move(p));
      } else if (p.name.starts_with(effect.id + ".")) {
        p.name.erase(0, effect.id.size() + 1);
        if (subject_->is_costly())
          p.plausible = !(p.value < p.plausible_lower || p.value > p.plausible_upper);
        effect.parameters.push_back(std::move(p));
      }
    }
    if (!t.shown && !effect.datum.empty()) {
      std::vector<double> values;
      for (const record::Parameter& p : effect.parameters) values.push_back(p.value);
      effect.correction = subject_->correction(effect.id, values);
    }
    return effect;
  }

  /// "the place of the thermometer housing: position 62 mm instead of the entered 50", of every
  /// datum in an explanation that was ranked.
  [[nodiscard]] std::vector<std::string> data_of(const Tried& t) const {
    std::vector<std::string> list;
    for (const std::string& id : t.ids())
      for (const verdict::RankedEffect& e : result_.effects)
        if (e.id == id && !e.datum.empty()) list.push_back(e.datum + ": " + e.correction);
    return list;
  }

  [[nodiscard]] bool is_told(const std::string& id) const {
    return std::any_of(result_.effects.begin(), result_.effects.end(),
                       [&](const verdict::RankedEffect& e) { return e.id == id; });
  }

  void fill() {
    for (const Tried* t : found_) {
      result_.sets.push_back(t->ids());
      const std::vector<std::string> ids = t->ids();
      for (std::size_t m = 0; m < ids.size(); ++m) {
        if (is_told(ids[m])) continue;
        verdict::RankedEffect effect = ranked(*t, m);
        effect.in_verdict = true;
        for (const Tried* other : found_)
          for (const std::string& id : other->ids())
            if (std::find(ids.begin(), ids.end(), id) == ids.end())
              effect.indistinguishable_from.push_back(id);
        result_.effects.push_back(std::move(effect));
      }
    }
    for (const Tried& t : singles_)
      if (!is_told(t.ids().front())) result_.effects.push_back(ranked(t, 0));
    if (found_.empty()) {
      result_.base = base_.parameters;
      const ApproximationErrors errors = errors_of(base_, recorded_);
      result_.correlation = verdict::correlation_of(base_.parameters, errors.covariance);
      for (std::size_t k = 0; k < result_.base.size(); ++k) {
        const auto at = static_cast<Eigen::Index>(k);
        result_.base[k].start = result_.base[k].value;
        result_.base[k].std = std::sqrt(errors.covariance(at, at));
      }
      return;
    }
    const Tried& best = *found_.front();
    result_.base = ranked(best, 0).base;
    result_.correlation =
        verdict::correlation_of(best.fit.parameters, errors_of(best.fit, recorded_).covariance);
    const std::vector<double> after = in_SI(best.fit.channel_rms),
                              held_out_after = in_SI(best.fit.channel_held_out);
    for (std::size_t c = 0; c < told_.size(); ++c) {
      result_.channels[c].rmse_after = after[c];
      result_.channels[c].rmse_held_out_after = held_out_after[c];
    }
    for (const std::string& wrong : data_of(best))
      result_.messages.push_back(record::note::check_data(wrong));
    if (!best.shown) explain(best);
    for (const fit::Candidate* c : best.on)
      if (c->of_reading)
        result_.messages.push_back(record::note::limits(
            fmt::format("{} only removes a disturbance from this record. The program uses this "
                        "effect neither for another record nor in a machine control",
                        c->id)));
  }

  /// What the readings are made of, with the best.
  void explain(const Tried& best) {
    const auto at_rows = [&](const fit::Subject& subject) {
      const std::vector<double> all = fit::predict(subject, record_);
      std::vector<double> list;
      for (std::size_t c = 0; c < told_.size(); ++c)
        for (const verdict::RowError& e : result_.channels[c].baseline.errors)
          list.push_back(all[told_[c] * record_.rows() + e.row]);
      return list;
    };
    const std::shared_ptr<const fit::Subject> with = fitted(best.fit);
    verdict::ExplainedReadings readings{.total = at_rows(*with)};
    const auto without = [&](const fit::Candidate* only) {
      std::vector<record::NamedValue> off;
      for (const fit::Candidate* c : best.on)
        if (!only || c == only)
          off.push_back({c->parameters[c->size].name, c->parameters[c->size].neutral});
      return at_rows(*with->with_values(off));
    };
    readings.base = without(nullptr);
    for (const fit::Candidate* c : best.on) {
      verdict::EffectShare share{.id = c->id, .readings = readings.total};
      const std::vector<double> rest = without(c);
      for (std::size_t i = 0; i < rest.size(); ++i) share.readings[i] -= rest[i];
      readings.effects.push_back(std::move(share));
    }
    result_.explained.push_back(std::move(readings));
    result_.refits.push_back(refit_of(best.fit, recorded_));
    result_.verdict_is_explained = true;
  }

  /// On parts held out; of several channels the worst.
  [[nodiscard]] std::string error(const Approximation& a) const {
    const std::size_t worst = worst_channel(a.channel_held_out);
    const record::Channel& of = *channels_[worst].channel;
    return verdict::reading_text(of, in_SI(a.channel_held_out[worst], worst)) +
           (told_.size() > 1 ? fmt::format(" of {}", of.words) : "");
  }
  [[nodiscard]] std::string error(const Tried& t) const { return error(t.fit); }

  /// Of wrong data of the model alone what they should say.
  [[nodiscard]] std::string found_text() const {
    const Tried& best = *found_.front();
    if (const std::vector<std::string> data = data_of(best);
        found_.size() == 1 && !best.shown && data.size() == best.ids().size())
      return "wrong data rather than missing physics, " + verdict::joined(data, "and");
    std::vector<std::string> names;
    for (const Tried* t : found_) names.push_back(verdict::joined(t->ids(), "and"));
    return verdict::joined(names, "or");
  }

  [[nodiscard]] std::string sentence() const {
    const fit::Measured& worst = channels_[worst_channel(base_.channel_held_out)];
    const std::string tolerance = verdict::reading_text(*worst.channel, worst.tolerance);
    const std::string base = fmt::format(
        "the held-out error of the refitted model is {} (tolerance {})", error(base_), tolerance);
    switch (result_.verdict) {
      case verdict::Verdict::nothing_missing:
        return fmt::format("No important effect is missing: {}.{}", base,
                           result_.significant_but_immaterial.empty()
                               ? ""
                               : " Small improvements within the tolerance: " +
                                     verdict::joined(result_.significant_but_immaterial, "and") +
                                     ".");
      case verdict::Verdict::effect: {
        const Tried& best = *found_.front();
        const Tried* next = nullptr;
        for (const Tried& t : singles_)
          if (!next && t.kinds().front() != best.kinds().front() &&
              (best.has_column() || !t.has_column()))
            next = &t;
        return fmt::format(
            "Consistent with {}: {}; with this explanation the held-out error is {}{}.",
            found_text(), base, error(best),
            next ? fmt::format(", next best {} with a held-out error of {}", next->ids().front(),
                               error(*next))
                 : "");
      }
      case verdict::Verdict::ambiguous:
        return fmt::format(
            "{}: {}; with {} the held-out error is {}. These explanations are nearly equally good, "
            "so this record does not decide between them.",
            found_text(), base, verdict::joined(found_.front()->ids(), "and"),
            error(*found_.front()));
      case verdict::Verdict::several_effects:
        return fmt::format(
            "Consistent with {}: {}; no single effect reaches the tolerance (best: {}, {}), but "
            "with these effects together the held-out error is {}.",
            found_text(), base, singles_.front().ids().front(), error(singles_.front()),
            error(*found_.front()));
      case verdict::Verdict::effect_like:
        return fmt::format(
            "Several effects are missing, or the model needs another law: {}; {} explains most of "
            "the misfit, but the held-out error is still {}.{}",
            base, found_text(), error(*found_.front()), course_text());
      case verdict::Verdict::not_in_catalogue:
        break;
    }
    return fmt::format(
        "An effect is missing that is not in the catalogue: {}{}.{}", base,
        singles_.empty()
            ? ""
            : fmt::format("; the best effect of the catalogue, {}, leaves a held-out error of {}",
                          singles_.front().ids().front(), error(singles_.front())),
        course_text());
  }

  [[nodiscard]] std::string course_text() const {
    if (!result_.course) return "";
    std::string text;
    if (!result_.course->when.empty()) {
      std::vector<std::string> parts;
      for (const auto& [from, to] : result_.course->when)
        parts.push_back(fmt::format("{:.2f} to {:.2f} h", from / 3600, to / 3600));
      text += " The error is largest from " + verdict::joined(parts, "and") + ".";
    }
    if (std::isfinite(result_.course->period))
      text += fmt::format(" The error repeats every {:.3g} min.", result_.course->period / 60);
    return text;
  }

  verdict::Diagnosis conclude() {
    fill();
    result_.sentence = sentence();
    result_.headline = verdict::headline(result_);
    return std::move(result_);
  }

  const verdict::DiagnoseOptions& options_;
  const record::Record& record_;
  std::shared_ptr<const fit::Subject> subject_;
  std::vector<fit::Measured> channels_;  // with their tolerances
  bool few_readings_ = false;
  std::vector<std::size_t> told_;  // of these, in the results
  Recorded recorded_;
  std::vector<fit::Candidate> candidates_;
  std::vector<fit::Fault> faults_;
  Approximation base_;
  std::vector<Tried> singles_, pairs_;
  std::vector<const Tried*> found_;
  verdict::Diagnosis result_;
};

}  // namespace

verdict::Diagnosis diagnose_approximation(const fit::Subject& subject, const record::Record& record,
                                          const verdict::DiagnoseOptions& options) {
  const WithoutStrays without = without_strays(subject, record);
  verdict::Diagnosis found = Inquiry(subject, *without.record, options).run();
  found.messages.insert(found.messages.begin(), without.notes.begin(), without.notes.end());
  return found;
}

}  // namespace raceway::tolerance
