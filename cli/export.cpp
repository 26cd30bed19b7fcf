#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <memory>
#include <string>
#include <utility>

#include "cli/commands.h"
#include "cli/output_flags.h"
#include "cli/run_files.h"
#include "cli/shared_flags.h"
#include "correction/trust.h"
#include "session/control_export.h"
#include "text/error.h"

namespace raceway::cli {
namespace {

struct ExportFlags : OutputFlags {
  std::string model, format, record;
  session::Reading reading;
  bool accept_untrusted = false;
};

int run(const ExportFlags& flags) {
  const bool with_hal = flags.to_file() && flags.format == "linuxcnc";
  const session::HalFiles hal = session::hal_files(flags.output);
  session::require_control_name(flags.format, flags.output);
  flags.require_writable();
  for (const std::string& file : {hal.start, hal.shutdown})
    if (with_hal) text::require_writable(file, flags.if_exists());
  const session::Reading& how = flags.reading;
  if (flags.record.empty() && (!how.columns.empty() || !how.beside.empty() || how.drop_nan))
    throw text::InputError("raceway export: --columns, --beside and --drop-nan need --record",
                           {.key = "--record"});
  if (!flags.record.empty()) add_input(flags.record);
  const session::Source record(flags.record);
  control::ControlPlan wanted = session::open_plan(
      messages(), flags.model, flags.record.empty() ? nullptr : &record, flags.reading);
  if (!flags.accept_untrusted) session::require_trust(wanted);
  const auto [plan, text, hal_start, hal_shutdown] =
      session::export_plan(std::move(wanted), flags.format, flags.output);
  if (flags.to_file()) {
    std::vector<text::OutputFile> files{{flags.output, text}};
    if (with_hal) {
      files.push_back({hal.start, hal_start});
      files.push_back({hal.shutdown, hal_shutdown});
    }
    text::write_files(files, flags.if_exists());
    std::size_t parts = 0;
    for (const control::ControlAxis& a : plan.axes)
      parts += a.sections.size() + a.elements.size() + a.feedthroughs.size() + a.equations.size() +
               a.kinematics.size();
    say(fmt::format("{} written: {} displacement{} with {} term{} from {} input{}", flags.output,
                    plan.axes.size(), plan.axes.size() == 1 ? "" : "s", parts,
                    parts == 1 ? "" : "s", plan.inputs.size(), plan.inputs.size() == 1 ? "" : "s"));
    if (with_hal) say(fmt::format("{} and {} written", hal.start, hal.shutdown));
  } else {
    fmt::print("{}", text);
  }
  tell(plan.notes);
  warn(plan.warnings);
  for (const control::ControlAxis& axis : plan.axes) {
    if (axis.trust.empty()) continue;
    const std::string line = fmt::format("trust in {}: {}", axis.column, control::trust_line(axis));
    if (axis.trust == correction::name(correction::TrustLevel::good))
      tell({line});
    else
      warn(line);
  }
  return done;
}

}  // namespace

Run setup_export(CLI::App& command) {
  auto flags = std::make_shared<ExportFlags>();
  command
      .add_option("MODEL", flags->model,
                  "model file (TOML) with [correction], or a table that\n"
                  "--format csv wrote")
      ->required()
      ->type_name("");
  command
      .add_option("--format", flags->format,
                  "python (one file, standard library only), c (one C99 header in double or "
                  "float precision, needs only math.h), csv (table of numbers with units), "
                  "linuxcnc (HAL component in "
                  "Python, and its HAL files)")
      ->required()
      ->check(CLI::IsMember({"python", "c", "csv", "linuxcnc"}))
      ->type_name("NAME");
  command
      .add_option("--record", flags->record,
                  "record over time (CSV) that is stored in the file for the self-check; default: "
                  "an artificial record within the ranges of the model")
      ->type_name("RECORD");
  declare(command, flags->reading);
  declare_beside(command, flags->reading);
  flags->declare_output(command, "file to write; default: stdout");
  command.add_flag("--accept-untrusted", flags->accept_untrusted,
                   "export the correction even if raceway rates it \"do not use\"");
  flags->declare_force(command);
  command.footer(
      "Example:\n  raceway export z.toml --format python -o correction.py\n"
      "  raceway export z.toml --format c -o correction.h\n"
      "  raceway export z.toml --format linuxcnc -o thermal.py\n"
      "  python3 correction.py --check");
  return [flags] { return run(*flags); };
}

}  // namespace raceway::cli
