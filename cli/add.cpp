#include "fit/add.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "cli/commands.h"
#include "cli/open_input.h"
#include "cli/report_flag.h"
#include "cli/text_table.h"
#include "fit/free_parameters.h"
#include "fit/quantity.h"
#include "io/diagnosis_results.h"
#include "io/error.h"
#include "io/output_file.h"
#include "io/report.h"

namespace raceway::cli {
namespace {

struct Flags {
  std::vector<std::string> model_and_effects;
  std::string data, output;
  bool json = false, force = false;
  ReportFlag report;
};

void print(const fit::AddResult& r) {
  const fit::QuantityText quantity = fit::text_of(r.before.quantity);
  const std::string unit(quantity.unit);
  TextTable parameters(
      {{"parameter", "", true}, {"value", ""}, {"std error", ""}, {"unit", "", true}});
  for (const fit::FittedParameter& p : r.calibration.parameters)
    parameters.add({p.name, number(p.value), number(p.std, 2), p.unit == "1" ? "-" : p.unit});
  TextTable errors({{"RMS error", "", true}, {"before", unit}, {"after", unit}});
  const auto row = [&](const std::string& what, double before, double after) {
    errors.add({what, number(before / quantity.factor), number(after / quantity.factor)});
  };
  row("on the rows it was fitted to", r.before.rmse, r.after.rmse);
  for (const fit::HoldOut& h : r.hold_out)
    row("on rows left out by " + h.variable, h.rmse_before, h.rmse_after);
  fmt::print("{}\n{}\n{}\n", parameters.text(terminal_width()), errors.text(terminal_width()),
             r.after.statement);
}

/// The user's text with the new values and effects. An effect of the user's own stands there
/// already, with a size of zero, and keeps its place.
std::string new_text(const io::ModelFile& file, const fit::Model& fitted) {
  std::string text = file.text;
  std::map<std::string, fit::ModelParameter> written;
  for (const fit::ModelParameter& p : fit::model_parameters(file.model)) written.emplace(p.name, p);
  for (const effects::Effect& e : fitted.effects)
    if (std::none_of(
            file.model.effects.begin(), file.model.effects.end(),
            [&](const effects::Effect& old) { return old.description->id == e.description->id; }))
      text = io::with_effect(text, e);
  std::vector<io::KeyValue> changes;
  for (const fit::ModelParameter& p : fit::model_parameters(fitted)) {
    const auto old = written.find(p.name);
    if (old != written.end() && p.get(fitted) != old->second.get(file.model))
      changes.push_back({io::file_key(old->second), p.get(fitted)});
  }
  return io::with_values(text, changes);
}

int run(const Flags& flags) {
  const auto if_exists = flags.force ? io::IfExists::replace : io::IfExists::refuse;
  if (!flags.output.empty()) io::require_writable(flags.output, if_exists);
  flags.report.check(flags.force);
  const std::string& path = flags.model_and_effects.front();
  const std::vector<std::string> ids(flags.model_and_effects.begin() + 1,
                                     flags.model_and_effects.end());
  const io::ModelFile file = open_model(path, Subject::bearing_or_shaft);
  const fit::DataSet data = open_data(flags.data, file.model);
  const fit::AddResult result = [&] {
    try {
      return fit::add(file.model, ids, data);
    } catch (const std::invalid_argument& e) {
      refuse_data(path, data, e);
    }
  }();
  if (flags.json) {
    fmt::print("{}", io::add_json(path, data, result));
  } else {
    print(result);
  }
  tell(result.messages);
  flags.report.write([&] { return io::add_report(path, data, result); }, flags.force);
  if (!result.calibration.converged()) {
    say("raceway add: the fit did not converge; nothing is written");
    return not_converged;
  }
  if (result.refused && !flags.force) {
    say(fmt::format("raceway add: refused: {} (--force adds it all the same)", result.reason));
    return wrong_input;
  }
  if (!flags.output.empty()) {
    io::write_text(flags.output, new_text(file, result.calibration.model), if_exists);
    say(flags.output + " written");
  }
  return done;
}

}  // namespace

Run setup_add(CLI::App& command) {
  auto flags = std::make_shared<Flags>();
  command
      .add_option("MODEL EFFECT...", flags->model_and_effects,
                  "model file (TOML), then the effects to switch on; see raceway effects")
      ->required()
      ->expected(2, 100)
      ->type_name("");
  command.add_option("--data", flags->data, "measurements (CSV)")->required()->type_name("FILE");
  command
      .add_option("-o,--output", flags->output,
                  "model file to write: MODEL with the effects and the new values")
      ->type_name("FILE");
  command.add_flag("--force", flags->force,
                   "add an effect that does not help, and replace the file if it exists");
  command.add_flag("--json", flags->json, "one JSON document instead of text");
  flags->report.declare(command);
  command.footer("Example:\n  raceway add my.toml lubricant-drag --data rig.csv -o better.toml");
  return [flags] { return run(*flags); };
}

}  // namespace raceway::cli
