#include "cli/check_text.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string_view>
#include <utility>

#include "cli/error_text.h"
#include "cli/text_table.h"
#include "text/number_text.h"
#include "text/units.h"

namespace raceway::cli {
namespace {

std::string noise_of_channel(const loop::Check::MeasuredChannel& m) {
  const auto text = [&](double rms) {
    return fmt::format("{} {} rms", error_text(rms, *m.channel, 3), error_unit(*m.channel));
  };
  const std::string stated =
      std::isnan(m.noise.rms)
          ? "not known (too few repeated rows, and std is not given in every row)"
          : fmt::format("{} ({})", text(m.noise.rms), fit::name(m.noise.source));
  // Both find the same noise: one number is enough.
  if (std::isnan(m.found_noise) || std::abs(m.found_noise - m.noise.rms) < 1e-3 * m.found_noise)
    return stated;
  return fmt::format("{}; calibrate and diagnose find {}", stated, text(m.found_noise));
}

void print_measured(const loop::Check& c, const record::Record& data) {
  const std::vector<loop::Check::MeasuredChannel>& measured = c.measured;
  std::vector<std::string_view> words;
  for (const loop::Check::MeasuredChannel& m : measured) words.push_back(m.channel->words);
  fmt::print("{}: {} row{} of {}{}\n", data.source, c.rows, c.rows == 1 ? "" : "s",
             fmt::join(words, ", "),
             c.runs == 0   ? ""
             : c.runs == 1 ? ", one run"
                           : fmt::format(", {} runs", c.runs));
  for (const loop::Check::MeasuredChannel& m : measured)
    fmt::print("noise{}: {}\n", measured.size() > 1 ? fmt::format(" of {}", m.channel->words) : "",
               noise_of_channel(m));
}

/// Scatter of the readings, as far as stops tell it.
void print_noise(const correction::RecordCheck& c) {
  constexpr std::size_t most_lines = 6;
  const fit::Repeatability& r = c.repeatability;
  const std::string unit(c.displacement->unit);
  if (!r.known()) {
    if (std::isfinite(c.noise_at_most))
      fmt::print(
          "noise of a reading: at most {} {}, estimated from those 25 % of the readings that are "
          "nearest to the line between their two neighbours\n",
          number(c.noise_at_most / um, 2), unit);
    return;
  }
  fmt::print(
      "number of machine stops with repeated readings: {}; scatter of a reading ±{} {} (2 sigma, "
      "{} degrees of freedom)\n",
      r.stops.size(), number(2.0 * r.std / um, 2), unit, r.degrees_of_freedom);
  TextTable table(
      {{"stop at", "s"}, {"readings", ""}, {"mean", unit}, {"2 sigma of the mean", unit}});
  for (std::size_t k = 0; k < std::min(most_lines, r.stops.size()); ++k) {
    const fit::Stop& s = r.stops[k];
    table.add({number(s.time, 5), fmt::format("{}", s.readings), number(s.mean / um, 4),
               number(2.0 * r.std / std::sqrt(s.readings) / um, 2)});
  }
  fmt::print("{}", table.text(terminal_width()));
  if (r.stops.size() > most_lines)
    fmt::print("... number of further stops: {}; --json lists all stops\n",
               r.stops.size() - most_lines);
}

/// Effects with the same reason, in the order of the catalogue.
void print_testable(const std::vector<loop::Check::Testable>& catalogue) {
  constexpr std::size_t indent = 2;
  std::vector<std::pair<std::string, std::vector<std::string>>> groups;
  for (const loop::Check::Testable& t : catalogue) {
    const std::string heading =
        !t.ruled_out.empty() ? "not testable: " + t.ruled_out
        : !t.missing.empty() ? "not testable: needs " + t.missing
        : !t.levels.empty()
            ? "testable, but difficult to separate from other effects without " + t.levels
            : "testable";
    const auto known = std::find_if(groups.begin(), groups.end(),
                                    [&](const auto& group) { return group.first == heading; });
    if (known == groups.end())
      groups.push_back({heading, {t.id}});
    else
      known->second.push_back(t.id);
  }
  for (const auto& [heading, ids] : groups) {
    for (const std::string& line : filled("effects " + heading, terminal_width()))
      fmt::print("{}\n", line);
    for (const std::string& line :
         filled(fmt::format("{}", fmt::join(ids, ", ")), terminal_width() - indent))
      fmt::print("{:{}}{}\n", "", indent, line);
  }
}

}  // namespace

void print_check(const loop::Check& c, const record::Record& data) {
  print_measured(c, data);
  TextTable columns({{"column", "", true}, {"from", ""}, {"to", ""}, {"levels", ""}});
  for (const loop::Check::Column& column : c.columns)
    columns.add(
        {std::string(column.channel->name), number(column.channel->in_unit(column.lower), 5),
         number(column.channel->in_unit(column.upper), 5), fmt::format("{}", column.levels)});
  fmt::print("\n{}\n", columns.text(terminal_width()));
  for (const fit::Parameter& p : c.free)
    fmt::print("free parameter {}: {}\n", p.name,
               p.identifiable ? "can be fitted" : "these data do not determine it");
  print_testable(c.catalogue);
}

void print_settings_hold(record::SettingsHold hold) {
  const bool until = hold == record::SettingsHold::until_row;
  fmt::print(
      "settings (speed, load, feed, coolant) of a row apply from {}; the reading of the row was "
      "taken {} "
      "({})\n",
      until ? "the previous row to this row" : "this row to the next row",
      hold == record::SettingsHold::from_row ? "just before the change of the settings"
                                             : "with the settings of this row",
      hold == record::SettingsHold::sampled
          ? "settings_hold is not given"
          : fmt::format("settings_hold = \"{} row\"", until ? "until" : "from"));
}

void print_defaults(const std::string& source, const std::vector<files::UsedDefault>& defaults) {
  const bool marked = std::any_of(defaults.begin(), defaults.end(), [](const auto& d) {
    return d.origin == files::UsedDefault::Origin::marked;
  });
  fmt::print("{}: {} assumption{}{}\n", source, defaults.size(), defaults.size() == 1 ? "" : "s",
             marked ? " (to confirm a marked value, delete its comment)" : "");
  for (const std::string& line : files::short_lines(defaults)) fmt::print("  {}\n", line);
}

void print_check(const correction::RecordCheck& c) {
  fmt::print(
      "rows every {:.4g} s over {:.4g} h, {} readings every {:.4g} s: the record can show time "
      "constants of {:.3g} s to {:.3g} s\n",
      c.sampling, c.duration / 3600.0, c.readings, c.reading_interval, c.shortest, c.longest);
  print_noise(c);
  for (const correction::RecordCheck::Quantum& q : c.quanta)
    fmt::print("{}: resolution {:.3g} {} (last digit)\n", q.column->name, q.step / q.column->factor,
               text::difference_unit(*q.column));
  for (const correction::RecordCheck::Printed& p : c.printed) {
    std::vector<std::string> lags;
    for (const double tau : p.check.time_constants)
      lags.push_back(std::isfinite(tau) ? fmt::format("{:.4g} s", tau) : "no decay");
    fmt::print(
        "channel {}: time constants of the poles: {}; DC gain {:.4g} {} per unit of the input "
        "({:.4g} to {:.4g} within the rounding of the printed digits, 5th to 95th percentile)\n",
        p.channel, fmt::join(lags, ", "), p.check.dc_gain / um, c.displacement->unit,
        p.check.dc_gain_lower / um, p.check.dc_gain_upper / um);
  }
}

}  // namespace raceway::cli
