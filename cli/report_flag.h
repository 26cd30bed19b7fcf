#pragma once

#include <CLI/CLI.hpp>
#include <functional>
#include <string>

namespace raceway::cli {

/// `--report page.html` of a command: results as one page that opens in a browser.
struct ReportFlag {
  std::string path;

  /// Declares the flag.
  void declare(CLI::App& command);
  /// Refuses what could not be written, before the long calculation.
  void check(bool replace) const;
  /// Writes the page, if one was asked for, and says so.
  void write(const std::function<std::string()>& page, bool replace) const;
};

}  // namespace raceway::cli
