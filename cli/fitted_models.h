#pragma once

#include <string>
#include <vector>

#include "cli/output_flags.h"
#include "session/loop.h"
#include "verdict/calibrate.h"

namespace raceway::cli {

/// Writes the model files of a fit: one file, or FILE-RECORD.toml for each record if parameters are
/// fitted separately for each record.
class FittedModels {
 public:
  /// If the command line has no --output (`flags.output` is empty), write() writes no file.
  explicit FittedModels(const OutputFlags& flags)
      : output_(flags.output), if_exists_(flags.if_exists()) {}

  /// Throws text::InputError if an output file cannot be written.
  void require_writable(const fit::Subject& subject) const;
  /// Returns the names of the output files that exist already, for messages; empty if none exists.
  [[nodiscard]] std::string existing(const fit::Subject& subject) const;
  /// Writes the fitted models and prints the name of each file.
  void write(const session::LoopQuestion& asked, const verdict::Calibration& calibration) const;
  /// Returns the file names for messages: "a.toml" or "a-monday.toml and a-friday.toml".
  [[nodiscard]] std::string names(const fit::Subject& subject) const;

 private:
  [[nodiscard]] std::vector<std::string> files(const fit::Subject& subject) const;

  std::string output_;
  text::IfExists if_exists_;
};

}  // namespace raceway::cli
