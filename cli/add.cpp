#include "verdict/add.h"

#include <fmt/core.h>

#include "cli/commands.h"
#include "cli/error_text.h"
#include "cli/fitted_models.h"
#include "cli/output_flags.h"
#include "cli/text_table.h"
#include "session/loop.h"
#include "text/error.h"

namespace raceway::cli {
namespace {

struct AddFlags : OutputFlags {
  std::vector<std::string> names;  // model, effects, further data
  std::string data;
  session::LoopOptions loop;
  bool json = false;
  ReportFlag report;
};

void print_parameters(const std::vector<fit::Parameter>& parameters) {
  TextTable table({{"parameter", "", true}, {"value", ""}, {"std error", ""}, {"unit", "", true}});
  for (const fit::Parameter& p : parameters)
    table.add({p.name, number(p.value), number(p.std, 2), p.unit == "1" ? "-" : p.unit});
  fmt::print("{}\n", table.text(terminal_width()));
}

/// `channel`: which of the measured ones.
void print_errors(const verdict::AddResult& r, std::size_t channel) {
  const verdict::ChannelGain& gain = r.channels[channel];
  const record::Channel& of = gain.channel();
  const std::string unit = error_unit(of);
  TextTable errors(
      {{r.channels.size() > 1 ? fmt::format("RMS error of {}", of.words) : "RMS error", "", true},
       {"before", unit},
       {"after", unit}});
  const auto row = [&](const std::string& what, double before, double after) {
    errors.add({what, error_text(before, of), error_text(after, of)});
  };
  row("on the rows of the fit", gain.before.rmse, gain.after.rmse);
  for (const fit::HoldOut& h : r.hold_out)
    row("on rows held out by " + h.variable, h.rmse_before[channel], h.rmse_after[channel]);
  fmt::print("{}\n{}\n", errors.text(terminal_width()), gain.after.statement);
}

void print(const verdict::AddResult& r) {
  print_parameters(r.calibration.parameters);
  for (std::size_t k = 0; k < r.channels.size(); ++k) {
    if (k > 0) fmt::print("\n");
    print_errors(r, k);
  }
}

int run(const AddFlags& flags) {
  if (flags.loop.per_record.empty()) flags.require_writable();
  flags.report.check(flags.if_exists());
  std::vector<std::string> ids, files{flags.data};
  for (std::size_t k = 1; k < flags.names.size(); ++k)
    (flags.names[k].ends_with(".csv") ? files : ids).push_back(flags.names[k]);
  if (ids.empty())
    throw text::InputError(
        "raceway add: EFFECT is missing; name it after MODEL (raceway effects lists the effects)",
        {.key = "EFFECT"});
  const session::LoopQuestion asked =
      session::ask(messages(), flags.names.front(), session::files(files), flags.loop);
  const FittedModels output(flags);
  output.require_writable(*asked.subject);
  const verdict::AddResult result = session::add(asked, ids);
  if (flags.json) {
    put_document(session::json(asked, result));
  } else {
    print(result);
  }
  tell(result.messages);
  flags.report.write([&] { return session::page(asked, result); }, flags.if_exists());
  if (!result.calibration.converged()) {
    complain("raceway add: the fit did not converge, so no file is written");
    return not_converged;
  }
  if (result.refused && !flags.force) {
    complain(fmt::format(
        "raceway add: no effect was added: {} (use --force to add the effect nevertheless)",
        result.reason));
    return wrong_input;
  }
  if (result.refused && !output.existing(*asked.subject).empty()) {
    complain(fmt::format(
        "raceway add: {} is not replaced, because the effect was refused: {} (to add the effect "
        "nevertheless, write another file)",
        output.existing(*asked.subject), result.reason));
    return wrong_input;
  }
  output.write(asked, result.calibration);
  return done;
}

}  // namespace

Run setup_add(CLI::App& command) {
  auto flags = std::make_shared<AddFlags>();
  command
      .add_option(
          "MODEL EFFECT...", flags->names,
          "model file (TOML), then the effects to add (see raceway effects). law:skf replaces the "
          "base law by the law skf; shape adds the power law that diagnose finds")
      ->required()
      ->expected(2, 100)
      ->type_name("");
  command
      .add_option("--data", flags->data,
                  "measurements (CSV), one or more files: --data monday.csv friday.csv")
      ->required()
      ->type_name("FILE");
  flags->declare_output(command,
                        "model file to write: MODEL with the effects and the fitted values; with "
                        "--per-record, one file for each record, named FILE-RECORD.toml");
  declare(command, flags->loop);
  declare(command, flags->loop.tolerance);
  flags->declare_force(
      command,
      "replace the file if it exists, or add an effect that the data do not confirm to a new file");
  declare_json(command, flags->json);
  flags->report.declare(command);
  command.footer(
      "Example:\n  raceway add my.toml lubricant-drag --data rig.csv -o better.toml\n"
      "  raceway add my.toml windage --data monday.csv friday.csv --per-record f0,z -o "
      "better.toml");
  return [flags] { return run(*flags); };
}

}  // namespace raceway::cli
