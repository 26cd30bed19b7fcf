#pragma once

#include <CLI/CLI.hpp>
#include <functional>
#include <string>
#include <vector>

#include "cli/commands.h"
#include "cli/csv_style.h"
#include "cli/messages.h"
#include "cli/report_flag.h"
#include "cli/shared_flags.h"
#include "files/named_files.h"
#include "text/output_file.h"

namespace raceway::cli {

/// Flags `-o FILE` and `--force` for one file that a command writes.
struct OutputFlags {
  std::string output;
  bool force = false;
  /// Name of the flag that permits the command to replace an existing file. The name is `--replace`
  /// in commands in which `--force` sets a load.
  std::string force_flag = "--force";

  /// Declares `-o`.
  CLI::Option* declare_output(CLI::App& command, const std::string& help);
  /// Declares `--force`.
  void declare_force(CLI::App& command, const std::string& help = "replace the file if it exists");
  /// Returns what to do if the output file already exists: replace it or throw an error.
  [[nodiscard]] text::IfExists if_exists() const;
  [[nodiscard]] bool to_file() const { return !output.empty() && output != "-"; }
  /// Throws text::InputError if the file cannot be written. Call this function before a long
  /// calculation.
  void require_writable() const;
  /// Throws text::InputError for `-o -`, because stdout is used for a different output of the
  /// command. `shows` names this different output.
  void refuse_stdout(const std::string& command, const std::string& shows) const;
  /// Writes a model to the file `output`, such as my.toml, and prints "my.toml written". File names
  /// in the model become relative to the folder of the written file. Does nothing without `-o`.
  void put_model(const std::string& text, const std::vector<files::NamedFile>& named) const;
  /// Writes the text to the file `output`, such as my.toml, and prints "my.toml written" and the
  /// text `what`. Without `-o`, prints the text.
  void put(const std::string& text, const std::string& what = {}) const;
};

/// Flags for the results of a command: a table (`-o FILE`), a JSON document (`--json`), or an HTML
/// page (`--report`). Without these flags, the command prints text.
struct ResultFlags : OutputFlags {
  CsvStyle csv;
  bool json = false;
  ReportFlag report;

  /// Declares `--format`, `--separator`, `--decimal-mark`, `--force`, `--json` and `--report`.
  /// The flag --format also accepts the names in the list `forms`, and `help` is the help text for
  /// these names.
  void declare_results(CLI::App& command, const std::vector<std::string>& forms = {},
                       const std::string& help = {});
  /// Throws text::InputError if the table and the JSON document would both go to stdout, or if a
  /// file cannot be written.
  void check_results(const std::string& command) const;
  /// Writes the table if it was requested, and prints "run.csv written" and the text `what`.
  void put_table(const std::function<std::string()>& table, const std::string& what) const;
  /// Writes the HTML page if it was requested.
  void put_page(const std::function<std::string()>& page) const { report.write(page, if_exists()); }
  /// Ends a command whose result is `found`: writes the HTML page if it was requested, prints notes
  /// and warnings, and returns the exit status of the program.
  template <typename Answer>
  int finish(const Answer& found) const {
    put_page([&] { return found.page(); });
    tell(found.notes());
    tell(found.warnings());
    return found.converged() ? done : not_converged;
  }
};

/// Throws text::InputError if the JSON document and a file would both go to stdout.
void refuse_two_on_stdout(const std::string& command, bool json, const std::string& output);

}  // namespace raceway::cli
