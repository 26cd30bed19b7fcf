#pragma once

#include <CLI/CLI.hpp>
#include <string>

#include "cli/csv_style.h"
#include "session/correction_run.h"
#include "text/output_file.h"

namespace raceway::cli {

/// Flags `--learn`, `--every`, `--forget` and `--save` of `correct`.
struct LearnFlags {
  bool learn = false;
  session::LearningChoices choices;
  std::string save;

  /// Declares the flags.
  void declare(CLI::App& command);
  /// Checks the flags before reading files. Throws text::InputError: a flag without --learn, an
  /// invalid duration, a file that cannot be written.
  void check(text::IfExists if_exists) const;
};

/// Destinations of the results of `correct`.
struct CorrectOutput {
  std::string csv{};  ///< file, "-" for stdout, empty for none
  CsvStyle style{};
  bool json = false;
  text::IfExists if_exists = text::IfExists::refuse;
};

/// Runs `correct --learn` after its files are read.
void run_learning(session::SeriesQuestion asked, const LearnFlags& flags,
                  const CorrectOutput& output);

}  // namespace raceway::cli
