#pragma once

#include <CLI/CLI.hpp>
#include <string>
#include <string_view>
#include <vector>

#include "text/output_file.h"

namespace raceway::cli {

/// Format of the tables that a command writes. The flags are `--format` (csv, plain or excel),
/// `--separator` and `--decimal-mark`.
///
/// In the formats `plain` and `excel`, the first line is the header. In these two formats, the
/// command writes the comments and the text of the model to a second file, for example
/// run_comments.txt for run.csv. If the table goes to stdout, the comments and the text of the
/// model are omitted.
struct CsvStyle {
  std::string format = "csv", separator, decimal_mark;

  /// Declares the flags of this class for a command. `others` contains further formats that
  /// --format accepts, and `help` is the help text for these formats.
  void declare(CLI::App& command, const std::vector<std::string>& others = {},
               const std::string& help = {});
  /// Throws text::InputError for `--separator` or `--decimal-mark` without `--format excel`, and if
  /// the separator equals the decimal mark.
  void check() const;
  /// Throws text::InputError if put() cannot write its files.
  void require_writable(const std::string& path, text::IfExists if_exists) const;
  /// Writes to stdout if `path` is "-". Otherwise writes a file and prints "run.csv written"
  /// followed by `what`. Does nothing if `path` is empty.
  void put(const std::string& path, const std::string& csv, text::IfExists if_exists,
           std::string_view what) const;

 private:
  [[nodiscard]] bool for_spreadsheet() const { return format == "excel"; }
  [[nodiscard]] bool has_comments_apart() const { return for_spreadsheet() || format == "plain"; }
};

}  // namespace raceway::cli
