#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "cli/commands.h"
#include "cli/correct_learn.h"
#include "cli/messages.h"
#include "cli/report_flag.h"
#include "cli/shared_flags.h"
#include "cli/text_table.h"
#include "correction/alignment.h"
#include "correction/band.h"
#include "fit/noise.h"
#include "io/correction_results.h"
#include "io/error.h"
#include "io/output_file.h"
#include "io/record_report.h"
#include "session/correction_input.h"

namespace raceway::cli {
namespace {

struct CorrectFlags {
  std::string model, data, output;
  session::Reading reading;
  LearnFlags learning;
  bool json = false, force = false;
  ReportFlag report;
};

/// Of the readings, which scatter about the displacement by `noise`; one constant taken off each
/// run.
double share_within(const std::vector<double>& band, double noise, std::span<const double> read,
                    const std::vector<double>& predicted) {
  constexpr double two_sided = 1.96;
  std::size_t readings = 0, within = 0;
  for (std::size_t k = 0; k < read.size(); ++k) {
    if (!std::isfinite(read[k]) || !std::isfinite(predicted[k])) continue;
    ++readings;
    if (std::abs(read[k] - predicted[k]) <= std::hypot(band[k], two_sided * noise)) ++within;
  }
  return readings > 0 ? static_cast<double>(within) / static_cast<double>(readings) : unset;
}

io::Corrected corrected(const correction::Model& model, const record::Record& record,
                        std::vector<std::string>& messages) {
  const auto subject = correction::aligned(model, record, correction::Zero::none);
  io::Corrected result{.displacement = model.displacement,
                       .initial_state = model.initial_state,
                       .predicted = fit::predict(*subject, record)};
  const auto series = std::make_shared<const correction::Series>(record);
  result.parts = correction::contributions(subject->model(), *series);
  result.beyond = correction::beyond_range(model, *series);
  for (std::string& note : session::range_notes(model, *series, result.beyond))
    messages.push_back(std::move(note));
  if (model.left)
    result.band = correction::band_of(*subject, model, series, result.beyond).half_width();
  if (record.has(*model.displacement)) {
    const auto zeroed = correction::aligned(model, record, correction::Zero::mean);
    const std::span<const double> read = record.values(*model.displacement);
    const std::vector<double> predicted = fit::predict(*zeroed, record);
    result.metrics = correction::metrics(read, predicted);
    result.noise = std::isfinite(model.measured_std)
                       ? model.measured_std
                       : fit::noise_of_neighbours(record, *model.displacement);
    if (model.left)
      result.readings_in_band = share_within(
          result.band, std::isfinite(result.noise) ? result.noise : 0.0, read, predicted);
  }
  const auto bad = std::find_if(result.predicted.begin(), result.predicted.end(),
                                [](double v) { return !std::isfinite(v); });
  if (bad != result.predicted.end())
    messages.push_back(
        fmt::format("{}: no displacement from {} on: the power leaves the range of a delay element",
                    model.displacement->name,
                    record.place(static_cast<std::size_t>(bad - result.predicted.begin()))));
  return result;
}

/// How far off the predictions may be, and where more so.
void print_band(const io::Corrected& c, const record::Record& record) {
  if (c.band.empty()) return;
  const auto widest = std::max_element(
      c.band.begin(), c.band.end(), [](double a, double b) { return !(a >= b) && !std::isnan(b); });
  const auto least = std::min_element(c.band.begin(), c.band.end(),
                                      [](double a, double b) { return a < b && !std::isnan(a); });
  fmt::print("95 % band of {}: +- {} um at its narrowest, +- {} um at {:.4g} s",
             c.displacement->name, number(*least / um, 3), number(*widest / um, 3),
             record.value(record::time, static_cast<std::size_t>(widest - c.band.begin())));
  if (std::isfinite(c.readings_in_band))
    fmt::print("; {:.1f} % of the readings lie in it{}", 100.0 * c.readings_in_band,
               std::isfinite(c.noise)
                   ? fmt::format(", their noise of {} um allowed for", number(c.noise / um, 2))
                   : "");
  fmt::print("\n");
}

void print(const std::vector<io::Corrected>& list, const record::Record& record) {
  TextTable table({{"displacement", "", true},
                   {"predicted from", "um"},
                   {"to", "um"},
                   {"readings", ""},
                   {"RMS", "um"},
                   {"largest", "um"},
                   {"fit", "%"}});
  for (const io::Corrected& c : list) {
    const auto [low, high] = std::minmax_element(c.predicted.begin(), c.predicted.end());
    table.add({std::string(c.displacement->name), number(*low / um, 4), number(*high / um, 4),
               fmt::format("{}", c.metrics.readings), number(c.metrics.rms / um, 3),
               number(c.metrics.max_abs / um, 3), number(c.metrics.fit_percent, 3)});
  }
  fmt::print("{}: {} rows over {:.4g} h\n\n{}", record.source, record.rows(),
             (record.values(record::time).back() - record.values(record::time).front()) / 3600.0,
             table.text(terminal_width()));
  fmt::print("RMS and largest: what is left of the readings when one constant is taken off\n");
  for (const io::Corrected& c : list) print_band(c, record);
}

/// As they were compared: with the constant that leaves least, where something was read.
std::vector<io::DrawnModel> drawn(const io::CorrectionFile& file, const record::Record& record) {
  std::vector<io::DrawnModel> list;
  for (const correction::Model& model : file.models)
    list.push_back(
        {.name = std::string(model.displacement->words),
         .subject = correction::aligned(
             model, record,
             record.has(*model.displacement) ? correction::Zero::mean : correction::Zero::none),
         .held_out = {},
         .defaults = file.defaults});
  return list;
}

int run(const CorrectFlags& flags) {
  if (flags.json && flags.output == "-")
    throw io::InputError("raceway correct: --json and --output - both write to stdout; take one",
                         {.key = "--output"});
  const bool to_file = !flags.output.empty() && flags.output != "-";
  const auto if_exists = flags.force ? io::IfExists::replace : io::IfExists::refuse;
  if (to_file) io::require_writable(flags.output, if_exists);
  flags.report.check(flags.force);
  flags.learning.check(if_exists);
  const io::CorrectionFile file = session::open_corrections(messages(), flags.model);
  const record::Record record =
      session::open_series(messages(), flags.data, file.models, flags.reading.options(file.columns),
                           flags.reading.period);
  if (flags.learning.learn) {
    run_learning(file, record, flags.learning, {flags.output, flags.json, if_exists});
    return done;
  }
  std::vector<std::string> messages;
  std::vector<io::Corrected> list;
  for (const correction::Model& model : file.models) {
    try {
      list.push_back(corrected(model, record, messages));
    } catch (const std::invalid_argument& e) {
      throw io::InputError(fmt::format("{} with {}: {}", record.source, file.source, e.what()),
                           {.file = record.source});
    }
  }
  if (!flags.output.empty()) {
    const std::string csv = io::corrected_text(record, list);
    if (to_file) {
      io::write_text(flags.output, csv, if_exists);
      say(fmt::format("{} written, {} rows", flags.output, record.rows()));
    } else {
      fmt::print("{}", csv);
    }
  }
  if (flags.json)
    put_document(io::corrected_json(file.source, record, list, messages));
  else if (flags.output != "-")
    print(list, record);
  warn(messages);
  flags.report.write(
      [&] {
        return io::record_report("correct", io::corrected_json(file.source, record, list, messages),
                                 record, drawn(file, record));
      },
      flags.force);
  return done;
}

}  // namespace

Run setup_correct(CLI::App& command) {
  auto flags = std::make_shared<CorrectFlags>();
  command.add_option("MODEL", flags->model, "model file (TOML) with [correction]")
      ->required()
      ->type_name("");
  command.add_option("RECORD", flags->data, "record over time (CSV); displacements may be empty")
      ->required()
      ->type_name("");
  command
      .add_option("-o,--output", flags->output,
                  "CSV file to write, - for stdout: time_s, predicted_um, band_low_um and\n"
                  "band_high_um (95 %, of a model that was fitted), what each channel adds,\n"
                  "residual_um; of several displacements predicted_COLUMN, residual_COLUMN")
      ->type_name("FILE");
  flags->learning.declare(command);
  declare(command, flags->reading);
  declare(command, flags->reading.period);
  flags->report.declare(command);
  command.add_flag("--force", flags->force, "replace files that exist");
  command.add_flag("--json", flags->json, "one JSON document instead of text");
  command.footer(
      "Examples:\n  raceway correct z.toml monday.csv -o corrected.csv\n"
      "  raceway correct z.toml monday.csv --learn --every 4h --save tuesday.toml");
  return [flags] { return run(*flags); };
}

}  // namespace raceway::cli
