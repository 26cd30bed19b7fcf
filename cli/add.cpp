#include "fit/add.h"

#include <fmt/core.h>

#include <functional>
#include <utility>

#include "cli/commands.h"
#include "cli/error_text.h"
#include "cli/fitted_models.h"
#include "cli/messages.h"
#include "cli/report_flag.h"
#include "cli/shared_flags.h"
#include "cli/text_table.h"
#include "io/diagnosis_results.h"
#include "io/error.h"
#include "io/output_file.h"
#include "session/correction_loop.h"
#include "session/loop_question.h"
#include "session/open_input.h"

namespace raceway::cli {
namespace {

struct AddFlags {
  std::vector<std::string> names;  // model, effects, further data
  std::string data, output;
  session::LoopOptions loop;
  bool json = false, force = false;
  ReportFlag report;
};

void print_parameters(const std::vector<fit::Parameter>& parameters) {
  TextTable table({{"parameter", "", true}, {"value", ""}, {"std error", ""}, {"unit", "", true}});
  for (const fit::Parameter& p : parameters)
    table.add({p.name, number(p.value), number(p.std, 2), p.unit == "1" ? "-" : p.unit});
  fmt::print("{}\n", table.text(terminal_width()));
}

/// `channel`: which of the measured ones.
void print_errors(const fit::AddResult& r, std::size_t channel) {
  const fit::ChannelGain& gain = r.channels[channel];
  const record::Channel& of = gain.channel();
  const std::string unit = error_unit(of);
  TextTable errors(
      {{r.channels.size() > 1 ? fmt::format("RMS error of {}", of.words) : "RMS error", "", true},
       {"before", unit},
       {"after", unit}});
  const auto row = [&](const std::string& what, double before, double after) {
    errors.add({what, error_text(before, of), error_text(after, of)});
  };
  row("on the rows it was fitted to", gain.before.rmse, gain.after.rmse);
  for (const fit::HoldOut& h : r.hold_out)
    row("on rows left out by " + h.variable, h.rmse_before[channel], h.rmse_after[channel]);
  fmt::print("{}\n{}\n", errors.text(terminal_width()), gain.after.statement);
}

void print(const fit::AddResult& r) {
  print_parameters(r.calibration.parameters);
  for (std::size_t k = 0; k < r.channels.size(); ++k) {
    if (k > 0) fmt::print("\n");
    print_errors(r, k);
  }
}

fit::AddResult added(const fit::Subject& subject, const std::vector<std::string>& ids,
                     const record::Record& data, const std::string& model) {
  try {
    return fit::add(subject, ids, data);
  } catch (const std::invalid_argument& e) {
    session::refuse_data(model, data, e);
  }
}

/// What the effects bought, and `write` where they are kept.
int finish(const AddFlags& flags, const std::string& source, fit::AddResult result,
           const record::Record& data,
           const std::function<std::string(const fit::AddResult&)>& page,
           const std::function<void(const fit::Calibration&)>& write) {
  session::tell_of_scale(data, result.messages);
  if (flags.json) {
    put_document(io::add_json(source, data, result));
  } else {
    print(result);
  }
  warn(result.messages);
  flags.report.write([&] { return page(result); }, flags.force);
  if (!result.calibration.converged()) {
    complain("raceway add: the fit did not converge; nothing is written");
    return not_converged;
  }
  if (result.refused && !flags.force) {
    complain(fmt::format("raceway add: refused: {} (--force adds it all the same)", result.reason));
    return wrong_input;
  }
  write(result.calibration);
  return done;
}

int run_correction(const AddFlags& flags, const std::vector<std::string>& ids,
                   const std::vector<std::string>& files) {
  const session::CorrectionLoop asked = session::ask_correction_loop(
      messages(), flags.names.front(), session::files(files), flags.loop);
  return finish(
      flags, asked.file.source,
      added(*asked.subject, session::meant(asked, ids), asked.data, asked.file.source), asked.data,
      [&](const fit::AddResult& r) { return session::add_page(asked, r); },
      [&](const fit::Calibration& c) {
        write_model(flags.output, session::fitted_text(asked, c), flags.force);
      });
}

int run(const AddFlags& flags) {
  const auto if_exists = flags.force ? io::IfExists::replace : io::IfExists::refuse;
  if (!flags.output.empty() && flags.loop.per_record.names.empty())
    io::require_writable(flags.output, if_exists);
  flags.report.check(flags.force);
  const std::string& path = flags.names.front();
  std::vector<std::string> ids, files{flags.data};
  for (std::size_t k = 1; k < flags.names.size(); ++k)
    (flags.names[k].ends_with(".csv") ? files : ids).push_back(flags.names[k]);
  if (ids.empty())
    throw io::InputError(
        "raceway add: EFFECT is missing: it comes behind MODEL; see raceway effects",
        {.key = "EFFECT"});
  if (io::takes_correction(path, files)) return run_correction(flags, ids, files);
  const session::LoopQuestion asked =
      session::ask(messages(), path, session::files(files), flags.loop);
  const FittedModels output(flags.output, if_exists);
  output.require_writable(*asked.subject);
  return finish(
      flags, asked.file.source, added(*asked.subject, ids, asked.data, path), asked.data,
      [&](const fit::AddResult& r) { return session::add_page(asked, r); },
      [&](const fit::Calibration& c) { output.write(asked.file, c); });
}

}  // namespace

Run setup_add(CLI::App& command) {
  auto flags = std::make_shared<AddFlags>();
  command
      .add_option("MODEL EFFECT...", flags->names,
                  "model file (TOML), then the effects to switch on; see raceway effects")
      ->required()
      ->expected(2, 100)
      ->type_name("");
  command
      .add_option("--data", flags->data,
                  "measurements (CSV), one file or more: --data monday.csv friday.csv")
      ->required()
      ->type_name("FILE");
  command
      .add_option("-o,--output", flags->output,
                  "model file to write: MODEL with the effects and the new values;\n"
                  "with --per-record one for each record, FILE-RECORD.toml of FILE.toml")
      ->type_name("FILE");
  declare_displacement(command, flags->loop.displacement);
  declare(command, flags->loop.per_record);
  declare(command, flags->loop.reading);
  declare(command, flags->loop.reading.period);
  declare(command, flags->loop.tolerance);
  command.add_flag("--force", flags->force,
                   "add an effect that does not help, and replace the file if it exists");
  command.add_flag("--json", flags->json, "one JSON document instead of text");
  flags->report.declare(command);
  command.footer(
      "Example:\n  raceway add my.toml lubricant-drag --data rig.csv -o better.toml\n"
      "  raceway add my.toml windage --data monday.csv friday.csv --per-record f0,z -o "
      "better.toml");
  return [flags] { return run(*flags); };
}

}  // namespace raceway::cli
