#pragma once

#include <CLI/CLI.hpp>
#include <string>

#include "cli/csv_style.h"
#include "session/correction_run.h"
#include "text/output_file.h"

namespace raceway::cli {

/// `--learn`, `--every`, `--forget` and `--save` of `correct`.
struct LearnFlags {
  bool learn = false;
  session::LearningChoices choices;
  std::string save;

  /// Declares the flags.
  void declare(CLI::App& command);
  /// Checks the flags before anything is read. Throws text::InputError: a flag without --learn, a
  /// duration that is none, a file that cannot be written.
  void check(text::IfExists if_exists) const;
};

/// Destinations of the results of `correct`.
struct CorrectOutput {
  std::string csv{};  ///< file, "-" for stdout, empty for none
  CsvStyle style{};
  bool json = false;
  text::IfExists if_exists = text::IfExists::refuse;
};

/// All of `correct --learn` behind reading its files.
void run_learning(session::SeriesQuestion asked, const LearnFlags& flags,
                  const CorrectOutput& output);

}  // namespace raceway::cli
