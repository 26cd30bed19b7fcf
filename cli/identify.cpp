#include "correction/identify.h"

#include <fmt/format.h>

#include <optional>

#include "cli/commands.h"
#include "cli/identification_text.h"
#include "cli/output_flags.h"
#include "cli/process.h"
#include "cli/progress.h"
#include "cli/text_table.h"
#include "correction/baseline.h"
#include "results/correction_results.h"
#include "session/correction_input.h"
#include "session/identification.h"

namespace raceway::cli {
namespace {

struct IdentifyFlags : OutputFlags {
  std::string model, data, validate;
  session::IdentifyChoices choices;
  session::Reading reading;
  bool json = false;
};

/// Shows the errors on a record that the models did not see.
void print_validation(const session::Identified& found) {
  for (std::size_t k = 0; k < found.validations.size(); ++k) {
    const record::Channel& displacement = *found.found[k].model.displacement;
    const correction::Metrics& m = found.validations[k].metrics;
    fmt::print(
        "{} on {}: RMS error {} {unit}, largest error {} {unit}, fit {} % (100 %: no error)\n",
        displacement.name, found.validations[k].data, number(m.rms / um, 3),
        number(m.max_abs / um, 3), number(m.fit_percent, 3), fmt::arg("unit", displacement.unit));
    print_more_errors(displacement, m);
  }
}

int run_arx(const IdentifyFlags& flags, session::SeriesQuestion asked) {
  const session::ArxModels models = session::identify_arx(std::move(asked), flags.choices);
  for (const auto& [displacement, baseline] : models.found) {
    if (!flags.json) print_baseline(*displacement, baseline, models.asked.data);
    tell(baseline.messages);
  }
  if (flags.json) put_document(models.json());
  if (!flags.output.empty()) {
    const session::ArxModels::Text written = models.text();
    flags.put_model(written.text, models.asked.file.files);
    tell(written.notes);
  }
  return done;
}

/// With Ctrl-C and a bar while it lasts.
session::Identified identified(const IdentifyFlags& flags, session::SeriesQuestion asked) {
  session::IdentifyChoices choices = flags.choices;
  constexpr double longest_wait = 3600.0;
  const InterruptFlag interrupt(longest_wait);
  choices.cancelled = [] { return InterruptFlag::raised().load(); };
  std::optional<Progress> bar;
  if (shows_progress()) {
    bar.emplace();
    choices.progress = [&bar](double share, std::string_view step) { bar->show(share, step); };
  }
  return session::identify(messages(), std::move(asked), choices);
}

int run(const IdentifyFlags& flags) {
  flags.refuse_stdout("identify", "the results");
  flags.require_writable();
  flags.choices.check();
  session::SeriesQuestion asked =
      session::ask_series(messages(), flags.model, flags.data, flags.reading);
  if (flags.choices.baseline == "arx") return run_arx(flags, std::move(asked));
  session::Identified found = identified(flags, std::move(asked));
  for (const correction::Identification& one : found.found) {
    if (!flags.json) {
      if (&one != &found.found.front()) fmt::print("\n");
      print_identification(one, found.asked.data);
    }
    tell(one.messages);
  }
  if (!flags.validate.empty()) found.validate(messages(), flags.validate, flags.reading);
  if (!flags.json) print_validation(found);
  tell(found.validation_warnings);
  if (flags.json)
    put_document(found.json());
  else
    for (const correction::Identification& one : found.found)
      print_trust(*one.model.displacement, correction::trust_of(one.model));
  if (!flags.output.empty()) flags.put_model(found.text(), found.asked.file.files);
  return done;
}

}  // namespace

Run setup_identify(CLI::App& command) {
  auto flags = std::make_shared<IdentifyFlags>();
  command
      .add_option(
          "MODEL", flags->model,
          "model file (TOML) with [correction]; its gains and time constants are start values")
      ->required()
      ->type_name("");
  command.add_option("RECORD", flags->data, "record over time (CSV)")->required()->type_name("");
  command
      .add_option("--order", flags->choices.order,
                  "number of sections (lags) of each channel, such as 2, or a range such as 1:3, "
                  "from which the program chooses by the held-out error; default 1:3")
      ->type_name("N");
  command
      .add_option(
          "--inputs", flags->choices.inputs,
          "columns that may become channels, separated by commas, or all; the program adds only "
          "columns that reduce the held-out error; with --lags or --baseline, it adds all of them")
      ->delimiter(',')
      ->allow_extra_args(false)
      ->type_name("COLUMNS");
  command
      .add_option("--lags", flags->choices.lags,
                  "bank of lags for machines with many sensors: time constants in s, separated by "
                  "commas; 0 means no lag; auto chooses them from the length of the record. Ridge "
                  "regression fits the gains. With --lags, the default of --inputs is all")
      ->delimiter(',')
      ->allow_extra_args(false)
      ->type_name("S,...")
      ->excludes("--order");
  command
      .add_option("--baseline", flags->choices.baseline,
                  "method instead of sections: regression (multiple linear regression on the "
                  "inputs) or arx (transfer functions that predict one step ahead; the errors of "
                  "their simulation are also printed)")
      ->check(CLI::IsMember({"regression", "arx"}))
      ->excludes("--lags")
      ->type_name("WHICH");
  command.add_option("--validate", flags->validate, "second record (CSV) to test the model")
      ->type_name("RECORD2");
  flags->declare_output(command,
                        "model file to write: MODEL with the new sections, parameters and range");
  declare(command, flags->reading);
  declare_beside(command, flags->reading);
  declare(command, flags->reading.period);
  flags->declare_force(command);
  declare_json(command, flags->json);
  command.footer(
      "Example:\n  raceway identify z.toml monday.csv --validate friday.csv -o found.toml\n"
      "  raceway identify z.toml monday.csv --baseline regression -o regression.toml");
  return [flags] { return run(*flags); };
}

}  // namespace raceway::cli
