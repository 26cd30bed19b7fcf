#pragma once

#include <CLI/CLI.hpp>
#include <functional>
#include <string>

#include "text/output_file.h"

namespace raceway::cli {

/// Flag `--report page.html` of a command. With this flag, the command writes its results as one
/// page for a browser.
struct ReportFlag {
  std::string path;

  /// Declares the flag.
  void declare(CLI::App& command);
  /// Throws text::InputError if a page was requested and cannot be written, or if the program was
  /// built without reports. Call this function before a long calculation.
  void check(text::IfExists if_exists) const;
  /// Writes the page if it was requested, and prints "page.html written; ...".
  void write(const std::function<std::string()>& page, text::IfExists if_exists) const;
};

}  // namespace raceway::cli
