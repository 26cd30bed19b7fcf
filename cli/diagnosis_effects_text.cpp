#include "cli/diagnosis_effects_text.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "cli/error_text.h"
#include "cli/text_bars.h"
#include "cli/text_table.h"

namespace raceway::cli {
namespace {

std::string size_text(const std::vector<fit::Parameter>& parameters) {
  std::string text;
  for (const fit::Parameter& p : parameters) {
    if (!text.empty()) text += ", ";
    text += number(p.value, 3);
    if (!std::isnan(p.std)) text += " +- " + number(p.std, 2);
    if (p.unit != "1") text += " " + p.unit;
    if (p.at_bound != fit::Bound::none) text += " (at its bound)";
    if (!p.plausible) text += " (implausible)";
  }
  return text;
}

/// Gains are falls of the likelihood; a verdict by tolerance alone has none.
bool has_gains(const verdict::Diagnosis& d) { return !std::isnan(d.needed_gain); }

/// The channel that errs most on rows left out, of what is tolerated or else of its noise.
struct WorstChannel {
  double share = unset;
  std::string_view words = {};
};

WorstChannel worst_channel(const std::vector<double>& errors, const verdict::Diagnosis& d) {
  WorstChannel worst;
  for (std::size_t k = 0; k < std::min(errors.size(), d.channels.size()); ++k) {
    const verdict::ChannelDiagnosis& c = d.channels[k];
    const double share = errors[k] / (d.tolerance_limited() ? c.tolerance : c.noise.rms);
    if (std::isnan(worst.share) || share > worst.share) worst = {share, c.channel().words};
  }
  return worst;
}

/// Errors of every channel, then what it is and how much it gains.
TextTable effects_table(const verdict::Diagnosis& d) {
  std::vector<TextTable::Column> columns{{"effect", "", true}, {"", "", true}};
  if (has_gains(d)) columns.push_back({"gain", ""});
  if (d.channels.size() >= many_channels) {
    columns.push_back({"held out", d.tolerance_limited() ? "of tolerance" : "of noise"});
    columns.push_back({"worst in", "", true});
  } else {
    for (const verdict::ChannelDiagnosis& c : d.channels) {
      columns.push_back({"RMS", error_unit(c.channel())});
      columns.push_back({"held out", error_unit(c.channel())});
    }
  }
  columns.push_back({"size", "", true});
  if (has_gains(d)) columns.push_back({"gain, | needed", "", true});
  return TextTable(columns);
}

std::string range_text(double lower, double upper) {
  return std::isfinite(upper)   ? fmt::format("{} to {}", number(lower, 3), number(upper, 3))
         : std::isfinite(lower) ? fmt::format("{} or more", number(lower, 3))
                                : "any value";
}

/// The size of an effect in few characters.
std::string short_size_text(const verdict::RankedEffect& e) {
  if (e.parameters.empty()) return {};
  record::Parameter size = e.parameters[std::min(e.size, e.parameters.size() - 1)];
  const bool bound = size.at_bound != fit::Bound::none, plausible = size.plausible;
  size.at_bound = fit::Bound::none;
  size.plausible = true;
  return size_text({size}) + (!plausible ? ", implausible" : bound ? ", at its bound" : "");
}

}  // namespace

std::string channel_error(const std::vector<double>& errors, std::size_t k,
                          const verdict::Diagnosis& d) {
  return k < errors.size() ? error_text(errors[k], d.channels[k].channel(), error_digits) : "-";
}

std::string effects_text(const verdict::Diagnosis& d, std::size_t most) {
  if (d.effects.empty() || most == 0) return {};
  const bool one_error = d.channels.size() == 1;
  std::vector<TextTable::Column> columns{{"effect", "", true}, {"", "", true}};
  if (has_gains(d)) columns.push_back({"gain", ">= " + number(d.needed_gain, 3)});
  columns.push_back({"held out", one_error               ? error_unit(d.channels[0].channel())
                                 : d.tolerance_limited() ? "of tolerance"
                                                         : "of noise"});
  columns.push_back({"size", "", true});
  TextTable table(columns);
  const std::size_t shown = std::min(most, d.effects.size());
  for (std::size_t k = 0; k < shown; ++k) {
    const verdict::RankedEffect& e = d.effects[k];
    std::vector<std::string> row{e.id, e.in_verdict ? "<-" : ""};
    if (has_gains(d)) row.push_back(number(std::abs(e.gain) < 0.005 ? 0.0 : e.gain, 3));
    row.push_back(one_error ? channel_error(e.rmse_held_out, 0, d)
                            : number(worst_channel(e.rmse_held_out, d).share, 3));
    row.push_back(short_size_text(e));
    table.add(std::move(row));
  }
  return table.text(terminal_width()) +
         fmt::format("--verbose shows all effects ({} more), detection limits and intervals\n",
                     d.effects.size() - shown);
}

void print_effects(const verdict::Diagnosis& d) {
  TextTable table = effects_table(d);
  constexpr std::size_t bar_width = 16;
  double best = 0.0;
  for (const verdict::RankedEffect& e : d.effects) best = std::max(best, e.gain);
  std::size_t shown = 0;
  for (const verdict::RankedEffect& e : d.effects) {
    if (!e.in_verdict && shown >= 8) break;
    ++shown;
    const std::string gain_bar = bar(e.gain, best, bar_width, d.needed_gain);
    // Rounding of a gain is no gain.
    const double gain = std::abs(e.gain) < 0.005 ? 0.0 : e.gain;
    std::vector<std::string> row{e.id, e.in_verdict ? "<-" : ""};
    if (has_gains(d)) row.push_back(number(gain, 3));
    if (d.channels.size() >= many_channels) {
      const WorstChannel worst = worst_channel(e.rmse_held_out, d);
      row.push_back(number(worst.share, 3));
      row.emplace_back(worst.words);
    } else {
      for (std::size_t k = 0; k < d.channels.size(); ++k) {
        row.push_back(channel_error(e.rmse, k, d));
        row.push_back(channel_error(e.rmse_held_out, k, d));
      }
    }
    row.push_back(size_text(e.parameters));
    if (has_gains(d)) row.push_back(e.in_verdict ? in_colour(gain_bar, Colour::good) : gain_bar);
    table.add(std::move(row));
  }
  if (shown == 0) return;
  fmt::print("\n{}", table.text(terminal_width()));
  if (!has_gains(d)) return;
  fmt::print(
      "gain: decrease of -2 ln L (L: likelihood) by the effect, minus ln N (N: number of readings) "
      "for each\nfitted parameter of the effect except its size; a verdict needs a gain of {} "
      "(explanations tried: {},\nrows: {})\n",
      number(d.needed_gain, 3), d.candidates_tried, d.rows);
}

void print_intervals(const verdict::Diagnosis& d) {
  for (const verdict::RankedEffect& e : d.effects)
    for (const fit::Parameter& p : e.parameters)
      if (e.in_verdict && !std::isnan(p.interval.lower))
        fmt::print("{}.{}: {}{}{} (95 % interval; usual values {})\n", e.id, p.name,
                   range_text(p.interval.lower, p.interval.upper), p.unit == "1" ? "" : " ",
                   p.unit == "1" ? "" : p.unit, range_text(p.plausible_lower, p.plausible_upper));
  if (d.sets.empty()) return;
  for (const fit::Parameter& b : d.base)
    fmt::print("{}: without the effects of the verdict {}, with these effects {}{}\n", b.name,
               number(b.start), number(b.value),
               std::isnan(b.std) ? "" : " +- " + number(b.std, 2));
}

void print_other_bases(const verdict::Diagnosis& d) {
  for (const verdict::OtherBaseTried& b : d.other_bases) {
    fmt::print("{}: gain {}, RMS error {} {unit}, held-out error {} {unit}", b.words,
               number(b.gain, 3), channel_error(b.rmse, 0, d), channel_error(b.rmse_held_out, 0, d),
               fmt::arg("unit", error_unit(d.channels.front().channel())));
    for (const fit::Parameter& p : b.parameters) fmt::print(", {} = {}", p.name, size_text({p}));
    fmt::print("\n");
  }
}

}  // namespace raceway::cli
