#include "verdict/headline.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <string_view>

#include "record/digits.h"
#include "verdict/verdict_text.h"

namespace raceway::verdict {
namespace {

std::string spaced(std::string text) {
  std::replace(text.begin(), text.end(), '-', ' ');
  std::replace(text.begin(), text.end(), '_', ' ');
  return text;
}

std::string capital(std::string text) {
  if (!text.empty())
    text.front() = static_cast<char>(std::toupper(static_cast<unsigned char>(text.front())));
  return text;
}

/// "10 000 rpm" of "10000 rpm".
std::string grouped(std::string text) {
  const std::size_t digits = std::min(text.find_first_not_of("0123456789"), text.size());
  for (std::size_t at = digits; digits > 4 && at > 3; at -= 3) text.insert(at - 3, 1, ' ');
  return text;
}

/// "65 N mm at 10 000 rpm" of torque_at_10000_rpm_Nmm, else "film resistance 12.3 K/W".
std::string size_words(const record::Parameter& p) {
  std::string name = p.name;
  // Two digits, without an exponent where people would write none.
  const std::string digits = fmt::format("{:.6g}", record::with_digits(p.value, 2));
  const std::string value = p.unit == "1" ? digits : digits + " " + p.unit;
  if (p.unit != "1") {  // the last word of the name is the unit
    std::string unit = p.unit;
    std::erase(unit, ' ');
    std::replace(unit.begin(), unit.end(), '/', '_');
    if (name.ends_with("_" + unit)) name.erase(name.size() - unit.size() - 1);
  }
  constexpr std::string_view mark = "_at_";
  if (const std::size_t at = name.find(mark); at != name.npos)
    return value + " at " + grouped(spaced(name.substr(at + mark.size())));
  return spaced(name) + " " + value;
}

const RankedEffect* find(const Diagnosis& d, const std::string& id) {
  for (const RankedEffect& e : d.effects)
    if (e.id == id) return &e;
  return nullptr;
}

bool is_data(const Diagnosis& d, const std::string& id) {
  const RankedEffect* const e = find(d, id);
  return e && !e->datum.empty();
}

/// "second time constant (ambient)" of second-time-constant:ambient; a column keeps its name.
std::string in_words(const std::string& id) {
  const std::size_t colon = id.find(':');
  return colon == id.npos
             ? spaced(id)
             : fmt::format("{} ({})", spaced(id.substr(0, colon)), id.substr(colon + 1));
}

/// "lubricant drag and windage".
std::string names(const std::vector<std::string>& ids, const char* last) {
  std::vector<std::string> words;
  for (const std::string& id : ids) words.push_back(in_words(id));
  return joined(words, last);
}

/// Of many channels the two that erred most, by name.
std::string errors(const Diagnosis& d) {
  constexpr std::size_t few = 2;
  std::vector<const ChannelDiagnosis*> told;
  for (const ChannelDiagnosis& c : d.channels) told.push_back(&c);
  const bool named = told.size() > few;
  if (named) {
    const auto share = [](const ChannelDiagnosis* c) {
      return c->rmse_before / (std::isnan(c->tolerance) ? c->noise.rms : c->tolerance);
    };
    std::stable_sort(told.begin(), told.end(),
                     [&](const auto* a, const auto* b) { return share(a) > share(b); });
    told.resize(few);
  }
  std::vector<std::string> texts;
  for (const ChannelDiagnosis* c : told)
    texts.push_back(fmt::format("{:.3g} -> {}{}", c->rmse_before / c->channel().factor,
                                reading_text(c->channel(), c->rmse_after),
                                named ? fmt::format(" of {}", c->channel().words) : ""));
  return "error " + joined(texts, "and");
}

std::string error_and_noise(const Diagnosis& d) {
  const ChannelDiagnosis& first = d.channels.front();
  return fmt::format(
      "error {}, noise {}", reading_text(first.channel(), first.rmse_before),
      std::isnan(first.noise.rms) ? "not known" : reading_text(first.channel(), first.noise.rms));
}

/// Where all of an explanation is wrong data: what to check, and what it should say.
std::string wrong_data(const Diagnosis& d, const std::vector<std::string>& ids) {
  std::vector<std::string> data, corrections;
  for (const std::string& id : ids) {
    const RankedEffect& e = *find(d, id);
    if (std::find(data.begin(), data.end(), e.datum) == data.end()) data.push_back(e.datum);
    corrections.push_back(e.correction.empty() ? spaced(id) : e.correction);
  }
  return fmt::format("Wrong data rather than missing physics: check {}, {}; {}",
                     joined(data, "and"), joined(corrections, "and"), errors(d));
}

/// One explanation, of one effect or of several at once.
std::string explained(const Diagnosis& d, const std::vector<std::string>& ids) {
  if (std::all_of(ids.begin(), ids.end(), [&](const std::string& id) { return is_data(d, id); }))
    return wrong_data(d, ids);
  std::vector<std::string> sizes;
  for (const std::string& id : ids)
    if (const RankedEffect* const e = find(d, id); e && !e->parameters.empty())
      sizes.push_back(size_words(e->parameters.front()));
  return fmt::format("{} {} missing: {}; {}", capital(names(ids, "and")),
                     ids.size() == 1 ? "is" : "are", joined(sizes, "and"), errors(d));
}

std::string one_of(const Diagnosis& d) {
  std::vector<std::string> choices;
  for (const std::vector<std::string>& set : d.sets) choices.push_back(names(set, "with"));
  constexpr std::size_t most = 3;
  if (choices.size() > most) {
    const std::size_t more = choices.size() - most + 1;
    choices.resize(most - 1);
    choices.push_back(fmt::format("one of {} other explanations", more));
  }
  return fmt::format("{} explains the misfit, but these data do not decide which; {}",
                     capital(joined(choices, "or")), errors(d));
}

std::string nearest(const Diagnosis& d) {
  const auto in_verdict = [](const RankedEffect& e) { return e.in_verdict; };
  const auto found = std::find_if(d.effects.begin(), d.effects.end(), in_verdict);
  return found != d.effects.end() ? found->id : d.sets.empty() ? "" : d.sets.front().front();
}

std::string by_verdict(const Diagnosis& d) {
  if (d.verdict == Verdict::nothing_missing)
    return fmt::format("Nothing is missing{}: {}",
                       d.within_tolerance ? " that matters" : " that these data can show",
                       error_and_noise(d));
  const std::string near = nearest(d);
  switch (d.verdict) {
    case Verdict::effect:
    case Verdict::several_effects:
      if (d.sets.size() > 1) return one_of(d);
      if (!d.sets.empty()) return explained(d, d.sets.front());
      break;
    case Verdict::ambiguous:
      if (!d.sets.empty()) return one_of(d);
      break;
    case Verdict::effect_like:
      if (!near.empty())
        return fmt::format("The misfit looks like {}, but the data do not confirm it: {}",
                           in_words(near), error_and_noise(d));
      break;
    default:
      break;
  }
  return "Something is missing that is not in the catalogue: " + error_and_noise(d);
}

/// Headline if another base model explains the data.
std::string other_base(const Diagnosis& d) {
  const OtherBaseTried& base = d.other_bases.front();
  const record::Channel& channel = d.channels.front().channel();
  return fmt::format("{} {} these data, but no effect does: error {:.3g} -> {}", base.words,
                     base.fitted_form ? "describes" : "explains",
                     d.channels.front().rmse_before / channel.factor,
                     reading_text(channel, base.rmse.front()));
}

}  // namespace

std::string headline(const Diagnosis& d, Inputs inputs) {
  if (inputs == Inputs::miss_what_changes && d.verdict != Verdict::nothing_missing)
    return "The cause is not an input of the model: " + error_and_noise(d);
  const bool explained = !d.other_bases.empty() && d.other_bases.front().explains;
  return (explained ? other_base(d) : by_verdict(d)) +
         (inputs == Inputs::tell_all
              ? ""
              : "; but rows at nearly equal operating points have different readings");
}

}  // namespace raceway::verdict
