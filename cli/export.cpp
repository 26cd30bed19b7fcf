#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <filesystem>
#include <memory>
#include <string>

#include "cli/commands.h"
#include "cli/messages.h"
#include "cli/run_files.h"
#include "io/control_files.h"
#include "io/error.h"
#include "io/output_file.h"
#include "session/correction_input.h"

namespace raceway::cli {
namespace {

struct ExportFlags {
  std::string model, format, output;
  bool force = false;
};

/// The name of the file without its end, as C and HAL have names.
std::string name_of(const std::string& output) {
  std::string name = std::filesystem::path(output).stem().string();
  if (output == "-" || output.empty()) name = "raceway_correction";
  for (char& c : name) {
    const bool letter = (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z');
    if (!letter && !(c >= '0' && c <= '9')) c = '_';
  }
  if (name.empty() || (name.front() >= '0' && name.front() <= '9') || name.front() == '_')
    name.insert(0, "correction_");
  return name;
}

/// halcompile refuses a component that is called otherwise than its file.
void require_component_name(const std::string& output, const std::string& name) {
  if (output.empty() || output == "-") return;
  const std::filesystem::path path(output);
  if (path.extension() != ".comp" || path.stem() != name)
    throw io::InputError(
        fmt::format(
            "--output {}: a component of LinuxCNC has the name of its file, letters, digits "
            "and _ with .comp at the end: {}",
            output, (path.parent_path() / (name + ".comp")).string()),
        {.key = "--output"});
}

std::string exported(const ExportFlags& flags, const io::ControlPlan& plan) {
  const std::string name = name_of(flags.output);
  if (flags.format == "python") return io::control_python(plan);
  if (flags.format == "c") return io::control_c(plan, name);
  if (flags.format == "csv") return io::control_csv(plan);
  return io::control_linuxcnc(plan, name);
}

int run(const ExportFlags& flags) {
  const bool to_file = !flags.output.empty() && flags.output != "-";
  const auto if_exists = flags.force ? io::IfExists::replace : io::IfExists::refuse;
  if (to_file) io::require_writable(flags.output, if_exists);
  if (flags.format == "linuxcnc") require_component_name(flags.output, name_of(flags.output));
  const io::CorrectionFile file = session::open_corrections(messages(), flags.model);
  const io::ControlPlan plan = io::control_plan(file.models, file.source);
  const std::filesystem::path folder = std::filesystem::path(flags.model).parent_path();
  for (const io::ControlTable& t : plan.tables) add_input((folder / t.file).string());
  const std::string text = exported(flags, plan);
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
