#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <filesystem>
#include <memory>
#include <string>

#include "cli/commands.h"
#include "cli/messages.h"
#include "cli/run_files.h"
#include "io/error.h"
#include "io/output_file.h"
#include "session/control_export.h"
#include "session/correction_input.h"

namespace raceway::cli {
namespace {

struct ExportFlags {
  std::string model, format, output;
  bool force = false;
};

int run(const ExportFlags& flags) {
  const bool to_file = !flags.output.empty() && flags.output != "-";
  const auto if_exists = flags.force ? io::IfExists::replace : io::IfExists::refuse;
  if (to_file) io::require_writable(flags.output, if_exists);
  session::require_control_name(flags.format, flags.output);
  const io::CorrectionFile file = session::open_corrections(messages(), flags.model);
  const auto [plan, text] = session::export_corrections(file, flags.format, flags.output);
  const std::filesystem::path folder = std::filesystem::path(flags.model).parent_path();
  for (const io::ControlTable& t : plan.tables) add_input((folder / t.file).string());
  if (to_file) {
    io::write_text(flags.output, text, if_exists);
    std::size_t parts = 0;
    for (const io::ControlAxis& a : plan.axes)
      parts += a.sections.size() + a.elements.size() + a.feedthroughs.size() + a.kinematics.size();
    say(fmt::format("{} written: {} displacement{} of {} part{} from {} input{}", flags.output,
                    plan.axes.size(), plan.axes.size() == 1 ? "" : "s", parts,
                    parts == 1 ? "" : "s", plan.inputs.size(), plan.inputs.size() == 1 ? "" : "s"));
  } else {
    fmt::print("{}", text);
  }
  tell(plan.notes);
  return done;
}

}  // namespace

Run setup_export(CLI::App& command) {
  auto flags = std::make_shared<ExportFlags>();
  command.add_option("MODEL", flags->model, "model file (TOML) with [correction]")
      ->required()
      ->type_name("");
  command
      .add_option("--format", flags->format,
                  "python (one file, standard library alone), c (one header of C99,\n"
                  "math.h alone, double or float), csv (a table of numbers with units),\n"
                  "linuxcnc (a component of HAL, for halcompile)")
      ->required()
      ->check(CLI::IsMember({"python", "c", "csv", "linuxcnc"}))
      ->type_name("NAME");
  command.add_option("-o,--output", flags->output, "file to write; stdout without it")
      ->type_name("FILE");
  command.add_flag("--force", flags->force, "replace the file if it exists");
  command.footer(
      "Example:\n  raceway export z.toml --format python -o correction.py\n"
      "  raceway export z.toml --format c -o correction.h\n"
      "  raceway export z.toml --format linuxcnc -o thermal.comp");
  return [flags] { return run(*flags); };
}

}  // namespace raceway::cli
