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

/// One file that a command writes: `-o FILE` and `--force`.
struct OutputFlags {
  std::string output;
  bool force = false;
  std::string force_flag = "--force";  ///< `--replace` if `--force` gives a load

  /// Declares `-o`.
  CLI::Option* declare_output(CLI::App& command, const std::string& help);
  /// Declares `--force`.
  void declare_force(CLI::App& command, const std::string& help = "replace the file if it exists");
  /// Returns the action for an output file that already exists.
  [[nodiscard]] text::IfExists if_exists() const;
  [[nodiscard]] bool to_file() const { return !output.empty() && output != "-"; }
  /// Throws text::InputError if the file cannot be written. Call it before a long calculation.
  void require_writable() const;
  /// Throws text::InputError for `-o -`. `shows` names the output that the command prints to
  /// stdout.
  void refuse_stdout(const std::string& command, const std::string& shows) const;
  /// Writes a model and prints "my.toml written". File names in the model become relative to the
  /// folder of the new file. Does nothing if no output is given.
  void put_model(const std::string& text, const std::vector<files::NamedFile>& named) const;
  /// Writes the text, and prints "my.toml written" followed by `what`. Prints the text if no file
  /// is given.
  void put(const std::string& text, const std::string& what = {}) const;
};

/// Flags for the results of a command: a table (`-o FILE`, with the form in `csv`), a JSON
/// document, or a page. Without these flags, the command prints text.
struct ResultFlags : OutputFlags {
  CsvStyle csv;
  bool json = false;
  ReportFlag report;

  /// Declares `--format`, `--separator`, `--decimal-mark`, `--force`, `--json` and `--report`.
  /// --format also accepts the names in `forms`, and `help` describes them.
  void declare_results(CLI::App& command, const std::vector<std::string>& forms = {},
                       const std::string& help = {});
  /// Throws text::InputError if the table and the JSON document would both go to stdout, or if a
  /// file cannot be written.
  void check_results(const std::string& command) const;
  /// Writes the table if it was requested, and prints "run.csv written" followed by `what`.
  void put_table(const std::function<std::string()>& table, const std::string& what) const;
  /// Writes the page if it was requested.
  void put_page(const std::function<std::string()>& page) const { report.write(page, if_exists()); }
  /// Writes the page of an answer, prints its messages and returns the exit status.
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
