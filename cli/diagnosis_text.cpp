#include "cli/diagnosis_text.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "cli/diagnosis_effects_text.h"
#include "cli/error_text.h"
#include "cli/text_bars.h"
#include "cli/text_table.h"

namespace raceway::cli {
namespace {

void print_hold_out(const verdict::Diagnosis& d) {
  for (const fit::HoldOut& h : d.hold_out)
    for (std::size_t k = 0; k < d.channels.size(); ++k) {
      const record::Channel& of = d.channels[k].channel();
      fmt::print("held out by {}{}: {} {} before, {} {} after\n", h.variable,
                 d.channels.size() > 1 ? fmt::format(", {}", of.words) : "",
                 channel_error(h.rmse_before, k, d), error_unit(of),
                 channel_error(h.rmse_after, k, d), error_unit(of));
    }
}

void print_shape(const fit::Shape& shape) {
  fmt::print("\nShape of what is missing: {}\n  {} = \"{}\"\n", shape.statement, shape.key,
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
         : d.p_value < 1e-300  ? " (p of the misfit < 1e-300)"
                               : fmt::format(" (p of the misfit {:.1g})", d.p_value);
}

void print_verdict_details(const verdict::Diagnosis& d) {
  print_intervals(d);
  print_hold_out(d);
  if (d.tolerance_limited() && !d.significant_but_immaterial.empty())
    fmt::print("certain, but within the tolerance: {}\n",
               fmt::join(d.significant_but_immaterial, ", "));
  print_other_bases(d);
  if (d.shape) print_shape(*d.shape);
  print_next_points(d);
  for (const std::string& record : d.records_needed) fmt::print("record: {}\n", record);
}

void print_limits(const verdict::Diagnosis& d) {
  const bool torque = d.channels.front().channel() == record::friction_torque;
  TextTable found({{"would have been found: effect", "", true},
                   {"from", ""},
                   {"unit", "", true},
                   {torque ? "% of torque" : "% of reading", ""}});
  for (const verdict::DetectableSize& s : d.would_have_been_found)
    found.add({s.id, number(s.size, 2), s.unit == "1" ? "-" : s.unit,
               number(100.0 * s.share_of_reading, 2)});
  if (!d.would_have_been_found.empty()) fmt::print("\n{}", found.text(terminal_width()));
  if (!d.not_testable.empty()) fmt::print("\ncould not have been found:\n");
  for (const verdict::NotTestable& n : d.not_testable) fmt::print("  {}: {}\n", n.id, n.reason);
}

/// Errors of one channel against the noise; against what is tolerated, which is judged on rows that
/// no fit saw, where that decides.
void print_ladder(const verdict::Diagnosis& d, const verdict::ChannelDiagnosis& c) {
  constexpr std::size_t bar_width = 40;
  const record::Channel& of = c.channel();
  const double tolerance = d.tolerance_limited() ? c.tolerance : unset;
  const bool tolerated = !std::isnan(tolerance);
  TextTable ladder(
      {{d.channels.size() > 1 ? fmt::format("RMS error of {}", of.words) : "RMS error", "", true},
       {"", error_unit(of)},
       {"", tolerated ? "| noise, : tolerance" : "| noise", true}});
  std::vector<std::pair<const char*, double>> rungs{{"before", c.rmse_before}};
  if (c.rmse_after < c.rmse_before) rungs.emplace_back("after", c.rmse_after);
  if (tolerated) {
    rungs.emplace_back("held out, before", c.rmse_held_out_before);
    rungs.emplace_back("held out, after", c.rmse_held_out_after);
    std::erase_if(rungs, [](const auto& rung) { return std::isnan(rung.second); });
  }
  double widest = std::fmax(0.0, tolerance);
  for (const auto& [_, error] : rungs) widest = std::max(widest, error);
  for (const auto& [name, error] : rungs)
    ladder.add({name, error_text(error, of, error_digits),
                bar(error, widest, bar_width, c.noise.rms, tolerance)});
  ladder.add({"noise", error_text(c.noise.rms, of, error_digits), ""});
  if (tolerated) ladder.add({"tolerance", error_text(tolerance, of, error_digits), ""});
  fmt::print("{}", ladder.text(terminal_width()));
}

/// One line for each of many channels.
void print_channels(const verdict::Diagnosis& d) {
  const bool tolerated = d.tolerance_limited();
  std::vector<TextTable::Column> columns{{"RMS error", "", true}, {"before", ""}, {"after", ""}};
  if (tolerated) {
    columns.push_back({"held out,", "before"});
    columns.push_back({"held out,", "after"});
  }
  columns.push_back({"noise", ""});
  if (tolerated) columns.push_back({"tolerance", ""});
  columns.push_back({"unit", "", true});
  TextTable table(columns);
  for (const verdict::ChannelDiagnosis& c : d.channels) {
    const record::Channel& of = c.channel();
    const auto text = [&](double error) { return error_text(error, of, error_digits); };
    std::vector<std::string> row{std::string(of.words), text(c.rmse_before), text(c.rmse_after)};
    if (tolerated) {
      row.push_back(text(c.rmse_held_out_before));
      row.push_back(text(c.rmse_held_out_after));
    }
    row.push_back(text(c.noise.rms));
    if (tolerated) row.push_back(text(c.tolerance));
    row.emplace_back(error_unit(of));
    table.add(std::move(row));
  }
  fmt::print("{}", table.text(terminal_width()));
}

}  // namespace

void print_diagnosis(const verdict::Diagnosis& d) {
  fmt::print("{}\n{}\n\n", in_colour(d.headline, Colour::strong), d.sentence);
  fmt::print("verdict: {}{}\n\n", verdict::name(d.verdict), p_of_misfit(d));
  if (d.given_other_base) {
    const verdict::Diagnosis& given = *d.given_other_base;
    fmt::print("given {}: {}{}\n  {}\n\n", d.other_bases.front().words,
               verdict::name(given.verdict), p_of_misfit(given), given.headline);
  }
  if (d.channels.size() >= many_channels)
    print_channels(d);
  else
    for (const verdict::ChannelDiagnosis& c : d.channels) print_ladder(d, c);
  print_effects(d);
  fmt::print("\n");
  print_verdict_details(d);
  print_limits(d);
}

}  // namespace raceway::cli
