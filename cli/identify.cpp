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

/// Validates the found models on a record that they did not see, and judges them by it from then
/// on.
std::vector<results::Validation> validated(std::vector<correction::Identification>& found,
                                           const IdentifyFlags& flags,
                                           const files::CorrectionFile& file) {
  std::vector<results::Validation> list;
  if (flags.validate.empty()) return list;
  const record::Record other = session::open_series(
      messages(), flags.validate, session::models_of(found), flags.reading.options(file.columns));
  for (correction::Identification& one_found : found) {
    correction::Model& model = one_found.model;
    const session::Validated one = session::validated(model, other);
    list.push_back(one.validation);
    session::judge_by(model, one.validation);
    const correction::Metrics& m = one.validation.metrics;
    if (!flags.json)
      fmt::print("on {}: {} RMS {} {unit}, largest {} {unit}, fit {} %\n", other.source,
                 model.displacement->name, number(m.rms / um, 3), number(m.max_abs / um, 3),
                 number(m.fit_percent, 3), fmt::arg("unit", model.displacement->unit));
    if (!flags.json) print_more_errors(*model.displacement, m);
    tell(one.warnings);
  }
  return list;
}

/// Shows what it is worth, and writes it as transfer functions where it is asked to.
int run_arx(const IdentifyFlags& flags) {
  const session::SeriesQuestion asked =
      session::ask_series(messages(), flags.model, flags.data, flags.reading);
  std::vector<std::pair<const record::Channel*, correction::ArxBaseline>> found;
  for (const correction::Model& model : asked.file.models) {
    found.emplace_back(model.displacement, session::arx_baseline(asked, model, flags.choices));
    if (!flags.json) print_baseline(*model.displacement, found.back().second, asked.data);
    tell(found.back().second.messages);
  }
  if (flags.json) put_document(results::arx_json(asked.file.source, asked.data, found));
  if (!flags.output.empty()) {
    const session::ArxText written = session::arx_text(asked, found);
    flags.put_model(written.text, asked.file.files);
    tell(written.notes);
  }
  return done;
}

/// With Ctrl-C and a bar while it lasts.
correction::Identification identified(const IdentifyFlags& flags, session::SeriesQuestion& asked,
                                      const correction::Model& model) {
  session::IdentifyChoices choices = flags.choices;
  constexpr double longest_wait = 3600.0;
  const InterruptFlag interrupt(longest_wait);
  choices.cancelled = [] { return InterruptFlag::raised().load(); };
  std::optional<Progress> bar;
  if (shows_progress()) {
    bar.emplace();
    choices.progress = [&bar](double share, std::string_view step) { bar->show(share, step); };
  }
  return session::identified(messages(), asked, model, choices);
}

int run(const IdentifyFlags& flags) {
  flags.refuse_stdout("identify", "the numbers");
  flags.require_writable();
  flags.choices.check();
  if (flags.choices.baseline == "arx") return run_arx(flags);
  session::SeriesQuestion asked =
      session::ask_series(messages(), flags.model, flags.data, flags.reading);
  std::vector<correction::Identification> found;
  for (const correction::Model& model : asked.file.models) {
    found.push_back(identified(flags, asked, model));
    if (!flags.json) {
      if (found.size() > 1) fmt::print("\n");
      print_identification(found.back(), asked.data);
    }
    tell(found.back().messages);
  }
  const std::vector<results::Validation> validations = validated(found, flags, asked.file);
  if (!flags.json)
    for (const correction::Identification& one : found)
      print_trust(*one.model.displacement, correction::trust_of(one.model));
  if (flags.json)
    put_document(results::identification_json(asked.file.source, asked.data, found, validations));
  if (!flags.output.empty())
    flags.put_model(session::identified_text(asked, session::models_of(found), flags.choices),
                    asked.file.files);
  return done;
}

}  // namespace

Run setup_identify(CLI::App& command) {
  auto flags = std::make_shared<IdentifyFlags>();
  command
      .add_option("MODEL", flags->model,
                  "model file (TOML) with [correction]; its gains and time constants are hints")
      ->required()
      ->type_name("");
  command.add_option("RECORD", flags->data, "record over time (CSV)")->required()->type_name("");
  command
      .add_option("--order", flags->choices.order,
                  "sections of each channel, as 2 or 1:3; chosen by the error on parts of the\n"
                  "record that no fit saw; default 1:3")
      ->type_name("N");
  command
      .add_option("--inputs", flags->choices.inputs,
                  "columns that may drive channels of their own (by comma), or all: taken up\n"
                  "as long as the error on parts held out falls")
      ->delimiter(',')
      ->allow_extra_args(false)
      ->type_name("COLUMNS");
  command
      .add_option("--lags", flags->choices.lags,
                  "every input through each of these lags (s, by comma, 0: at once; auto: by the\n"
                  "length of the record), gains by ridge, its strength by the error ahead: for\n"
                  "machines with many sensors; --inputs are all without more")
      ->delimiter(',')
      ->allow_extra_args(false)
      ->type_name("S,...")
      ->excludes("--order");
  command
      .add_option("--baseline", flags->choices.baseline,
                  "instead of sections: regression, on the inputs as they are; arx, transfer\n"
                  "functions by least squares of one step, shown next to their simulation")
      ->check(CLI::IsMember({"regression", "arx"}))
      ->excludes("--lags")
      ->type_name("WHICH");
  command.add_option("--validate", flags->validate, "another record, to judge the model by")
      ->type_name("RECORD2");
  flags->declare_output(command,
                        "model file to write: MODEL with the new sections, numbers and range");
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
