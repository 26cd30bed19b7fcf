#include "cli/output_flags.h"

#include <fmt/core.h>

#include "text/error.h"

namespace raceway::cli {

CLI::Option* OutputFlags::declare_output(CLI::App& command, const std::string& help) {
  return command.add_option("-o,--output", output, help)->type_name("FILE");
}

void OutputFlags::declare_force(CLI::App& command, const std::string& help) {
  command.add_flag(force_flag, force, help);
}

text::IfExists OutputFlags::if_exists() const {
  return !force && force_flag == "--replace" ? text::IfExists::refuse_naming_replace
                                             : on_existing(force);
}

void OutputFlags::require_writable() const {
  if (to_file()) text::require_writable(output, if_exists());
}

void OutputFlags::refuse_stdout(const std::string& command, const std::string& shows) const {
  if (output == "-")
    throw text::InputError(
        "raceway " + command + ": --output -: stdout shows " + shows + "; name a file",
        {.key = "--output"});
}

void OutputFlags::put(const std::string& text, const std::string& what) const {
  if (!to_file()) return fmt::print("{}", text);
  text::write_text(output, text, if_exists());
  say(output + " written" + what);
}

void OutputFlags::put_model(const std::string& text,
                            const std::vector<files::NamedFile>& named) const {
  if (!output.empty()) put(files::with_names_from(text, named, output));
}

void ResultFlags::declare_results(CLI::App& command, const std::vector<std::string>& forms,
                                  const std::string& help) {
  csv.declare(command, forms, help);
  declare_force(command, "replace files that exist");
  declare_json(command, json);
  report.declare(command);
}

void ResultFlags::check_results(const std::string& command) const {
  refuse_two_on_stdout(command, json, output);
  csv.require_writable(output, if_exists());
  report.check(if_exists());
}

void ResultFlags::put_table(const std::function<std::string()>& table,
                            const std::string& what) const {
  if (!output.empty()) csv.put(output, table(), if_exists(), what);
}

void refuse_two_on_stdout(const std::string& command, bool json, const std::string& output) {
  if (json && output == "-")
    throw text::InputError(
        "raceway " + command + ": both --json and \"--output -\" write to stdout; omit one of them",
        {.key = "--output"});
}

}  // namespace raceway::cli
