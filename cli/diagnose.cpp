#include "fit/diagnose.h"

#include <fmt/core.h>
#include <unistd.h>

#include <atomic>
#include <cmath>
#include <csignal>

#include "cli/commands.h"
#include "cli/open_input.h"
#include "cli/report_flag.h"
#include "cli/text_bars.h"
#include "cli/text_table.h"
#include "fit/quantity.h"
#include "io/diagnosis_results.h"
#include "io/report.h"

namespace raceway::cli {
namespace {

struct Flags {
  std::string model, data;
  bool json = false, no_pairs = false, force = false;
  int tried_before = 0;
  ReportFlag report;
};

std::atomic<bool> interrupted{false};
void interrupt(int) { interrupted = true; }

void show_progress(double share, std::string_view step) {
  fmt::print(stderr, "\r\033[K{:3.0f} %  {}{}", 100.0 * share, step,
             share >= 1.0 ? "\r\033[K" : "");
  std::fflush(stderr);
}

/// A measured quantity as people read it.
struct Reading {
  fit::QuantityText text;
  explicit Reading(const fit::Diagnosis& d) : text(fit::text_of(d.baseline.quantity)) {}
  [[nodiscard]] std::string unit() const { return std::string(text.unit); }
  [[nodiscard]] std::string operator()(double value, int digits = 3) const {
    return number(value / text.factor, digits);
  }
};

std::string size_text(const std::vector<fit::EffectSize>& parameters) {
  std::string text;
  for (const fit::EffectSize& p : parameters) {
    if (!text.empty()) text += ", ";
    text += number(p.value, 3);
    if (!std::isnan(p.std)) text += " +- " + number(p.std, 2);
    if (p.unit != "1") text += " " + p.unit;
    if (p.at_bound) text += " (at its bound)";
    if (!p.plausible) text += " (implausible)";
  }
  return text;
}

void print_effects(const fit::Diagnosis& d) {
  const Reading reading(d);
  TextTable table({{"effect", "", true},
                   {"", "", true},
                   {"gain", ""},
                   {"RMS", reading.unit()},
                   {"held out", reading.unit()},
                   {"size", "", true},
                   {"gain, | needed", "", true}});
  constexpr std::size_t bar_width = 16;
  double best = 0.0;
  for (const fit::RankedEffect& e : d.effects) best = std::max(best, e.gain);
  std::size_t shown = 0;
  for (const fit::RankedEffect& e : d.effects) {
    if (!e.in_verdict && shown >= 8) break;
    ++shown;
    const std::string gain_bar = bar(e.gain, best, bar_width, d.needed_gain);
    // Rounding of a gain is no gain.
    const double gain = std::abs(e.gain) < 0.005 ? 0.0 : e.gain;
    table.add({e.id, e.in_verdict ? "<-" : "", number(gain, 3), reading(e.rmse),
               reading(e.rmse_cross_validated), size_text(e.parameters),
               e.in_verdict ? in_colour(gain_bar, Colour::good) : gain_bar});
  }
  if (shown == 0) return;
  fmt::print("\n{}", table.text(terminal_width()));
  fmt::print("gain: fall of -2 ln L; {} needed ({} explanations tried, {} rows)\n",
             number(d.needed_gain, 3), d.candidates_tried, d.rows);
}

std::string range_text(double lower, double upper) {
  return std::isfinite(upper)   ? fmt::format("{} to {}", number(lower, 3), number(upper, 3))
         : std::isfinite(lower) ? fmt::format("{} or more", number(lower, 3))
                                : "any value";
}

void print_verdict_details(const fit::Diagnosis& d) {
  const Reading reading(d);
  for (const fit::RankedEffect& e : d.effects)
    for (const fit::EffectSize& p : e.parameters)
      if (e.in_verdict && !std::isnan(p.interval.lower))
        fmt::print("{}.{}: {}{}{} (95 % interval; in practice {})\n", e.id, p.name,
                   range_text(p.interval.lower, p.interval.upper), p.unit == "1" ? "" : " ",
                   p.unit == "1" ? "" : p.unit, range_text(p.plausible_lower, p.plausible_upper));
  for (const fit::BaseShift& b : d.base_shifts)
    fmt::print("{}: {} without, {} with what is missing{}\n", b.name, number(b.before),
               number(b.after), std::isnan(b.std) ? "" : " +- " + number(b.std, 2));
  for (const fit::HoldOut& h : d.hold_out)
    fmt::print("held out by {0}: {2} {1} before, {3} {1} after\n", h.variable, reading.unit(),
               reading(h.rmse_before), reading(h.rmse_after));
  if (d.shape) {
    fmt::print("\nShape of what is missing: {}\n  torque_Nmm = \"{}\"\n", d.shape->statement,
               d.shape->formula);
    for (const fit::EffectSize& c : d.shape->coefficients)
      fmt::print("  {} = {}\n", c.name, number(c.value, 4));
  }
  if (!d.suggested_measurements.empty()) {
    const bool shaft = d.baseline.quantity == fit::Quantity::axial_displacement;
    TextTable points({{"measure next: speed", "rpm"},
                      {shaft ? "preload" : "axial load", "N"},
                      {"temperature", "C"},
                      {"repeats", ""},
                      {"separates", "", true}});
    for (const fit::SuggestedMeasurement& m : d.suggested_measurements)
      points.add({number(m.point.speed / rpm),
                  !shaft                     ? number(m.point.axial_load)
                  : std::isfinite(m.preload) ? number(m.preload)
                                             : "as it is",
                  number(celsius(m.point.temperature), 3), fmt::format("{}", m.repeats),
                  m.separates});
    fmt::print("\n{}", points.text(terminal_width()));
  }
  for (const std::string& record : d.records_needed) fmt::print("record: {}\n", record);
}

void print_limits(const fit::Diagnosis& d) {
  TextTable found(
      {{"would have been found: effect", "", true},
       {"from", ""},
       {"unit", "", true},
       {d.baseline.quantity == fit::Quantity::friction_torque ? "% of torque" : "% of reading",
        ""}});
  for (const fit::DetectableSize& s : d.would_have_been_found)
    found.add({s.id, number(s.size, 2), s.unit == "1" ? "-" : s.unit,
               number(100.0 * s.share_of_reading, 2)});
  if (!d.would_have_been_found.empty()) fmt::print("\n{}", found.text(terminal_width()));
  if (!d.not_testable.empty()) fmt::print("\ncould not have been found:\n");
  for (const fit::NotTestable& n : d.not_testable) fmt::print("  {}: {}\n", n.id, n.reason);
}

/// The error before and after against the noise.
void print_ladder(const fit::Diagnosis& d) {
  constexpr std::size_t bar_width = 40;
  const Reading reading(d);
  TextTable ladder({{"RMS error", "", true}, {"", reading.unit()}, {"", "| noise", true}});
  const auto rung = [&](const std::string& name, double error) {
    ladder.add({name, reading(error), bar(error, d.rmse_before, bar_width, d.noise.rms)});
  };
  rung("before", d.rmse_before);
  if (d.rmse_after < d.rmse_before) rung("after", d.rmse_after);
  ladder.add({"noise", reading(d.noise.rms), ""});
  fmt::print("{}", ladder.text(terminal_width()));
}

void print(const fit::Diagnosis& d) {
  fmt::print("{}\n\n", in_colour(d.sentence, Colour::strong));
  fmt::print("verdict: {} (p of the misfit {})\n\n", fit::name(d.verdict),
             d.p_value < 1e-300 ? "< 1e-300" : fmt::format("{:.1g}", d.p_value));
  print_ladder(d);
  print_effects(d);
  fmt::print("\n");
  print_verdict_details(d);
  print_limits(d);
}

int run(const Flags& flags) {
  flags.report.check(flags.force);
  const io::ModelFile file = open_model(flags.model, Subject::bearing_or_shaft);
  const fit::DataSet data = open_data(flags.data, file.model);
  fit::DiagnoseOptions options;
  options.pairs = !flags.no_pairs;
  options.tried_before = flags.tried_before;
  options.cancelled = &interrupted;
  if (isatty(STDERR_FILENO) != 0) options.progress = show_progress;
  std::signal(SIGINT, interrupt);
  const fit::Diagnosis diagnosis = [&] {
    try {
      return fit::diagnose(file.model, data, options);
    } catch (const std::invalid_argument& e) {
      refuse_data(flags.model, data, e);
    }
  }();
  std::signal(SIGINT, SIG_DFL);
  if (flags.json) {
    fmt::print("{}", io::diagnosis_json(flags.model, data, diagnosis));
  } else {
    print(diagnosis);
  }
  tell(diagnosis.messages);
  flags.report.write([&] { return io::diagnosis_report(flags.model, file.model, data, diagnosis); },
                     flags.force);
  return done;
}

}  // namespace

Run setup_diagnose(CLI::App& command) {
  auto flags = std::make_shared<Flags>();
  command.add_option("MODEL", flags->model, "model file (TOML)")->required()->type_name("");
  command.add_option("DATA", flags->data, "measurements (CSV)")->required()->type_name("");
  command.add_flag("--no-pairs", flags->no_pairs, "single effects only, for a quick look");
  command
      .add_option("--tried-before", flags->tried_before,
                  "explanations of your own already tried on these data")
      ->type_name("N");
  command.add_flag("--json", flags->json, "one JSON document instead of text");
  flags->report.declare(command);
  command.add_flag("--force", flags->force, "replace the page if it exists");
  command.footer("Example:\n  raceway diagnose my.toml rig.csv --report page.html");
  return [flags] { return run(*flags); };
}

}  // namespace raceway::cli
