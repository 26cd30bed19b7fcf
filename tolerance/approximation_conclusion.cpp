#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "tolerance/detail/inquiry.h"
#include "verdict/effect_sizes.h"
#include "verdict/headline.h"
#include "verdict/verdict_text.h"

// The result of a diagnosis, with its sentences.
namespace raceway::tolerance {

verdict::RankedEffect Inquiry::ranked(const Tried& t, std::size_t member) const {
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
std::vector<std::string> Inquiry::data_of(const Tried& t) const {
  std::vector<std::string> list;
  for (const std::string& id : t.ids())
    for (const verdict::RankedEffect& e : result_.effects)
      if (e.id == id && !e.datum.empty()) list.push_back(e.datum + ": " + e.correction);
  return list;
}

bool Inquiry::is_told(const std::string& id) const {
  return std::any_of(result_.effects.begin(), result_.effects.end(),
                     [&](const verdict::RankedEffect& e) { return e.id == id; });
}

void Inquiry::fill() {
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

/// Divides the readings into the contributions of the effects of the best fit.
void Inquiry::explain(const Tried& best) {
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
std::string Inquiry::error(const Approximation& a) const {
  const std::size_t worst = worst_channel(a.channel_held_out);
  const record::Channel& of = *channels_[worst].channel;
  return verdict::reading_text(of, in_SI(a.channel_held_out[worst], worst)) +
         (told_.size() > 1 ? fmt::format(" of {}", of.words) : "");
}

std::string Inquiry::error(const Tried& t) const { return error(t.fit); }

/// Names the effects of the verdict; for wrong data alone, also their corrected values.
std::string Inquiry::found_text() const {
  const Tried& best = *found_.front();
  if (const std::vector<std::string> data = data_of(best);
      found_.size() == 1 && !best.shown && data.size() == best.ids().size())
    return "wrong data rather than missing physics, " + verdict::joined(data, "and");
  std::vector<std::string> names;
  for (const Tried* t : found_) names.push_back(verdict::joined(t->ids(), "and"));
  return verdict::joined(names, "or");
}

std::string Inquiry::sentence() const {
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
          "Consistent with {}: {}; with this explanation the held-out error is {}{}.", found_text(),
          base, error(best),
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

std::string Inquiry::course_text() const {
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

verdict::Diagnosis Inquiry::conclude() {
  fill();
  result_.sentence = sentence();
  result_.headline = verdict::headline(result_);
  return std::move(result_);
}

}  // namespace raceway::tolerance
