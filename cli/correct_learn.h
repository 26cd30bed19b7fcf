#pragma once

#include <CLI/CLI.hpp>
#include <string>

#include "cli/output_flags.h"
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
  /// Checks the flags before reading files. Throws text::InputError if --every, --forget or --save
  /// is given without --learn, if --every or --forget is not a valid duration, and if --save names
  /// a file that cannot be written.
  void check(text::IfExists if_exists) const;
};

/// Runs the command `correct --learn`. `asked` contains the correction and the record.
void run_learning(session::SeriesQuestion asked, const LearnFlags& flags,
                  const ResultFlags& results);

}  // namespace raceway::cli
