#pragma once

#include <CLI/CLI.hpp>
#include <functional>
#include <string>

#include "cli/shared_flags.h"
#include "text/output_file.h"

namespace raceway::cli {

/// `--report page.html` of a command: results as one page that opens in a browser.
struct ReportFlag {
  std::string path;

  /// Declares the flag.
  void declare(CLI::App& command);
  /// Refuses what could not be written, before the long calculation.
  void check(text::IfExists if_exists) const;
  void check(bool replace) const { check(on_existing(replace)); }
  /// Writes the page, if one was asked for, and says so.
  void write(const std::function<std::string()>& page, text::IfExists if_exists) const;
  void write(const std::function<std::string()>& page, bool replace) const {
    write(page, on_existing(replace));
  }
};

}  // namespace raceway::cli
