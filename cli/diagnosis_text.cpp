#include "cli/diagnosis_text.h"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>

#include "cli/diagnosis_effects_text.h"
#include "cli/diagnosis_errors_text.h"
#include "cli/error_text.h"
#include "cli/text_bars.h"
#include "cli/text_table.h"
#include "verdict/verdict_text.h"

namespace raceway::cli {
namespace {

void print_hold_out(const verdict::Diagnosis& d) {
  for (const fit::HoldOut& h : d.hold_out)
    for (std::size_t k = 0; k < d.channels.size(); ++k) {
      const record::Channel& of = d.channels[k].channel();
      fmt::print(
          "held-out RMS error, blocks by {}{}: {} {} without and {} {} with the effects of the "
          "verdict\n",
          h.variable, d.channels.size() > 1 ? fmt::format(", {}", of.words) : "",
          channel_error(h.rmse_before, k, d), error_unit(of), channel_error(h.rmse_after, k, d),
          error_unit(of));
    }
}

void print_shape(const fit::Shape& shape) {
  fmt::print("\nShape of the missing effect: {}\n  {} = \"{}\"\n", shape.statement, shape.key,
             shape.formula);
  for (const fit::Parameter& c : shape.coefficients)
    fmt::print("  {} = {}\n", c.name, number(c.value, 4));
}

std::string setting_text(const fit::Setting& s) {
  return std::isnan(s.value) ? "as it is"
                             : number(s.channel->in_unit(s.value), s.channel->ratio ? 4 : 3);
}

/// Values of the axes that are told, point by point.
void print_next_points(const verdict::Diagnosis& d) {
  if (d.suggested_measurements.empty()) return;
  std::vector<TextTable::Column> columns;
  for (const fit::Axis& axis : d.axes)
    if (axis.told)
      columns.push_back(
          {(columns.empty() ? "measure next: " : "") + std::string(axis.channel->words),
           std::string(axis.channel->unit)});
  columns.push_back({"repeats", ""});
  columns.push_back({"separates", "", true});
  TextTable points(columns);
  for (const verdict::SuggestedMeasurement& m : d.suggested_measurements) {
    std::vector<std::string> row;
    for (std::size_t i = 0; i < d.axes.size(); ++i)
      if (d.axes[i].told) row.push_back(setting_text(m.point[i]));
    row.push_back(fmt::format("{}", m.repeats));
    row.push_back(m.separates);
    points.add(std::move(row));
  }
  fmt::print("\n{}", points.text(terminal_width()));
}

std::string p_of_misfit(const verdict::Diagnosis& d) {
  return std::isnan(d.p_value) ? ""
         : d.p_value < 1e-300  ? " (p-value of the misfit < 1e-300)"
                               : fmt::format(" (p-value of the misfit {:.1g})", d.p_value);
}

void print_verdict_details(const verdict::Diagnosis& d) {
  print_intervals(d);
  print_hold_out(d);
  if (d.tolerance_limited() && !d.significant_but_immaterial.empty())
    fmt::print("effects that are significant, but within the tolerance: {}\n",
               fmt::join(d.significant_but_immaterial, ", "));
  print_other_bases(d);
  if (d.shape) print_shape(*d.shape);
  print_next_points(d);
  for (const std::string& record : d.records_needed) fmt::print("record: {}\n", record);
}

void print_limits(const verdict::Diagnosis& d) {
  const bool torque = d.channels.front().channel() == record::friction_torque;
  TextTable found({{"detectable effect", "", true},
                   {"from", ""},
                   {"unit", "", true},
                   {torque ? "% of torque" : "% of reading", ""}});
  for (const verdict::DetectableSize& s : d.would_have_been_found)
    found.add({s.id, number(s.size, 2), s.unit == "1" ? "-" : s.unit,
               number(100.0 * s.share_of_reading, 2)});
  if (!d.would_have_been_found.empty()) fmt::print("\n{}", found.text(terminal_width()));
  if (!d.not_testable.empty()) fmt::print("\neffects that these data cannot test:\n");
  for (const verdict::NotTestable& n : d.not_testable) fmt::print("  {}: {}\n", n.id, n.reason);
}

/// Text in lines that fit the terminal.
std::string lines_of(std::string_view words) {
  std::string text;
  for (const std::string& line : filled(words, terminal_width())) text += line + '\n';
  return text;
}

std::size_t line_count(std::string_view text) {
  return static_cast<std::size_t>(std::count(text.begin(), text.end(), '\n'));
}

/// The sentence without its advice on what to measure and to record, cut at a full stop so that it
/// takes at most `most` lines. A power law gives way to another base law that fits better.
std::string short_sentence(const verdict::Diagnosis& d, std::size_t most) {
  std::string sentence = d.sentence;
  for (const char* advice : {" Measure: ", " Record: "})
    sentence.resize(std::min(sentence.find(advice), sentence.size()));
  if (const std::size_t shape = sentence.find(" A power law describes ");
      d.given_other_base && shape != sentence.npos)
    sentence.erase(shape, sentence.find(". ", shape) + 1 - shape);
  while (!sentence.empty() && line_count(lines_of(sentence)) > most) {
    const std::size_t stop = sentence.rfind(". ", sentence.size() - 2);
    sentence.resize(stop == sentence.npos ? 0 : stop + 1);
  }
  return sentence.empty() ? "" : lines_of(sentence);
}

/// The first point to measure and the first quantity to record.
std::string advice(const verdict::Diagnosis& d) {
  const auto more = [](std::size_t all) {
    return all > 1 ? fmt::format(" (--verbose shows {} more)", all - 1) : std::string();
  };
  std::string text;
  if (!d.suggested_measurements.empty()) {
    const verdict::SuggestedMeasurement& m = d.suggested_measurements.front();
    text += lines_of(fmt::format("Measure next: {} ({} times){}{}.", m.words, m.repeats,
                                 more(d.suggested_measurements.size()),
                                 verdict::will_decide(d) ? "" : ". This may not decide"));
  }
  if (!d.records_needed.empty())
    text += lines_of(
        fmt::format("Record: {}{}.", d.records_needed.front(), more(d.records_needed.size())));
  return text;
}

/// At most `most_lines` lines: errors, the best effects, the sentence and, last, the headline.
void print_brief(const verdict::Diagnosis& d) {
  constexpr std::size_t most_lines = 20, most_effects = 4;
  const std::string errors = errors_text(d, true);
  const std::string next = advice(d), headline = lines_of(d.headline);
  const std::size_t used = line_count(errors + next + headline) + 2;  // two blank lines
  std::size_t room = most_lines - std::min(used, most_lines);
  // The effects have a heading of two lines and a line behind them.
  const std::size_t sentence_lines = line_count(short_sentence(d, room));
  const std::size_t rows = room > sentence_lines + 3 ? room - sentence_lines - 3 : 0;
  const std::string effects = effects_text(d, std::clamp<std::size_t>(rows, 2, most_effects));
  room -= std::min(room, line_count(effects));
  // A script that reads the last line gets the headline whole.
  fmt::print(
      "{}\n{}{}{}{}{}\n", errors, effects, effects.empty() ? "" : "\n", short_sentence(d, room),
      next,
      in_colour(isatty(STDOUT_FILENO) != 0 ? headline.substr(0, headline.size() - 1) : d.headline,
                Colour::strong));
}

void print_details(const verdict::Diagnosis& d) {
  fmt::print("verdict: {}{}\n\n", verdict::name(d.verdict), p_of_misfit(d));
  if (d.given_other_base) {
    const verdict::Diagnosis& given = *d.given_other_base;
    fmt::print("verdict with {}: {}{}\n  {}\n\n", d.other_bases.front().words,
               verdict::name(given.verdict), p_of_misfit(given), given.headline);
  }
  fmt::print("{}", errors_text(d, false));
  print_effects(d);
  fmt::print("\n");
  print_verdict_details(d);
  print_limits(d);
  fmt::print("\n{}\n{}\n", d.sentence, in_colour(d.headline, Colour::strong));
}

}  // namespace

void print_diagnosis(const verdict::Diagnosis& d, bool verbose) {
  if (verbose)
    print_details(d);
  else
    print_brief(d);
}

}  // namespace raceway::cli
