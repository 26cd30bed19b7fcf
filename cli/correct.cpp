#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "cli/commands.h"
#include "cli/correct_learn.h"
#include "cli/identification_text.h"
#include "cli/output_flags.h"
#include "cli/text_table.h"
#include "results/correction_results.h"
#include "session/correction_run.h"

namespace raceway::cli {
namespace {

struct CorrectFlags : ResultFlags {
  std::string model, data;
  session::Reading reading;
  LearnFlags learning;
};

/// How far off the predictions may be, and where more so.
void print_band(const results::Corrected& c, const record::Record& record) {
  if (c.band.empty()) return;
  const auto widest = std::max_element(
      c.band.begin(), c.band.end(), [](double a, double b) { return !(a >= b) && !std::isnan(b); });
  const auto least = std::min_element(c.band.begin(), c.band.end(),
                                      [](double a, double b) { return a < b && !std::isnan(a); });
  fmt::print("95 % band of {}: smallest half width {} {unit}, largest {} {unit} at {:.4g} s",
             c.displacement->name, number(*least / um, 3), number(*widest / um, 3),
             record.value(record::time, static_cast<std::size_t>(widest - c.band.begin())),
             fmt::arg("unit", c.displacement->unit));
  if (std::isfinite(c.readings_in_band))
    fmt::print("; {:.1f} % of the readings lie in the band{}", 100.0 * c.readings_in_band,
               std::isfinite(c.noise) ? fmt::format(" (widened by the noise of {} {})",
                                                    number(c.noise / um, 2), c.displacement->unit)
                                      : "");
  fmt::print("\n");
}

void print(const std::vector<results::Corrected>& list, const record::Record& record) {
  const CommonUnit unit(list);
  TextTable table({{"displacement", "", true},
                   {"predicted from", unit.head()},
                   {"to", unit.head()},
                   {"readings", ""},
                   {"RMS", unit.head()},
                   {"largest", unit.head()},
                   {"fit", "%"}});
  for (const results::Corrected& c : list) {
    const auto [low, high] = std::minmax_element(c.predicted.begin(), c.predicted.end());
    table.add({std::string(c.displacement->name), unit.text(c, *low, 4), unit.text(c, *high, 4),
               fmt::format("{}", c.metrics.readings), unit.text(c, c.metrics.rms, 3),
               unit.text(c, c.metrics.max_abs, 3), number(c.metrics.fit_percent, 3)});
  }
  fmt::print("{}: {} rows over {:.4g} h\n\n{}", record.source, record.rows(),
             (record.values(record::time).back() - record.values(record::time).front()) / 3600.0,
             table.text(terminal_width()));
  fmt::print(
      "RMS and largest: errors at the readings, after the mean error of each run is subtracted\n");
  for (const results::Corrected& c : list) print_more_errors(*c.displacement, c.metrics);
  for (const results::Corrected& c : list) print_band(c, record);
  for (const results::Corrected& c : list) print_trust(*c.displacement, c.trust);
}

int run(const CorrectFlags& flags) {
  flags.check_results("correct");
  flags.learning.check(flags.if_exists());
  session::Reading reading = flags.reading;
  reading.one_by_one = flags.learning.learn;
  reading.without_readings = !flags.learning.learn;
  session::SeriesQuestion asked = session::ask_series(messages(), flags.model, flags.data, reading);
  if (flags.learning.learn) {
    run_learning(std::move(asked), flags.learning, flags);
    return done;
  }
  const session::CorrectionRun run = session::correct(std::move(asked));
  flags.put_table([&] { return run.csv(); }, fmt::format(", {} rows", run.asked.data.rows()));
  if (flags.json)
    put_document(run.json());
  else if (flags.output != "-")
    print(run.corrected, run.asked.data);
  tell(run.warnings);
  flags.put_page([&] { return run.page(); });
  return done;
}

}  // namespace

Run setup_correct(CLI::App& command) {
  auto flags = std::make_shared<CorrectFlags>();
  declare_model(command, flags->model, "[correction]");
  command
      .add_option("RECORD", flags->data,
                  "record over time (CSV); cells of the displacement may be empty")
      ->required()
      ->type_name("");
  flags->declare_output(
      command,
      "CSV file to write, - for stdout. Columns: time_s, predicted_um, band_low_um and "
      "band_high_um (95 %, for a fitted model), the contribution of each channel, residual_um "
      "(urad for an angle); with several displacements, the columns are predicted_COLUMN, "
      "CHANNEL_COLUMN and residual_COLUMN");
  flags->learning.declare(command);
  declare(command, flags->reading);
  declare_beside(command, flags->reading);
  declare(command, flags->reading.period);
  flags->declare_results(command);
  command.footer(
      "Examples:\n  raceway correct z.toml monday.csv -o corrected.csv\n"
      "  raceway correct z.toml monday.csv --learn --every 4h --save tuesday.toml");
  return [flags] { return run(*flags); };
}

}  // namespace raceway::cli
