#include "fit/approximation_loop.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>

#include "fit/headline.h"
#include "fit/residual_course.h"
#include "fit/thinned_record.h"
#include "fit/verdict_text.h"

namespace raceway::fit {
namespace {

constexpr double comes_near = 1.2;       // of the error of the best
constexpr double half_an_hour = 1800.0;  // in which what is left forgets itself [s]
constexpr double decided = 20.0;         // lambda from which two are told apart
constexpr double most_of_it = 0.5;       // of a mean square
constexpr double one_way =
    1.3;  // length of the way over its span: below it the record warms up once
constexpr double surely_better = 0.95;  // of the held-out error

/// "second-time-constant" of "second-time-constant:ambient".
std::string plain(const std::string& id) { return id.substr(0, id.find(':')); }

/// Errors of means as a root mean square of one channel [SI]; they are weighed by the tolerance.
double weight_of(const Recorded& recorded) { return recorded.means.list.front().weight; }

/// A fit with one or two candidates.
struct Tried {
  std::vector<const Candidate*> on{};
  const Fault* shown = nullptr;  ///< instead: by the record itself
  Approximation fit{};
  [[nodiscard]] double error() const { return fit.rms_held_out; }
  [[nodiscard]] std::vector<std::string> ids() const {
    std::vector<std::string> list;
    if (shown) list.push_back(shown->id);
    for (const Candidate* c : on) list.push_back(c->id);
    return list;
  }
};

class Inquiry {
 public:
  Inquiry(const Subject& subject, const Record& record, const DiagnoseOptions& options)
      : options_(options), record_(record) {
    subject.require(record);
    std::unique_ptr<Subject> informed = subject.informed_by(record);
    subject_ = informed ? std::shared_ptr<const Subject>(std::move(informed))
                        : std::shared_ptr<const Subject>(subject.with_values({}));
    if (!std::isfinite(channel().tolerance))
      throw std::invalid_argument(
          fmt::format("a model of {} only comes near: whether something is missing depends on what "
                      "matters; say it by tolerance_{} (or --tolerance)",
                      channel().channel->words, channel().channel->key_unit()));
    recorded_ = recorded(*subject_, for_search(std::make_shared<const Record>(record)),
                         usual_width(record));
    require_readings();
    candidates_ = subject_->candidates();
    if (!options.candidates.empty())
      std::erase_if(candidates_, [&](const Candidate& c) {
        return std::find(options.candidates.begin(), options.candidates.end(), c.id) ==
               options.candidates.end();
      });
  }

  Diagnosis run() {
    step(0.05, "refitting the model");
    base_ = approximate(subject_, recorded_, subject_->free(), search());
    require_fit(base_);
    hold_out(base_, recorded_);
    describe();
    step(0.15, "refitting with each effect");
    try_singles();
    decide();
    return conclude();
  }

 private:
  [[nodiscard]] Measured channel() const { return subject_->measured().front(); }
  [[nodiscard]] double in_SI(double error) const { return error / weight_of(recorded_); }
  [[nodiscard]] ApproximationOptions search() const {
    return {.cancelled = [this] { return options_.cancelled && options_.cancelled->load(); }};
  }

  void step(double share, std::string_view what) const {
    if (options_.cancelled && options_.cancelled->load()) throw Cancelled();
    if (options_.progress) options_.progress(share, what);
  }

  void require_readings() const {
    const auto count = static_cast<std::size_t>(recorded_.means.size());
    constexpr std::size_t least = 40;
    if (count < least)
      throw std::invalid_argument(
          fmt::format("{} readings of {} at {} different minutes: a verdict needs {} or more",
                      count, channel().channel->words, count, least));
    if (goes_one_way())
      throw std::invalid_argument(
          "this record cannot validate a model: it goes from one state to another once, so that no "
          "part of it can be held out and told from the rest; record a cool-down with it, or a "
          "second profile");
  }

  /// The way that the readings go is hardly longer than their span.
  [[nodiscard]] bool goes_one_way() const {
    constexpr std::size_t stretches = 60;
    const std::vector<Means::Mean>& list = recorded_.means.list;
    std::vector<double> smooth;
    for (std::size_t k = 0; k < stretches; ++k) {
      const std::size_t begin = k * list.size() / stretches,
                        end = (k + 1) * list.size() / stretches;
      double sum = 0.0;
      for (std::size_t i = begin; i < end; ++i) sum += list[i].measured;
      if (end > begin) smooth.push_back(sum / static_cast<double>(end - begin));
    }
    double way = 0.0;
    for (std::size_t k = 1; k < smooth.size(); ++k) way += std::abs(smooth[k] - smooth[k - 1]);
    const auto [low, high] = std::minmax_element(smooth.begin(), smooth.end());
    return way < one_way * (*high - *low);
  }

