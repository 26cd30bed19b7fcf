#include "verdict/verdict_text.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "verdict/effect_sizes.h"
#include "verdict/search.h"

namespace raceway::verdict {

std::string joined(const std::vector<std::string>& words, const char* last) {
  std::string text;
  for (std::size_t k = 0; k < words.size(); ++k)
    text += (k == 0 ? "" : k + 1 == words.size() ? std::string(" ") + last + " " : ", ") + words[k];
  return text;
}

std::string p_text(double p) { return p < 1e-300 ? "p < 1e-300" : fmt::format("p = {:.1g}", p); }

std::string with_unit(double value, const std::string& unit, int digits) {
  return unit == "1" || unit.empty() ? fmt::format("{:.{}g}", value, digits)
                                     : fmt::format("{:.{}g} {}", value, digits, unit);
}

std::string_view unit_of_difference(const record::Channel& channel) {
  return channel.offset == 0.0 ? channel.unit : std::string_view("K");
}

std::string reading_text(const record::Channel& channel, double value, int digits) {
  return fmt::format("{:.{}g} {}", value / channel.factor, digits, unit_of_difference(channel));
}

std::string nothing_missing_text(const Diagnosis& d) {
  std::vector<DetectableSize> easy = d.would_have_been_found;
  std::erase_if(easy, [](const DetectableSize& e) { return !(e.share_of_reading < 0.2); });
  std::stable_sort(easy.begin(), easy.end(), [](const DetectableSize& a, const DetectableSize& b) {
    return a.share_of_reading < b.share_of_reading;
  });
  std::vector<std::string> found, hidden;
  for (std::size_t k = 0; k < easy.size() && k < 3; ++k)
    found.push_back(fmt::format("{} ({})", easy[k].id, with_unit(easy[k].size, easy[k].unit)));
  for (const NotTestable& n : d.not_testable)
    if (hidden.size() < 3) hidden.push_back(n.id);
  return fmt::format(
      "These data show no missing effect (p = {:.2g}, significance level 1 %).{}{}", d.p_value,
      found.empty() ? ""
                    : " These effects would have been found if they had at least the given size: " +
                          joined(found, "and") + ".",
      hidden.empty() ? ""
                     : " Effects such as " + joined(hidden, "and") + " could not have been found.");
}

std::string within_tolerance_text(const Diagnosis& d) {
  std::vector<std::string> errors;
  for (const ChannelDiagnosis& c : d.channels)
    if (std::isfinite(c.tolerance))
      errors.push_back(
          fmt::format("{:.3g} (tolerance {})",
                      fit::beyond_noise(c.rmse_held_out_before, c.noise.rms) / c.channel().factor,
                      reading_text(c.channel(), c.tolerance)));
  const std::string certain = d.significant_but_immaterial.empty()
                                  ? ""
                                  : fmt::format(" Significant, but within the tolerance: {}.",
                                                joined(d.significant_but_immaterial, "or"));
  return fmt::format(
      "No important effect is missing: in the held-out error of the refitted model, the part that "
      "the noise does not explain is {}.{}",
      joined(errors, "and"), certain);
}

std::string error_text(const Diagnosis& d) {
  std::vector<std::string> texts;
  for (std::size_t c = 0; c < d.channels.size(); ++c) {
    const ChannelDiagnosis& of = d.channels[c];
    const double unit = of.channel().factor;
    std::string text = fmt::format("{:.3g} -> {}", of.rmse_before / unit,
                                   reading_text(of.channel(), of.rmse_after));
    if (!d.hold_out.empty() && !d.tolerance_limited())
      text += fmt::format(", on held-out blocks {:.3g} -> {:.3g}",
                          fit::rms_over(d.hold_out, &fit::HoldOut::rmse_before)[c] / unit,
                          fit::rms_over(d.hold_out, &fit::HoldOut::rmse_after)[c] / unit);
    texts.push_back(std::move(text));
  }
  return fmt::format("{}", fmt::join(texts, "; "));
}

std::string shift_text(const Diagnosis& d) {
  std::vector<std::string> texts;
  for (const record::Parameter& b : d.base) {
    const double share = b.start / b.value - 1.0;
    if (std::isfinite(share) && std::abs(share) >= 0.01)
      texts.push_back(fmt::format("{} was {:.0f} % too {}", b.name, 100.0 * std::abs(share),
                                  share > 0.0 ? "high" : "low"));
  }
  return texts.empty() ? "" : "; without this explanation, " + joined(texts, "and");
}

std::vector<record::Note> unusual_values(std::span<const record::Parameter> fitted) {
  constexpr double far = 3.0;
  std::vector<record::Note> notes;
  for (const record::Parameter& p : fitted)
    if (!p.held && !is_plausible(p, far))
      notes.push_back(record::note::check_data(
          fmt::format("{} = {} is far from the usual {:g} to {}: check the units of readings and "
                      "inputs, and what they refer to; or the model lacks an effect",
                      p.name, with_unit(p.value, p.unit), p.plausible_lower,
                      with_unit(p.plausible_upper, p.unit)),
          {.key = p.name}));
  return notes;
}

bool will_decide(const Diagnosis& d) { return !(d.predicted_separation < within_reach); }

std::string measure_text(const Diagnosis& d) {
  std::vector<std::string> texts;
  for (const SuggestedMeasurement& m : d.suggested_measurements)
    if (texts.size() < 3) texts.push_back(fmt::format("{} ({} times)", m.words, m.repeats));
  std::string text;
  if (!texts.empty())
    text = fmt::format(
        " Measure: {}. After these measurements, the gains of the possible causes should differ by "
        "{:.0f}; after repeated readings at the present points, by {:.0f}.{}",
        fmt::join(texts, "; "), d.predicted_separation, d.separation_by_repetition,
        will_decide(d) ? "" : fmt::format(" A decision needs a difference of {:g}.", within_reach));
  if (!d.records_needed.empty())
    text += " Record: " + fmt::format("{}.", fmt::join(d.records_needed, "; "));
  return text;
}

std::string difference_text(const record::Record& record, const HiddenInput& hidden) {
  const std::span<const double> readings = record.values(*hidden.channel);
  std::string text =
      fmt::format("{} {} and {}: {:.0f} and {:.0f} {}", record.lines.empty() ? "rows" : "lines",
                  record.line(hidden.low), record.line(hidden.high),
                  hidden.channel->in_unit(readings[hidden.low]),
                  hidden.channel->in_unit(readings[hidden.high]), hidden.channel->unit);
  if (!record.parts.empty()) text += " in " + record.parts[record.part_of(hidden.low)].name;
  for (const record::Column& c : record.columns)
    if (c.channel->role == record::Role::setting && c.channel->ratio)
      return text + fmt::format(" at {:.0f} and {:.0f} {}",
                                c.channel->in_unit(c.values[hidden.low]),
                                c.channel->in_unit(c.values[hidden.high]), c.channel->unit);
  return text;
}

}  // namespace raceway::verdict
