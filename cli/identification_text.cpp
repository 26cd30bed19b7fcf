#include "cli/identification_text.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "cli/text_table.h"
#include "text/names.h"

namespace raceway::cli {
namespace {

std::string unit_of(const correction::Identification& found) {
  return std::string(correction::unit_of(found.model));
}

/// Gains of a bank of lags, an input in each line.
void print_bank(const correction::Identification& found) {
  std::vector<double> lags;
  for (const correction::DrivenChannel& c : found.model.channels)
    for (const correction::Section& s : c.sections)
      if (std::find(lags.begin(), lags.end(), s.time_constant) == lags.end())
        lags.push_back(s.time_constant);
  std::vector<TextTable::Column> head{
      {"input", "", true}, {"gain per", "", true}, {"at once", unit_of(found)}};
  for (const double lag : lags) head.push_back({fmt::format("{:g} s", lag), unit_of(found)});
  TextTable table(std::move(head));
  for (const correction::DrivenChannel& c : found.model.channels) {
    // A gain per 1000 rpm is easier to read than one per rpm.
    const bool of_speed = c.input.unit() == "rpm";
    const double unit = c.input.factor() * (of_speed ? 1000.0 : 1.0);
    std::vector<std::string> cells{c.name, of_speed ? "1000 rpm" : std::string(c.input.unit()),
                                   number(c.feedthrough * unit / um, 3)};
    for (const double lag : lags) {
      const auto at =
          std::find_if(c.sections.begin(), c.sections.end(),
                       [&](const correction::Section& s) { return s.time_constant == lag; });
      cells.push_back(at == c.sections.end() ? "" : number(at->gain * unit / um, 3));
    }
    table.add(std::move(cells));
  }
  fmt::print("{}", table.text(terminal_width()));
}

/// Errors on the rest of the record, of fits to its first part.
void print_ahead(const correction::Identification& found) {
  TextTable table({{"fitted to", "h"}, {"error ahead", unit_of(found)}});
  for (const correction::AheadError& e : found.ahead)
    table.add({number(e.from / 3600.0, 3), number(e.rms / um, 3)});
  fmt::print("{}", table.text(terminal_width()));
  fmt::print(
      "error ahead: RMS error on the rest of the record after a fit to the first part. The gains "
      "are the mean\nof {} ridge regressions with different penalties; regressions with a smaller "
      "error ahead have more\nweight\n\n",
      found.strengths.size());
}

void print_sections(const correction::Identification& found) {
  TextTable table({{"parameter", "", true}, {"value", ""}, {"std error", ""}, {"unit", "", true}});
  for (const record::Parameter& p : found.parameters)
    table.add({p.name, number(p.value, 5), number(p.std, 2), p.unit == "1" ? "-" : p.unit});
  fmt::print("{}", table.text(terminal_width()));
}

/// Structures that were taken, and how the error fell.
void print_ladder(const correction::Identification& found) {
  TextTable table(
      {{"structure", "", true}, {"held out", unit_of(found)}, {"in sample", unit_of(found)}});
  for (const correction::StructureTried& t : found.tried) {
    if (!t.taken) continue;
    std::string text;
    for (std::size_t c = 0; c < t.channels.size(); ++c)
      text += fmt::format("{}{} {}", c > 0 ? ", " : "", t.channels[c], t.orders[c]);
    table.add({text, number(t.rms_held_out / um, 3), number(t.rms / um, 3)});
  }
  fmt::print("{}", table.text(terminal_width()));
}

}  // namespace

void print_trust(const record::Channel& displacement, const correction::Trust& trust) {
  fmt::print("trust in {}: {}\n", displacement.name, correction::line_of(trust));
}

void print_identification(const correction::Identification& found, const record::Record& record) {
  if (found.is_bank()) {
    fmt::print("{} of {}: all inputs pass through one bank of lags\n\n",
               found.model.displacement->name, record.source);
    print_ahead(found);
    print_bank(found);
    fmt::print("\nRMS error {} {unit}, error ahead {} {unit}, noise {} {unit}\n",
               number(found.metrics.rms / um, 3), number(found.rms_held_out / um, 3),
               number(found.noise / um, 2), fmt::arg("unit", unit_of(found)));
    return;
  }
  if (correction::is_regression(found.model)) {
    fmt::print("{} of {}: multiple linear regression\n\n", found.model.displacement->name,
               record.source);
  } else {
    fmt::print("{} of {}, structures tried: {}\n\n", found.model.displacement->name, record.source,
               found.tried.size());
    print_ladder(found);
    fmt::print("\n");
  }
  print_sections(found);
  fmt::print(
      "\nRMS error {} {unit}, held-out error {} {unit}, noise {} {unit}; condition number {:.2g}; "
      "correlation time of the residuals {:.3g} min\n",
      number(found.metrics.rms / um, 3), number(found.rms_held_out / um, 3),
      number(found.noise / um, 2), found.condition, found.correlation_time / 60.0,
      fmt::arg("unit", unit_of(found)));
}

void print_more_errors(const record::Channel& displacement, const correction::Metrics& m) {
  if (m.readings == 0) return;
  fmt::print(
      "{}: mean absolute error {} {unit}, peak-to-peak error {} {unit}; the largest error is {} % "
      "smaller than the largest displacement\n",
      displacement.name, number(m.mean_abs / um, 3), number(m.peak_to_peak / um, 3),
      number(m.reduction_of_max_percent, 3), fmt::arg("unit", displacement.unit));
}

void print_baseline(const record::Channel& displacement, const correction::ArxBaseline& a,
                    const record::Record& record) {
  fmt::print("{} of {}: ARX model (inputs: {}), fitted to {} points every {:.4g} s\n\n",
             displacement.name, record.source, text::listed(a.inputs), a.rows, a.sampling);
  const std::string unit(displacement.unit);
  TextTable table({{"order", ""},
                   {"one step", unit},
                   {"fit", "%"},
                   {"simulated", unit},
                   {"fit", "%"},
                   {"second half", unit},
                   {"poles", "time constants, s", true, true}});
  for (const correction::ArxFit& f : a.fits) {
    std::vector<std::string> lags;
    for (std::size_t k = 0; k < f.poles.size(); ++k) {
      const std::complex<double>& z = f.poles[k];
      lags.push_back(std::isfinite(f.time_constants[k]) ? number(f.time_constants[k], 3)
                     : std::abs(z) >= 1.0               ? "unstable"
                     : z.imag() != 0.0                  ? "oscillates"
                                                        : "negative");
    }
    table.add({fmt::format("{}", f.order), number(f.one_step.rms / um, 3),
               number(f.one_step.fit_percent, 4), number(f.simulated.rms / um, 3),
               number(f.simulated.fit_percent, 4), number(f.second_half.rms / um, 3),
               fmt::format("{}", fmt::join(lags, ", "))});
  }
  fmt::print("{}", table.text(terminal_width()));
  fmt::print(
      "RMS errors of three predictions. one step: prediction of each point from the readings "
      "before it.\nsimulated: prediction from the inputs only, as in a control. second half: "
      "simulation of the second\nhalf with the fit to the first half.\n");
}

}  // namespace raceway::cli
