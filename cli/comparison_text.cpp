#include "cli/comparison_text.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <span>
#include <utility>

#include "cli/error_text.h"
#include "cli/messages.h"
#include "cli/text_bars.h"
#include "cli/text_table.h"
#include "record/series_channel.h"
#include "results/correction_results.h"

namespace raceway::cli {
namespace {

using Comparisons = std::vector<verdict::Comparison>;  // of one model, by measured channel

/// Values beside an error show its decimals: rounding noise reads 0.
std::string rounded(double value, const verdict::Comparison& c, bool sign) {
  return beside(value, c.rmse / c.channel->factor, 3, sign);
}

std::string difference(double error, const verdict::Comparison& c, bool sign = true) {
  return rounded(error / c.channel->factor, c, sign);
}

std::string range_text(const verdict::ErrorRange& r) {
  if (r.is_run())
    return r.run.empty() ? "no run_id" : fmt::format("{} {}", r.channel->words, r.run);
  const record::Channel& of = *r.channel;
  const std::string low = fmt::format("{:.4g}", of.in_unit(r.from));
  const std::string high = fmt::format("{:.4g}", of.in_unit(r.to));
  return low == high ? fmt::format("{} {} {}", of.words, low, of.unit)
                     : fmt::format("{} {} to {} {}", of.words, low, high, of.unit);
}

void print_summary(const verdict::Comparison& c) {
  const std::string unit = error_unit(*c.channel);
  fmt::print("RMS error       {:>10} {}   mean error (bias) {:>10} {}\n",
             error_text(c.rmse, *c.channel), unit, difference(c.bias, c), unit);
  fmt::print("mean abs error  {:>10} {}   largest error     {:>10} {}\n",
             error_text(c.mae, *c.channel), unit, error_text(c.max_abs, *c.channel), unit);
  if (!std::isnan(c.fit_percent))
    fmt::print("fit             {:>10} %\n", number(c.fit_percent, 3));
  if (!c.begins.empty() && (c.channel->unit == "um" || record::is_angle(*c.channel))) {
    const correction::Metrics m = results::metrics_of(c);
    fmt::print(
        "peak-to-peak error {:>7} {}   largest error     {:>10} % below the largest reading\n",
        error_text(m.peak_to_peak, *c.channel), unit, number(m.reduction_of_max_percent, 3));
  }
  fmt::print("noise of the data: {}\n", noise_text(c));
  if (!std::isnan(c.lack_of_fit.p_value))
    fmt::print("lack of fit: {} = {}, {}\n",
               c.noise.source == fit::NoiseSource::repeats ? "F" : "chi2/dof",
               number(c.lack_of_fit.statistic, 3), verdict::p_value_text(c.lack_of_fit.p_value));
}

/// Parts of the rows by what sets them apart: the title of the table, and the words for one.
template <typename Words>
void print_parts(const char* title, std::span<const verdict::ErrorRange> parts,
                 const verdict::Comparison& c, const Words& words) {
  if (parts.empty()) return;
  const std::string unit = error_unit(*c.channel);
  TextTable table({{title, "", true}, {"rows", ""}, {"RMS", unit}, {"bias", unit}});
  for (const verdict::ErrorRange& r : parts)
    table.add(
        {words(r), fmt::format("{}", r.rows), difference(r.rmse, c, false), difference(r.bias, c)});
  fmt::print("\n{}", table.text(terminal_width()));
}

void print_worst(const verdict::Comparison& c, const record::Record& data) {
  const std::string unit(c.channel->unit);
  TextTable worst({{"worst rows", "", true},
                   {"predicted", unit},
                   {"measured", unit},
                   {"difference", error_unit(*c.channel)},
                   {"in sigma", ""}});
  for (const verdict::RowError& r : c.worst)
    worst.add({data.place(r.row), rounded(c.channel->in_unit(r.predicted), c, false),
               rounded(c.channel->in_unit(r.measured), c, false), difference(r.residual, c),
               std::isnan(r.sigmas) ? "-" : fmt::format("{:+.1f}", r.sigmas)});
  fmt::print("\n{}", worst.text(terminal_width()));
}

/// All channels of one model at a glance.
void print_channels(const Comparisons& comparisons) {
  TextTable table({{"channel", "", true},
                   {"rows", ""},
                   {"RMS", ""},
                   {"bias", ""},
                   {"largest", ""},
                   {"noise", ""},
                   {"tolerance", ""},
                   {"unit", "", true},
                   {"", "", true}});
  for (const verdict::Comparison& c : comparisons) {
    const record::Channel& of = *c.channel;
    const bool tolerated = !std::isnan(c.tolerance);
    table.add({std::string(of.words), fmt::format("{}", c.rows), error_text(c.rmse, of),
               difference(c.bias, c), error_text(c.max_abs, of), error_text(c.noise.rms, of, 2),
               tolerated ? error_text(c.tolerance, of, 3) : "-", error_unit(of),
               !tolerated              ? ""
               : c.rmse <= c.tolerance ? "within"
                                       : "beyond"});
  }
  fmt::print("{}\n", table.text(terminal_width()));
}

/// Channels that are shown in full: of many, those beyond their tolerance, or else the one nearest
/// to it. print_channels() has a line for each of the others.
std::vector<const verdict::Comparison*> told_in_full(const Comparisons& comparisons) {
  std::vector<const verdict::Comparison*> told;
  const auto share = [](const verdict::Comparison& c) {
    return c.rmse / (std::isnan(c.tolerance) ? c.noise.rms : c.tolerance);
  };
  const verdict::Comparison* worst = &comparisons.front();
  for (const verdict::Comparison& c : comparisons) {
    if (comparisons.size() < many_channels || !(share(c) <= 1.0)) told.push_back(&c);
    if (share(c) > share(*worst)) worst = &c;
  }
  if (told.empty()) told.push_back(worst);
  return told;
}

using Rung = std::pair<std::string, verdict::Comparison>;

/// Models against one measured channel.
void print_ladder(const std::vector<Rung>& rungs) {
  constexpr std::size_t bar_width = 24;
  const verdict::Comparison& first = rungs.front().second;
  const std::string unit = error_unit(*first.channel);
  TextTable ladder({{"model", "", true},
                    {"RMS", unit},
                    {"bias", unit},
                    {"fit", "%"},
                    {"", std::isnan(first.noise.rms) ? "" : "| noise", true}});
  double worst = 0.0;
  for (const auto& [_, c] : rungs) worst = std::max(worst, c.rmse);
  for (const auto& [model, c] : rungs) {
    ladder.add({model, error_text(c.rmse, *c.channel), difference(c.bias, c),
                number(c.fit_percent, 3), bar(c.rmse, worst, bar_width, c.noise.rms)});
    for (const verdict::ErrorRange& r : c.records)
      ladder.add({"  " + r.run, difference(r.rmse, c, false), difference(r.bias, c), "",
                  bar(r.rmse, worst, bar_width, c.noise.rms)});
  }
  fmt::print("{}noise of the data: {}\n", ladder.text(terminal_width()), noise_text(first));
}

}  // namespace

void print_comparison(const std::string& model, const Comparisons& comparisons,
                      const record::Record& data) {
  if (comparisons.size() >= many_channels) print_channels(comparisons);
  const std::vector<const verdict::Comparison*> told = told_in_full(comparisons);
  for (const verdict::Comparison* one : told) {
    const verdict::Comparison& c = *one;
    if (one != told.front()) fmt::print("\n");
    fmt::print("{} compared with {}: {} row{}, {}\n\n", model, data.source, c.rows,
               c.rows == 1 ? "" : "s", c.channel->words);
    print_summary(c);
    print_parts("record", c.records, c, [](const verdict::ErrorRange& r) { return r.run; });
    print_parts("worst ranges", std::span(c.where).first(std::min<std::size_t>(c.where.size(), 8)),
                c, range_text);
    print_worst(c, data);
    fmt::print("\n{}\n",
               in_colour(c.statement, c.judgement == verdict::Judgement::structure ? Colour::bad
                                                                                   : Colour::good));
  }
}

void print_ladders(const std::vector<std::string>& models,
                   const std::vector<Comparisons>& comparisons) {
  const Comparisons& all = comparisons.front();
  for (const verdict::Comparison& of : all) {
    if (all.size() > 1) fmt::print("{}{}\n", &of == &all.front() ? "" : "\n", of.channel->words);
    std::vector<Rung> rungs;
    for (std::size_t i = 0; i < models.size(); ++i)
      for (const verdict::Comparison& c : comparisons[i])
        if (*c.channel == *of.channel) rungs.emplace_back(models[i], c);
    print_ladder(rungs);
  }
}

}  // namespace raceway::cli