  void describe() {
    ChannelDiagnosis& d = result_.channels.emplace_back();
    const Measured of = channel();
    const std::vector<double> predicted = predict(*fitted(base_), record_);
    d.baseline = compare(predicted, record_, of, static_cast<int>(base_.names.size()));
    d.tolerance = of.tolerance;
    d.rmse_before = d.rmse_after = in_SI(base_.rms);
    d.rmse_held_out_before = in_SI(base_.rms_held_out);
    result_.refits.push_back(refit_of(base_, recorded_));
    d.noise.rms = std::isfinite(of.std) ? of.std : noise_of_neighbours(record_, *of.channel);
    result_.rows = d.baseline.rows;
    result_.rows_not_predicted = d.baseline.rows_not_predicted;
    if (!std::isfinite(d.noise.rms))
      result_.messages.emplace_back(
          "readings stand too far apart to tell the noise of the sensor from what the machine does "
          "between them");
    for (std::size_t k = 0; k < base_.names.size(); ++k)
      if (base_.fit.at_bound[k])
        result_.messages.push_back(
            fmt::format("{} = {} ends at a bound: the record cannot tell it, or something is "
                        "missing",
                        base_.parameters[k].name,
                        with_unit(base_.parameters[k].value, base_.parameters[k].unit)));
    if (std::isnan(base_.rms_held_out))
      throw std::invalid_argument(
          "these readings have no parts that could be held out: nothing can be judged by them");
    for (const std::string& id : subject_->catalogue())
      if (std::string why = subject_->lacks(id, record_); !why.empty())
        result_.not_testable.push_back({id, "needs " + why});
  }

  void try_singles() {
    for (std::size_t k = 0; k < candidates_.size(); ++k) {
      step(0.15 + 0.35 * static_cast<double>(k) / static_cast<double>(candidates_.size()),
           candidates_[k].id);
      Tried t{.on = {&candidates_[k]}};
      t.fit = approximate_with(base_, recorded_, t.on, search());
      if (t.fit.fit.values.size() == 0) continue;
      hold_out(t.fit, recorded_);
      singles_.push_back(std::move(t));
    }
    look_at_record();
    sort(singles_);
    result_.candidates_tried = static_cast<int>(singles_.size()) + options_.tried_before;
  }

