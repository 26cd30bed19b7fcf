#pragma once

#include <CLI/CLI.hpp>
#include <string>
#include <string_view>
#include <vector>

#include "text/output_file.h"

namespace raceway::cli {

/// Form of the tables that a command writes: `--format csv`, `plain` or `excel`, `--separator` and
/// `--decimal-mark`.
///
/// The latter two have their header in the first line. The comments, with the model, go into a
/// second file: run.csv and run_comments.txt.
struct CsvStyle {
  std::string format = "csv", separator, decimal_mark;

  /// Declares the flags. `others`: further names that --format takes, with their `help`.
  void declare(CLI::App& command, const std::vector<std::string>& others = {},
               const std::string& help = {});
  /// Throws text::InputError for marks without --format excel, or two that are the same.
  void check() const;
  /// Throws text::InputError where put() would.
  void require_writable(const std::string& path, text::IfExists if_exists) const;
  /// Writes to stdout for "-", else to a file, and prints "run.csv written, WHAT". Does nothing for
  /// an empty name.
  void put(const std::string& path, const std::string& csv, text::IfExists if_exists,
           std::string_view what) const;

 private:
  [[nodiscard]] bool for_spreadsheet() const { return format == "excel"; }
  [[nodiscard]] bool has_comments_apart() const { return for_spreadsheet() || format == "plain"; }
};

}  // namespace raceway::cli