  /// Faults that the record shows of itself: the model alone, on what it would be without.
  void look_at_record() {
    const auto asked = [&](const std::string& id) {
      const std::vector<std::string>& only = options_.candidates;
      return only.empty() || std::find(only.begin(), only.end(), id) != only.end();
    };
    faults_ = fitted(base_)->faults(record_);
    for (const Fault& e : faults_) {
      if (!asked(e.id)) continue;
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
    return (ratio <= comes_near || lambda < decided) &&
           taken >= most_of_it * (base * base - best.error() * best.error());
  }

  /// The best and all that come near it, without other forms of the same.
  [[nodiscard]] std::vector<const Tried*> near_best(const std::vector<Tried>& list) const {
    std::vector<const Tried*> set{&list.front()};
    for (const Tried& t : list) {
      const auto same = [&](const Tried* s) {
        std::vector<std::string> a = t.ids(), b = s->ids();
        for (auto* ids : {&a, &b}) {
          for (std::string& id : *ids) id = plain(id);
          std::sort(ids->begin(), ids->end());
        }
        return a == b;
      };
      if (std::none_of(set.begin(), set.end(), same) && rivals(t, list.front())) set.push_back(&t);
    }
    return set;
  }

  /// Of pairs that are not told apart those of the machine come before those of its readings: three
  /// jumps fit much that they have nothing to do with.
  [[nodiscard]] static std::vector<const Tried*> causes_first(std::vector<const Tried*> set) {
    std::stable_partition(set.begin(), set.end(), [](const Tried* t) {
      return std::none_of(t->on.begin(), t->on.end(),
                          [](const Candidate* c) { return c->of_reading; });
    });
    return set;
  }

  /// An error that is not told from the tolerance: so large does one of the tolerance turn out, by
  /// the few half hours of a record, once in twenty times.
  [[nodiscard]] double as_good_as_within() const {
    constexpr double one_sided = 1.645;
    return 1.0 + one_sided / std::sqrt(2.0 * recorded_.duration / half_an_hour);
  }

  void decide() {
    result_.within_tolerance = base_.rms_held_out <= 1.0;
    if (result_.within_tolerance) {
      for (const Tried& t : singles_)
        if (t.error() < surely_better * base_.rms_held_out)
          result_.significant_but_immaterial.push_back(t.ids().front());
      return;
    }
    if (!singles_.empty() && singles_.front().error() <= as_good_as_within()) {
      found_ = near_best(singles_);
      result_.verdict = found_.size() == 1 ? Verdict::effect : Verdict::ambiguous;
      return;
    }
    const auto shown = std::find_if(singles_.begin(), singles_.end(),
                                    [](const Tried& t) { return t.shown != nullptr; });
    if (shown != singles_.end()) {
      found_ = {&*shown};
      result_.verdict = Verdict::effect_like;
      result_.course = course_of(recorded_.means, base_.fit.residual);
      return;
    }
    if (options_.pairs) try_pairs();
    if (!pairs_.empty() && pairs_.front().error() <= 1.0 &&
        comes_near * pairs_.front().error() <= singles_.front().error()) {
      found_ = causes_first(near_best(pairs_));
      result_.verdict = Verdict::several_effects;
      return;
    }
    const double base = base_.rms_held_out;
    const bool like = !singles_.empty() && singles_.front().error() * singles_.front().error() <=
                                               most_of_it * base * base;
    if (like) found_ = {&singles_.front()};
    result_.verdict = like ? Verdict::effect_like : Verdict::not_in_catalogue;
    const Approximation& best = like ? singles_.front().fit : base_;
    result_.course = course_of(recorded_.means, best.fit.residual);
  }

  /// Pairs that meet the tolerance on the rows that they were fitted to: others cannot on those
  /// that they did not see.
  void try_pairs() {
    if (singles_.empty()) return;
    const double most = std::min(1.0, singles_.front().error() / comes_near);
    const std::size_t count = candidates_.size() * (candidates_.size() - 1) / 2;
    std::size_t done = 0;
    for (std::size_t i = 0; i < candidates_.size(); ++i)
      for (std::size_t j = i + 1; j < candidates_.size(); ++j) {
        step(0.5 + 0.4 * static_cast<double>(done++) / static_cast<double>(count),
             "refitting with pairs of effects");
        Tried t{.on = {&candidates_[i], &candidates_[j]}};
        ApproximationOptions from = search();
        from.random_starts = 8;
        from.polished = 2;
        t.fit = approximate_with(base_, recorded_, t.on, from);
        if (!(t.fit.rms <= most)) continue;
        hold_out(t.fit, recorded_);
        pairs_.push_back(std::move(t));
      }
    sort(pairs_);
  }

  [[nodiscard]] RankedEffect ranked(const Tried& t, std::size_t member) const {
    RankedEffect effect{.id = t.ids()[member]};
    if (t.shown) {
      effect.datum = t.shown->datum;
      effect.correction = t.shown->correction;
    }
    for (const Candidate* c : t.on)
      if (c->id == effect.id) effect.acts_on = c->acts_on;
    effect.rmse = {in_SI(t.fit.rms)};
    effect.rmse_held_out = {in_SI(t.error())};
    const ApproximationErrors errors = errors_of(t.fit, recorded_);
    for (std::size_t k = 0; k < t.fit.parameters.size(); ++k) {
      Parameter p = t.fit.parameters[k];
      const auto at = static_cast<Eigen::Index>(k);
      p.std = std::sqrt(errors.covariance(at, at));
      if (k < base_.names.size()) {
        p.start = base_.parameters[k].value;
        effect.base.push_back(std::move(p));
      } else if (p.name.starts_with(effect.id + ".")) {
        p.name.erase(0, effect.id.size() + 1);
        effect.parameters.push_back(std::move(p));
      }
    }
    return effect;
  }

  [[nodiscard]] bool is_told(const std::string& id) const {
    return std::any_of(result_.effects.begin(), result_.effects.end(),
                       [&](const RankedEffect& e) { return e.id == id; });
  }

  void fill() {
    for (const Tried* t : found_) {
      result_.sets.push_back(t->ids());
      const std::vector<std::string> ids = t->ids();
      for (std::size_t m = 0; m < ids.size(); ++m) {
        if (is_told(ids[m])) continue;
        RankedEffect effect = ranked(*t, m);
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
    if (found_.empty()) return;
    const Tried& best = *found_.front();
    result_.base = ranked(best, 0).base;
    ChannelDiagnosis& d = result_.channels.front();
    d.rmse_after = in_SI(best.fit.rms);
    d.rmse_held_out_after = in_SI(best.error());
    if (best.shown)
      result_.messages.push_back(best.shown->datum + ": " + best.shown->correction);
    else
      explain(best);
    for (const Candidate* c : best.on)
      if (c->of_reading)
        result_.messages.push_back(fmt::format(
            "{} cleans this record: it is carried neither to another one nor to a control", c->id));
  }

  /// What the readings are made of, with the best.
  void explain(const Tried& best) {
    const std::vector<RowError>& rows = result_.channels.front().baseline.errors;
    const auto at_rows = [&](const Subject& subject) {
      const std::vector<double> all = predict(subject, record_);
      std::vector<double> list;
      for (const RowError& e : rows) list.push_back(all[e.row]);
      return list;
    };
    const std::shared_ptr<const Subject> with = fitted(best.fit);
    ExplainedReadings readings{.total = at_rows(*with)};
    const auto without = [&](const Candidate* only) {
      std::vector<NamedValue> off;
      for (const Candidate* c : best.on)
        if (!only || c == only)
          off.push_back({c->parameters[c->size].name, c->parameters[c->size].neutral});
      return at_rows(*with->with_values(off));
    };
    readings.base = without(nullptr);
    for (const Candidate* c : best.on) {
      EffectShare share{.id = c->id, .readings = readings.total};
      const std::vector<double> rest = without(c);
      for (std::size_t i = 0; i < rest.size(); ++i) share.readings[i] -= rest[i];
      readings.effects.push_back(std::move(share));
    }
    result_.explained.push_back(std::move(readings));
    result_.refits.push_back(refit_of(best.fit, recorded_));
    result_.verdict_is_explained = true;
  }

  [[nodiscard]] std::string error(double value) const {
    return reading_text(*channel().channel, in_SI(value));
  }

  [[nodiscard]] std::string found_text() const {
    std::vector<std::string> names;
    for (const Tried* t : found_) names.push_back(joined(t->ids(), "and"));
    return joined(names, "or");
  }

  [[nodiscard]] std::string sentence() const {
    const std::string tolerance = reading_text(*channel().channel, channel().tolerance);
    const std::string base =
        fmt::format("on parts held out the refitted model errs by {}, of {} tolerated",
                    error(base_.rms_held_out), tolerance);
    switch (result_.verdict) {
      case Verdict::nothing_missing:
        return fmt::format("Nothing is missing that matters: {}.{}", base,
                           result_.significant_but_immaterial.empty()
                               ? ""
                               : " Better, but within the tolerance: " +
                                     joined(result_.significant_but_immaterial, "and") + ".");
      case Verdict::effect: {
        const Tried& best = *found_.front();
        const Tried* next = nullptr;
        for (const Tried& t : singles_)
          if (!next && plain(t.ids().front()) != plain(best.ids().front())) next = &t;
        return fmt::format(
            "Consistent with {}: {}; with it {}{}.", found_text(), base, error(best.error()),
            next ? fmt::format(", next best {} {}", next->ids().front(), error(next->error()))
                 : "");
      }
      case Verdict::ambiguous:
        return fmt::format(
            "{}: {}; the first leaves {}, and the others come so near that this record "
            "cannot tell which of them it is.",
            found_text(), base, error(found_.front()->error()));
      case Verdict::several_effects:
        return fmt::format(
            "Consistent with {}: {}; no single effect brings it within (best {} {}), "
            "together {}.",
            found_text(), base, singles_.front().ids().front(), error(singles_.front().error()),
            error(found_.front()->error()));
      case Verdict::effect_like:
        return fmt::format(
            "Something is missing that matters: {}; {} takes most of it, and leaves {}: "
            "more than one thing is missing, or another law.{}",
            base, found_text(), error(found_.front()->error()), course_text());
      case Verdict::not_in_catalogue:
        break;
    }
    return fmt::format("Something is missing that nothing in the catalogue explains: {}{}.{}", base,
                       singles_.empty() ? ""
                                        : fmt::format("; the nearest, {}, leaves {}",
                                                      singles_.front().ids().front(),
                                                      error(singles_.front().error())),
                       course_text());
  }

  [[nodiscard]] std::string course_text() const {
    if (!result_.course) return "";
    std::string text;
    if (!result_.course->when.empty()) {
      std::vector<std::string> parts;
      for (const auto& [from, to] : result_.course->when)
        parts.push_back(fmt::format("{:.2f} to {:.2f} h", from / 3600, to / 3600));
      text += " It errs most from " + joined(parts, "and") + ".";
    }
    if (std::isfinite(result_.course->period))
      text += fmt::format(" It comes back every {:.3g} min.", result_.course->period / 60);
    return text;
  }

  Diagnosis conclude() {
    fill();
    result_.sentence = sentence();
    result_.headline = headline(result_);
    return std::move(result_);
  }

  const DiagnoseOptions& options_;
  const Record& record_;
  std::shared_ptr<const Subject> subject_;
  Recorded recorded_;
  std::vector<Candidate> candidates_;
  std::vector<Fault> faults_;
  Approximation base_;
  std::vector<Tried> singles_, pairs_;
  std::vector<const Tried*> found_;
  Diagnosis result_;
};

}  // namespace

Diagnosis diagnose_approximation(const Subject& subject, const Record& record,
                                 const DiagnoseOptions& options) {
  return Inquiry(subject, record, options).run();
}

}  // namespace raceway::fit
